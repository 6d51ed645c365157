#include "sim/body/body_collider.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "sim/core/parallel.h"
#include "tests/sim/body/shapes.h"

namespace selvedge {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr double kRadius = 0.08;

Body ball() {
    return shapes::sphere({0.01, 0.9, -0.02}, kRadius, 24);
}
Vec3f ball_centre() {
    return {0.01F, 0.9F, -0.02F};
}

Vec3f random_direction(std::mt19937& random) {
    std::normal_distribution<float> normal;
    const float x = normal(random);
    const float y = normal(random);
    return Vec3f(x, y, normal(random)).normalized();
}

// Points up to `depth` under and `height` over the ball's surface.
std::vector<Vec3f> points_near_ball(int count, float depth, float height) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> along(-depth, height);
    std::vector<Vec3f> points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(ball_centre() + (float(kRadius) + along(random)) * random_direction(random));
    return points;
}

TEST(DistanceField, is_within_a_sixth_of_a_millimetre_near_a_smooth_surface) {
    const SurfaceBvh bvh(ball());
    const DistanceField field(bvh);
    std::vector<float> errors;
    for (const Vec3f& p : points_near_ball(5000, 0.011F, 0.011F)) {
        const float exact = bvh.closest(p, kFar)->distance;
        const FieldSample sample = field.sample(p);
        errors.push_back(std::abs(sample.distance - exact));
        if (std::abs(exact) > field.max_error()) {
            EXPECT_EQ(sample.distance < 0, exact < 0);
        }
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() * 99 / 100], 0.00015F);
    EXPECT_LT(errors.back(), 0.0003F);
}

TEST(DistanceField, its_gradient_is_the_way_out) {
    const DistanceField field{SurfaceBvh(ball())};
    for (const Vec3f& p : points_near_ball(2000, 0.011F, 0.011F)) {
        const FieldSample sample = field.sample(p);
        EXPECT_NEAR(sample.gradient.norm(), 1, 0.05);
        EXPECT_GT(sample.gradient.normalized().dot((p - ball_centre()).normalized()), 0.98F);
    }
}

TEST(DistanceField, knows_the_side_of_points_beyond_the_band) {
    const DistanceField field{SurfaceBvh(ball())};
    std::mt19937 random(3);
    for (int i = 0; i < 3000; ++i) {
        const Vec3f direction = random_direction(random);
        std::uniform_real_distribution<float> inner(0, float(kRadius) - 0.013F), outer(float(kRadius) + 0.013F, 0.6F);
        const FieldSample deep = field.sample(ball_centre() + inner(random) * direction);
        EXPECT_EQ(deep.distance, -field.band());
        EXPECT_EQ(deep.gradient, Vec3f::Zero());
        const FieldSample away = field.sample(ball_centre() + outer(random) * direction);
        EXPECT_EQ(away.distance, field.band());
        EXPECT_EQ(away.gradient, Vec3f::Zero());
    }
    EXPECT_EQ(field.sample(Vec3f::Constant(1e30F)).distance, field.band());
    EXPECT_EQ(field.sample(Vec3f::Constant(std::nanf(""))).distance, field.band());
}

