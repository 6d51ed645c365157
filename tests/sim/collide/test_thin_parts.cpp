// The thin parts of a body are found, and nothing else is.
#include "sim/collide/thin_parts.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

Eigen::AlignedBox3f cube(const Vec3f& centre, float half) {
    return {centre - Vec3f::Constant(half), centre + Vec3f::Constant(half)};
}

TEST(ThinParts, are_fingers_but_not_arms) {
    const Body arm = shapes::sphere(Vec3d(0, 0, 0), 0.03, 16);
    const Body fingers = shapes::together(shapes::box(Vec3d(0.2, 0, 0), Vec3d(0.214, 0.07, 0.014), 16),
                                          shapes::box(Vec3d(0.3, 0, 0), Vec3d(0.314, 0.07, 0.014), 16));
    const SurfaceBvh surface(shapes::together(arm, fingers));
    const std::vector<ThinPart> parts = find_thin_parts(surface, DistanceField(surface));
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_TRUE(is_near(parts, cube(Vec3f(0.207F, 0.08F, 0.007F), 0.015F)));
    EXPECT_TRUE(is_near(parts, cube(Vec3f(0.307F, 0.03F, 0.007F), 0.001F)));
    EXPECT_FALSE(is_near(parts, cube(Vec3f(0.257F, 0.03F, 0.007F), 0.02F))) << "between the fingers";
    EXPECT_FALSE(is_near(parts, cube(Vec3f(0, 0, 0), 0.05F)));
}

TEST(ThinParts, of_a_body_that_moves_are_hands_but_not_arms_and_move_along) {
    const Body arm = shapes::sphere(Vec3d(0, 0, 0), 0.03, 16);
    const SurfaceBvh surface(shapes::together(arm, shapes::box(Vec3d(0.2, 0, 0), Vec3d(0.28, 0.1, 0.025), 16)));
    std::vector<Vec3f> to(surface.points().begin(), surface.points().end());
    for (Vec3f& x : to) x.y() += 0.5F;
    const std::vector<ThinPart> parts = MovingThinParts(surface).between(surface.points(), to);
    ASSERT_EQ(parts.size(), 1U);
    for (const float y : {0.05F, 0.3F, 0.55F}) EXPECT_TRUE(is_near(parts, cube(Vec3f(0.24F, y, 0), 0.001F))) << y;
    EXPECT_FALSE(is_near(parts, cube(Vec3f(0, 0, 0), 0.05F)));
    EXPECT_FALSE(is_near(parts, cube(Vec3f(0.24F, 0.7F, 0), 0.05F)));
}

TEST(ThinParts, are_boxes_round_the_surface_and_not_round_what_it_spans) {
    Body bent = shapes::box(Vec3d(0, 0, 0), Vec3d(0.2, 0.2, 0.01), 40);
    for (Vec3d& x : bent.x) x.z() += 5 * x.x() * x.x();  // 0.2 m deep
    const SurfaceBvh surface(bent);
    const std::vector<ThinPart> parts = find_thin_parts(surface, DistanceField(surface));
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_TRUE(parts[0].box.contains(Vec3f(0.15F, 0.1F, 0.03F)));
    EXPECT_FALSE(is_near(parts, cube(Vec3f(0.15F, 0.1F, 0.03F), 0.01F)));
    EXPECT_TRUE(is_near(parts, cube(Vec3f(0.19F, 0.1F, 0.19F), 0.01F)));
}

}  // namespace
}  // namespace selvedge::sim::test
