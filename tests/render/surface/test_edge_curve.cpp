#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/surface/edge_curve.h"

namespace selvedge::render {
namespace {

// An edge along x whose end normals lean outwards by `angle`: an arch.
CurveEnds arch(float angle, float r = 1) {
    const float s = std::sin(angle), c = std::cos(angle);
    return {.a = Vec4f(0, 0, 0, 0),
            .b = Vec4f(1, 0, 0, 0),
            .normal_a = Vec4f(-s, c, 0, 0),
            .normal_b = Vec4f(s, c, 0, 0),
            .rest_length = r};
}

float arc_length(const EdgeCurve& curve) {
    const CurveWeights weights(9);
    float length = 0;
    for (std::size_t i = 0; i < weights.steps(); ++i)
        length += (weights.point(curve, i + 1) - weights.point(curve, i)).norm();
    return length;
}

Vec4f bezier(const CurveEnds& ends, float t) {
    const Vec4f d = ends.b - ends.a;
    const Vec4f p1 = (2 * ends.a + ends.b - d.dot(ends.normal_a) * ends.normal_a) / 3;
    const Vec4f p2 = (ends.a + 2 * ends.b + d.dot(ends.normal_b) * ends.normal_b) / 3;
    const float s = 1 - t;
    return s * s * s * ends.a + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * ends.b;
}

TEST(CurveWeights, are_those_of_the_thesis_table_6_1) {
    const CurveWeights weights(3);
    const std::array<std::array<float, 4>, 5> table{{{1024, 0, 0, 0},
                                                     {455, 819, -315, 65},
                                                     {120, 1080, -216, 40},
                                                     {-35, 945, 135, -21},
                                                     {-64, 576, 576, -64}}};  // numerators over 1024
    for (std::size_t i = 0; i < table.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(weights.points(i)[static_cast<int>(k)], table[i][k] / 1024) << i << " " << k;
            EXPECT_EQ(weights.points(8 - i)[static_cast<int>(3 - k)], table[i][k] / 1024) << i << " " << k;
        }
    }
}

TEST(CurveWeights, sum_to_one_at_any_level) {
    for (const int level : {0, 1, 4, 7}) {
        const CurveWeights weights(level);
        EXPECT_EQ(weights.steps(), std::size_t{1} << level);
        for (std::size_t i = 0; i <= weights.steps(); ++i) EXPECT_NEAR(weights.points(i).sum(), 1, 1e-6F);
    }
}

TEST(EdgeCurve, unmodified_is_the_curve_of_a_pn_triangle) {
    CurveEnds ends = arch(0.5F);
    ends.normal_b = Vec4f(0.2F, 0.7F, 0.4F, 0).normalized();
    const EdgeCurve curve = make_edge_curve(ends, curve_modifier(SurfaceKind::Constant));
    const CurveWeights weights(4);
    for (std::size_t i = 0; i <= 16; ++i) {
        const float t = static_cast<float>(i) / 16;
        EXPECT_LT((weights.point(curve, i) - bezier(ends, t)).norm(), 1e-6F) << t;
    }
}

TEST(EdgeCurve, flat_is_its_chord_and_every_curve_starts_and_ends_at_the_ends) {
    const CurveWeights weights(3);
    for (int k = 0; k < kSurfaceKinds; ++k) {
        const CurveEnds ends = arch(0.4F, 1.08F);
        const EdgeCurve curve = make_edge_curve(ends, curve_modifier(static_cast<SurfaceKind>(k)));
        EXPECT_EQ(weights.point(curve, 0), ends.a);
        EXPECT_EQ(weights.point(curve, 8), ends.b);
        const float height = weights.point(curve, 4).y();
        if (static_cast<SurfaceKind>(k) == SurfaceKind::Flat) {
            EXPECT_EQ(height, 0);
        } else {
            EXPECT_GT(height, 0.05F);
        }
    }
}

TEST(EdgeCurve, the_shorter_an_edge_is_of_its_material_the_further_the_higher_powers_bend_it) {
    const CurveWeights weights(1);
    const auto height = [&](SurfaceKind kind, float r) {
        return weights.point(make_edge_curve(arch(0.3F, r), curve_modifier(kind)), 1).y();
    };
    EXPECT_EQ(height(SurfaceKind::Constant, 1.2F), height(SurfaceKind::Constant, 0.9F));
    EXPECT_LT(height(SurfaceKind::Linear, 1.2F), height(SurfaceKind::Quadratic, 1.2F));
    EXPECT_LT(height(SurfaceKind::Quadratic, 1.2F), height(SurfaceKind::Cubic, 1.2F));
    EXPECT_GT(height(SurfaceKind::Linear, 0.9F), height(SurfaceKind::Cubic, 0.9F));
}

TEST(EdgeCurve, arc_over_chord_is_that_of_the_curve) {
    for (const float degrees : {0.0F, 5.0F, 20.0F, 45.0F}) {
        const CurveEnds ends = arch(degrees * std::numbers::pi_v<float> / 180);
        const Vec4f d = ends.b - ends.a;
        const float arc =
            arc_over_chord(d, -d.dot(ends.normal_a) * ends.normal_a, d.dot(ends.normal_b) * ends.normal_b);
        EXPECT_NEAR(arc, arc_length(make_edge_curve(ends, curve_modifier(SurfaceKind::Constant))), 2e-3F) << degrees;
    }
}

TEST(EdgeCurve, quadratic_restores_too_little_of_a_30_degree_arch_a_quarter_short) {
    const EdgeCurve curve =
        make_edge_curve(arch(std::numbers::pi_v<float> / 6, 1.25F), {.k = {0, 0, 1, 0}, .soft_cap = 1});
    EXPECT_NEAR(arc_length(curve), 1.063F, 0.005F);
}

TEST(EdgeCurve, restoring_makes_the_curve_as_long_as_the_material) {
    for (float degrees = 10; degrees <= 45; degrees += 5) {
        for (float r = 1; r <= 1.1F; r += 0.02F) {
            const CurveEnds ends = arch(degrees * std::numbers::pi_v<float> / 180, r);
            const float length = arc_length(make_edge_curve(ends, curve_modifier(SurfaceKind::Restore)));
            EXPECT_NEAR(length, r, 0.015F) << degrees << " degrees, r " << r;
        }
    }
}

TEST(EdgeCurve, in_the_middle_of_an_arch_the_normal_stands_straight_up) {
    const EdgeCurve curve = make_edge_curve(arch(0.4F), {});
    const Vec4f middle = CurveWeights(1).normal(curve, 1);
    EXPECT_NEAR(middle.y(), 1, 1e-6F);
    EXPECT_NEAR(middle.norm(), 1, 1e-6F);
}

TEST(EdgeCurve, an_edge_without_length_is_a_point) {
    CurveEnds ends = arch(0.4F);
    ends.b = ends.a;
    for (int k = 0; k < kSurfaceKinds; ++k) {
        const EdgeCurve curve = make_edge_curve(ends, curve_modifier(static_cast<SurfaceKind>(k)));
        const CurveWeights weights(3);
        EXPECT_TRUE(weights.point(curve, 3).isZero());
        EXPECT_NEAR(weights.normal(curve, 3).norm(), 1, 1e-6F);
    }
}

TEST(CurveModifier, presets_are_those_of_the_thesis) {
    EXPECT_EQ(curve_modifier(SurfaceKind::Flat).k, (std::array<float, 4>{0, 0, 0, 0}));
    EXPECT_EQ(curve_modifier(SurfaceKind::Constant).k, (std::array<float, 4>{1, 0, 0, 0}));
    EXPECT_EQ(curve_modifier(SurfaceKind::Linear).k, (std::array<float, 4>{0, 1, 0, 0}));
    EXPECT_EQ(curve_modifier(SurfaceKind::Quadratic).k, (std::array<float, 4>{0, 0, 1, 0}));
    EXPECT_EQ(curve_modifier(SurfaceKind::Cubic).k, (std::array<float, 4>{0, 0, 0, 1}));
    EXPECT_TRUE(curve_modifier(SurfaceKind::Restore).restores_length);
}

TEST(CurveModifier, every_kind_is_found_by_its_name) {
    for (int i = 0; i < kSurfaceKinds; ++i) {
        const auto kind = static_cast<SurfaceKind>(i);
        EXPECT_EQ(parse_surface_kind(name(kind)), kind);
    }
    EXPECT_FALSE(parse_surface_kind("wavy"));
    EXPECT_FALSE(parse_surface_kind(""));
}

TEST(CurveModifier, soft_cap_leaves_what_is_below_it_and_slows_what_is_above) {
    EXPECT_EQ(soft_cap(0.7F, 1), 0.7F);
    EXPECT_EQ(soft_cap(1, 1), 1);
    EXPECT_FLOAT_EQ(soft_cap(1.5F, 1), 1 + 0.5F / 1.5F);
    EXPECT_FLOAT_EQ(soft_cap(6, 2), 2 + 4.0F / 6);
    EXPECT_LT(soft_cap(1e6F, 1), 2);
    EXPECT_NEAR(soft_cap(1.0001F, 1), 1.0001F, 1e-7);  // continuous at the cap
}

TEST(CurveModifier, is_the_capped_cubic_of_the_ratio_of_lengths) {
    const CurveModifier modifier{.k = {0.1F, 0.2F, 0.3F, 0.4F}, .soft_cap = 10};
    const float r = 1.3F;
    EXPECT_FLOAT_EQ(modified(modifier, r), 0.1F + 0.2F * r + 0.3F * r * r + 0.4F * r * r * r);
    EXPECT_FLOAT_EQ(modified(curve_modifier(SurfaceKind::Quadratic), 0.9F), 0.81F);
    EXPECT_FLOAT_EQ(modified(curve_modifier(SurfaceKind::Quadratic), 1.2F), 1 + 0.44F / 1.44F);
    EXPECT_EQ(modified(curve_modifier(SurfaceKind::Flat), 1.5F), 0);
}

TEST(CurveModifier, restoring_is_bounded_and_finite_wherever_lengths_are) {
    EXPECT_EQ(restoring(1, 1.1F), 0);
    EXPECT_EQ(restoring(0.8F, 1.1F), 0);  // stretched: no length to restore
    EXPECT_FLOAT_EQ(restoring(1.1F, 1.1F), 1);
    EXPECT_EQ(restoring(1.2F, 1), kMaxRestored);
    EXPECT_EQ(restoring(std::numeric_limits<float>::max(), 1.1F), kMaxRestored);
}

}  // namespace

}  // namespace selvedge::render