TEST(DistanceField, tells_inside_from_outside_in_a_hollow_shell) {
    // The room in the shell is outside, though no way leads out of it.
    Body hollow = shapes::sphere(Vec3d::Zero(), 0.08, 20);
    for (auto& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
    const Body shell = shapes::together(shapes::sphere(Vec3d::Zero(), 0.15, 20), hollow);
    const DistanceField field{SurfaceBvh(shell)};
    EXPECT_EQ(field.sample({0, 0, 0}).distance, field.band());
    EXPECT_EQ(field.sample({0.115F, 0, 0}).distance, -field.band());
    EXPECT_EQ(field.sample({0.2F, 0, 0}).distance, field.band());
}

TEST(DistanceField, max_error_is_no_less_than_any_error_on_the_surface) {
    const SurfaceBvh bvh(shapes::box(Vec3d::Zero(), Vec3d(0.1, 0.2, 0.1), 5));
    const DistanceField field(bvh);
    EXPECT_GT(field.max_error(), 0.0002F);  // a box's edges are sharp
    EXPECT_LT(field.max_error(), 0.0026F);  // half the cell's diagonal bounds any distance field's error
    for (const Vec3f& p : bvh.points()) EXPECT_LE(std::abs(field.sample(p).distance), field.max_error());
}

TEST(DistanceField, is_sound_where_nodes_lie_in_a_face) {
    // They are at no distance at all, which once passed for nothing found. The box's height brings a layer of nodes
    // into its top, to the last bit for some of its depths.
    const DistanceFieldOptions options;
    const double margin = double(options.band + std::numbers::sqrt3_v<float> * options.cell);
    for (int i = 0; i < 40; ++i) {
        const Vec3d low(-0.04 - 0.001 * i, 1.4 - 0.0007 * i, -0.03);
        const double top = low.y() + 20 * double(options.cell) - margin;
        const SurfaceBvh bvh(shapes::box(low, {0.05, top, 0.03}, 1));
        EXPECT_LT(DistanceField(bvh, options).max_error(), 0.0026F);
    }
}

TEST(DistanceField, has_the_same_bits_for_any_number_of_threads) {
    const SurfaceBvh bvh(shapes::box(Vec3d::Zero(), Vec3d(0.1, 0.2, 0.1), 5));
    const auto sample_all = [&](int threads) {
        const ThreadLimit limit(threads);
        const DistanceField field(bvh);
        std::vector<float> values{field.max_error(), float(field.bytes())};
        std::mt19937 random(11);
        std::uniform_real_distribution<float> along(-0.05F, 0.25F);
        for (int i = 0; i < 5000; ++i) {
            const float x = along(random);
            const float y = along(random);
            values.push_back(field.sample({x, y, along(random)}).distance);
        }
        return values;
    };
    EXPECT_EQ(sample_all(1), sample_all(4));
}

TEST(DistanceField, of_an_empty_body_is_outside_everywhere) {
    const DistanceField field{SurfaceBvh(Body{})};
    EXPECT_EQ(field.sample({0, 0, 0}).distance, field.band());
}

TEST(BodyCollider, asks_the_exact_surface_at_edges_and_corners) {
    const Vec3d low = Vec3d::Zero();
    const Vec3d high(0.1, 0.1, 0.1);
    const Body body = shapes::box(low, high, 4);
    const BodyCollider collider(body);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> along(-0.002F, 0.004F);
    std::vector<double> errors;
    for (int i = 0; i < 2000; ++i) {
        const float x = along(random);
        const Vec3f p = Vec3f(0.1F + x, 0.1F + along(random), 0.05F);
        const Contact contact = collider.contact(p);
        errors.push_back(std::abs(contact.distance - shapes::box_distance(p.cast<double>(), low, high)));
        EXPECT_NEAR(contact.normal.norm(), 1, 1e-4);
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 0.0001);
    EXPECT_LT(errors.back(), collider.max_error());
}

TEST(BodyCollider, pushes_a_vertex_out_from_however_deep) {
    const Body body = ball();
    const BodyCollider collider(body);
    for (const Vec3f& p : points_near_ball(2000, 0.078F, 0.0F)) {
        const Contact contact = collider.contact(p);
        ASSERT_LT(contact.distance, collider.max_error());
        const Vec3f out = p + (0.003F - contact.distance) * contact.normal;
        EXPECT_NEAR((out - ball_centre()).norm(), kRadius + 0.003, 0.0006);
    }
}

TEST(BodyCollider, says_band_and_no_normal_far_away) {
    const Body body = ball();
    const BodyCollider collider(body);
    const Contact contact = collider.contact({1, 1, 1});
    EXPECT_EQ(contact.distance, collider.band());
    EXPECT_EQ(contact.normal, Vec3f::Zero());
}

}  // namespace
}  // namespace selvedge
