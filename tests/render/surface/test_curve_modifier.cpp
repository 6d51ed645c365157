#include "render/surface/curve_modifier.h"

#include <gtest/gtest.h>

#include <limits>

namespace selvedge {
namespace {

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
    EXPECT_NEAR(soft_cap(1.0001F, 1), 1.0001F, 1e-7);  // without a step
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
    EXPECT_EQ(restoring(0.8F, 1.1F), 0);  // stretched: nothing to restore
    EXPECT_FLOAT_EQ(restoring(1.1F, 1.1F), 1);
    EXPECT_EQ(restoring(1.2F, 1), kMostRestored);
    EXPECT_EQ(restoring(std::numeric_limits<float>::max(), 1.1F), kMostRestored);
}

}  // namespace
}  // namespace selvedge
