#include <gtest/gtest.h>

#include "editor/viewport3d/orbit_camera.h"
#include "editor/viewport3d/pick.h"

namespace selvedge::editor {
namespace {

const Vec2f kSize(800, 600);

float eye_distance(const OrbitCamera& orbit) {
    const render::Camera camera = orbit.camera();
    return (camera.eye - camera.target).norm();
}

void let_it_arrive(OrbitCamera& orbit) {
    for (int i = 0; i < 100 && orbit.is_moving(); ++i) orbit.advance(0.016F);
    EXPECT_FALSE(orbit.is_moving());
}

TEST(OrbitCamera, orbiting_keeps_the_distance_and_what_is_looked_at) {
    OrbitCamera orbit;
    const float before = eye_distance(orbit);
    const Vec3f target = orbit.camera().target;
    orbit.orbit({137, -45});
    EXPECT_NEAR(eye_distance(orbit), before, 1e-4F);
    EXPECT_EQ(orbit.camera().target, target);
    EXPECT_GT((OrbitCamera().camera().eye - orbit.camera().eye).norm(), 1);
}

TEST(OrbitCamera, orbiting_never_passes_the_poles) {
    OrbitCamera orbit;
    orbit.orbit({0, 5000});
    EXPECT_GT(orbit.camera().eye.y(), 5);
    EXPECT_GT(orbit.camera().up.z(), -1.001F);
    EXPECT_LT(orbit.camera().up.dot(Vec3f::UnitY()), 0.01F);
    EXPECT_GE(orbit.camera().up.dot(Vec3f::UnitY()), 0.0F) << "never upside down";
    orbit.orbit({0, -20000});
    EXPECT_LT(orbit.camera().eye.y(), -3);
    EXPECT_GE(orbit.camera().up.dot(Vec3f::UnitY()), 0.0F);
}

TEST(OrbitCamera, zooming_keeps_the_point_under_the_cursor) {
    for (const bool is_long : {false, true}) {
        OrbitCamera orbit;
        if (is_long) orbit.change_lens();
        const Vec2f cursor(150, 480);
        const Viewing before{orbit.camera(), kSize};
        const Vec3f point = ray_through(before, cursor).at(0.9F * depth_of(before, before.camera.target));
        orbit.zoom(4, point);
        const Viewing after{orbit.camera(), kSize};
        const auto px = px_of(after, point);
        ASSERT_TRUE(px.has_value());
        EXPECT_NEAR((*px - cursor).norm(), 0, 0.3F) << (is_long ? "long lens" : "usual lens");
        EXPECT_LT(depth_of(after, after.camera.target), 0.7F * depth_of(before, before.camera.target));
    }
}

TEST(OrbitCamera, panning_moves_the_target_with_the_cursor) {
    OrbitCamera orbit;
    const Vec3f target = orbit.camera().target;
    orbit.pan({60, -25}, kSize);
    const auto px = px_of({orbit.camera(), kSize}, target);
    ASSERT_TRUE(px.has_value());
    EXPECT_NEAR(px->x(), 460, 0.5F);
    EXPECT_NEAR(px->y(), 275, 0.5F);
}

TEST(OrbitCamera, moves_to_a_view_smoothly_by_the_short_way_and_arrives_exactly) {
    OrbitCamera orbit;
    orbit.look_from(StandardView::Right);
    let_it_arrive(orbit);
    EXPECT_LT(orbit.camera().eye.x(), -4) << "+x is the body's left";
    orbit.look_from(StandardView::Back);
    orbit.advance(0.12F);
    EXPECT_TRUE(orbit.is_moving());
    EXPECT_LT(orbit.camera().eye.x(), -1) << "not round by the front";
    EXPECT_LT(orbit.camera().eye.z(), -1);
    let_it_arrive(orbit);
    EXPECT_NEAR(orbit.camera().eye.x(), 0, 1e-3F);
    EXPECT_NEAR(orbit.camera().eye.z(), -5.2F, 1e-3F);
}

TEST(OrbitCamera, the_opposite_of_the_front_is_the_back) {
    OrbitCamera orbit;
    orbit.look_from(StandardView::Front);
    orbit.turn_opposite();
    let_it_arrive(orbit);
    EXPECT_NEAR(orbit.camera().eye.z(), -5.2F, 1e-3F);
    EXPECT_NEAR(orbit.camera().eye.x(), 0, 1e-3F);
}

TEST(OrbitCamera, framing_brings_all_points_into_view) {
    OrbitCamera orbit;
    orbit.pan({3000, 100}, kSize);
    const std::vector<Vec3f> points{{-0.4F, 0, 0.2F}, {0.5F, 1.8F, -0.1F}, {0.1F, 0.3F, 0.6F}};
    orbit.frame(points, kSize.x() / kSize.y());
    let_it_arrive(orbit);
    for (const Vec3f& point : points) {
        const auto px = px_of({orbit.camera(), kSize}, point);
        ASSERT_TRUE(px.has_value());
        EXPECT_TRUE((px->array() > 0).all() && (px->array() < kSize.array()).all()) << px->transpose();
    }
}

TEST(OrbitCamera, the_long_lens_shows_the_target_at_the_same_size) {
    OrbitCamera orbit;
    const Vec3f beside = orbit.camera().target + Vec3f(0, 0.5F, 0);
    const auto usual = px_of({orbit.camera(), kSize}, beside);
    orbit.change_lens();
    const auto from_afar = px_of({orbit.camera(), kSize}, beside);
    ASSERT_TRUE(usual && from_afar);
    EXPECT_NEAR((*usual - *from_afar).norm(), 0, 3);
    EXPECT_GT(eye_distance(orbit), 50);
}

}  // namespace

namespace {

// A square of 1 m in z = 0, seen from +z.
const std::vector<Vec3f> kQuad{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const TriangleList kTriangles{{{0, 1, 2}}, {{0, 2, 3}}};
const Viewing kFacingQuad{{.eye = {0.5F, 0.5F, 4}, .target = {0.5F, 0.5F, 0}}, {400, 400}};

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
    const auto px = px_of(kFacingQuad, point);
    ASSERT_TRUE(px.has_value());
    const Ray ray = ray_through(kFacingQuad, *px);
    EXPECT_NEAR((point - ray.origin).cross(ray.direction).norm(), 0, 1e-5F);
    EXPECT_FALSE(px_of(kFacingQuad, {0.5F, 0.5F, 5})) << "behind the eye";
}

TEST(RayPick, measures_how_near_a_line_is_on_the_screen) {
    const Vec2f middle(200, 200);
    const auto upright = distance_to_path(kFacingQuad, middle, {{0.6F, -1, 0}, {0.6F, 2, 0}});
    ASSERT_TRUE(upright.has_value());
    EXPECT_NEAR(upright->px, 0.1F / metres_per_px(kFacingQuad, {0.6F, 0.5F, 0}), 0.1F);
    EXPECT_NEAR(upright->depth, 4, 1e-4F);
    EXPECT_FALSE(distance_to_path(kFacingQuad, middle, {{0, 0, 6}, {1, 0, 6}}));
}

}  // namespace

}  // namespace selvedge::editor
