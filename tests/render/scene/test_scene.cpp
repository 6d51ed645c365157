#include "render/scene/scene.h"

#include <gtest/gtest.h>

namespace selvedge::render {
namespace {

sim::Body tetrahedron() {
    sim::Body body;
    body.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    body.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return body;
}

TEST(Scene, a_bodys_normals_are_unit_and_point_outward) {
    const BodyItem item = make_body_item(tetrahedron());
    ASSERT_EQ(item.normals.size(), 4U);
    const Vec3f centre(0.25F, 0.25F, 0.25F);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(item.normals[i].norm(), 1, 1e-6F);
        EXPECT_GT(item.normals[i].dot(item.x[i] - centre), 0);
    }
}

TEST(Scene, is_framed_with_cloth_and_bodies) {
    Scene scene;
    scene.bodies.push_back(make_body_item(tetrahedron()));
    ClothItem cloth;
    cloth.mesh.x = {{0, 3, 0}};
    scene.cloths.push_back(cloth);
    EXPECT_EQ(scene_points(scene).size(), 5U);
    EXPECT_GT(frame_scene(scene, View::Front, 1).eye.z(), 3);
}

TEST(Scene, studio_lights_stand_with_the_camera) {
    for (const View view : {View::Front, View::Back, View::Left}) {
        Scene scene;
        scene.bodies.push_back(make_body_item(tetrahedron()));
        const Camera camera = frame_scene(scene, view, 1);
        const Light light = studio_light(camera);
        EXPECT_GT(light.to_key.dot(camera.eye - camera.target), 0);
        EXPECT_GT(light.to_key.y(), 0);
        EXPECT_NEAR(light.to_key.norm(), 1, 1e-6F);
    }
}

TEST(Scene, show_modes_are_parsed_by_name) {
    EXPECT_EQ(parse_show_mode("level"), ShowMode::Level);
    EXPECT_EQ(parse_show_mode("edges"), ShowMode::Edges);
    EXPECT_FALSE(parse_show_mode("bones"));
}

}  // namespace
}  // namespace selvedge::render
