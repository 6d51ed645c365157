// The checks of tests/support must detect faulty bodies.
#include <gtest/gtest.h>

#include "tests/support/bodies.h"
#include "tests/support/body_checks.h"

namespace selvedge::sim {
namespace {

Body box() {
    return shapes::box(Vec3d::Zero(), Vec3d(1, 2, 3), 3);
}

TEST(BodyChecks, take_a_box) {
    EXPECT_TRUE(is_closed_manifold(box()));
    EXPECT_NEAR(volume(box()), 6, 1e-12);
}

TEST(BodyChecks, see_a_hole_a_turned_triangle_a_doubled_one_and_a_second_piece) {
    Body holed = box();
    holed.triangles.pop_back();
    EXPECT_FALSE(is_closed_manifold(holed));

    Body turned = box();
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    EXPECT_FALSE(is_closed_manifold(turned));

    Body doubled = box();
    doubled.triangles.push_back(doubled.triangles[4]);
    EXPECT_FALSE(is_closed_manifold(doubled));

    Body two = box();
    const int offset = static_cast<int>(two.x.size());
    for (const Vec3d& x : box().x) two.x.emplace_back(x + Vec3d(5, 0, 0));
    for (const auto& [a, b, c] : box().triangles) two.triangles.push_back({a + offset, b + offset, c + offset});
    EXPECT_FALSE(is_closed_manifold(two));
}

}  // namespace
}  // namespace selvedge::sim
