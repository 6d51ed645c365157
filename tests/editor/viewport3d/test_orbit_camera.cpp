#include <gtest/gtest.h>

#include "editor/viewport3d/orbit_camera.h"

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

}  // namespace selvedge::editor
