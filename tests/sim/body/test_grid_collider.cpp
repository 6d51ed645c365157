#include "sim/body/grid_collider.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "sim/core/simd_level.h"
#include "tests/sim/body/shapes.h"

namespace selvedge {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kReach = 0.01F;

Body figure() {
    return shapes::together(shapes::sphere({0.05, 0.3, 0.05}, 0.06, 12), shapes::box({0, 0, 0}, {0.1, 0.2, 0.08}, 9));
}

std::vector<Vec3f> points_about_figure() {
    std::mt19937 random(23);
    std::uniform_real_distribution<float> wide(-0.03F, 0.13F), tall(-0.03F, 0.4F);
    std::vector<Vec3f> points;
    for (int i = 0; i < 20000; ++i) {
        const float x = wide(random);
        const float y = tall(random);
        points.emplace_back(x, y, wide(random));
    }
    return points;
}

// Within the reach what the tree says, beyond it the reach.
void expect_the_surface(const Collider& collider, const SurfaceBvh& surface) {
    int near = 0;
    for (const Vec3f& p : points_about_figure()) {
        const Contact contact = collider.contact(p);
        const ClosestPoint exact = *surface.closest(p, kFar);
        if (std::abs(exact.distance) >= kReach) {
            EXPECT_EQ(contact.distance, collider.band());
            EXPECT_EQ(contact.normal, Vec3f::Zero());
            continue;
        }
        ++near;
        EXPECT_NEAR(std::abs(contact.distance), std::abs(exact.distance), 1e-6F);
        if (std::abs(exact.distance) > 1e-5F) {
            EXPECT_EQ(contact.distance < 0, exact.distance < 0);
        }
        EXPECT_NEAR(contact.normal.norm(), 1, 1e-4);
    }
    EXPECT_GT(near, 3000);
}

TEST(GridCollider, knows_the_surface_as_far_as_its_reach) {
    const SurfaceBvh surface(figure());
    expect_the_surface(GridCollider(surface, kReach), surface);
}

TEST(GridCollider, of_a_flat_or_an_empty_body_touches_what_there_is) {
    Body flat;
    flat.x = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    flat.triangles = {{0, 2, 1}};
    const SurfaceBvh surface(flat);
    EXPECT_NEAR(GridCollider(surface, kReach).contact({0.2F, 0.005F, 0.2F}).distance, 0.005F, 1e-6F);
    EXPECT_NEAR(GridCollider(surface, kReach).contact({-0.004F, 0, -0.003F}).distance, 0.005F, 1e-6F);
    const SurfaceBvh nothing{Body{}};
    EXPECT_EQ(GridCollider(nothing, kReach).contact({0, 0, 0}).distance, kReach);
}

TEST(BvhCollider, knows_the_surface_as_far_as_its_reach) {
    const SurfaceBvh surface(figure());
    expect_the_surface(BvhCollider(surface, kReach), surface);
}

TEST(SurfaceBvh, has_the_same_bits_at_every_simd_level) {
    const SurfaceBvh fastest(figure());
    const SimdLimit limit(SimdLevel::Plain);
    const SurfaceBvh plain(figure());
    for (const Vec3f& p : points_about_figure()) {
        const ClosestPoint a = *fastest.closest(p, kFar);
        const ClosestPoint b = *plain.closest(p, kFar);
        ASSERT_EQ(a.triangle, b.triangle);
        ASSERT_EQ(a.distance, b.distance);
    }
}

}  // namespace
}  // namespace selvedge
