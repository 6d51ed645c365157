#include <gtest/gtest.h>

#include "editor/viewport3d/pick.h"

namespace selvedge::editor {
namespace {

// A square of 1 m in z = 0, seen from +z.
const std::vector<Vec3f> kQuad{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const TriangleList kTriangles{{{0, 1, 2}}, {{0, 2, 3}}};
const Viewing kFromFront{{.eye = {0.5F, 0.5F, 4}, .target = {0.5F, 0.5F, 0}}, {400, 400}};

TEST(RayPick, finds_the_triangle_and_the_place_in_it) {
    const auto hit = nearest_hit({{0.75F, 0.25F, 2}, {0, 0, -1}}, kQuad, kTriangles);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->triangle, 0U);
    EXPECT_FLOAT_EQ(hit->distance, 2);
    const Vec3f at = hit->weights[0] * kQuad[0] + hit->weights[1] * kQuad[1] + hit->weights[2] * kQuad[2];
    EXPECT_NEAR((at - Vec3f(0.75F, 0.25F, 0)).norm(), 0, 1e-6F);
}

TEST(RayPick, finds_the_other_triangle_from_behind) {
    const auto hit = nearest_hit({{0.25F, 0.75F, -3}, {0, 0, 1}}, kQuad, kTriangles);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->triangle, 1U);
    EXPECT_FLOAT_EQ(hit->distance, 3);
}

TEST(RayPick, finds_nothing_outside_nor_behind_the_eye) {
    EXPECT_FALSE(nearest_hit({{1.01F, 0.5F, 2}, {0, 0, -1}}, kQuad, kTriangles));
    EXPECT_FALSE(nearest_hit({{0.5F, 0.5F, 2}, {0, 0, 1}}, kQuad, kTriangles));
    EXPECT_FALSE(nearest_hit({{0.5F, 0.5F, 2}, {0, 0, -1}}, kQuad, {}));
}

TEST(RayPick, takes_the_nearer_of_two_sheets) {
    std::vector<Vec3f> x = kQuad;
    for (const Vec3f& point : kQuad) x.push_back(point + Vec3f(0, 0, 0.5F));
    TriangleList triangles = kTriangles;
    for (const auto& [a, b, c] : kTriangles) triangles.push_back({a + 4, b + 4, c + 4});
    const auto hit = nearest_hit({{0.75F, 0.25F, 2}, {0, 0, -1}}, x, triangles);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->triangle, 2U);
}

TEST(RayPick, a_ray_goes_through_the_pixel_that_a_point_is_seen_at) {
    const Vec3f point(0.9F, 0.2F, -0.3F);
    const auto px = px_of(kFromFront, point);
    ASSERT_TRUE(px.has_value());
    const Ray ray = ray_through(kFromFront, *px);
    EXPECT_NEAR((point - ray.origin).cross(ray.direction).norm(), 0, 1e-5F);
    EXPECT_FALSE(px_of(kFromFront, {0.5F, 0.5F, 5})) << "behind the eye";
}

TEST(RayPick, measures_how_near_a_line_is_on_the_screen) {
    const Vec2f middle(200, 200);
    const auto upright = distance_to_path(kFromFront, middle, {{0.6F, -1, 0}, {0.6F, 2, 0}});
    ASSERT_TRUE(upright.has_value());
    EXPECT_NEAR(upright->px, 0.1F / metres_per_px(kFromFront, {0.6F, 0.5F, 0}), 0.1F);
    EXPECT_NEAR(upright->depth, 4, 1e-4F);
    EXPECT_FALSE(distance_to_path(kFromFront, middle, {{0, 0, 6}, {1, 0, 6}}));
}

}  // namespace

}  // namespace selvedge::editor
