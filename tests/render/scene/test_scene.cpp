#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "render/scene/colour.h"
#include "render/scene/scene.h"

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

namespace {

// The colour as seen without green-sensitive cones (Machado, Oliveira and Fernandes 2009, severity 1).
sim::Rgb8 as_deuteranope(const sim::Rgb8& colour) {
    const auto linear = [](std::uint8_t byte) {
        const double s = byte / 255.0;
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    const auto byte = [](double x) {
        const double c = std::clamp(x, 0.0, 1.0);
        const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
        return static_cast<std::uint8_t>(std::lround(255 * s));
    };
    const double r = linear(colour[0]), g = linear(colour[1]), b = linear(colour[2]);
    return {byte(0.367322 * r + 0.860646 * g - 0.227968 * b), byte(0.280085 * r + 0.672501 * g + 0.047413 * b),
            byte(-0.011820 * r + 0.042940 * g + 0.968881 * b)};
}

// Ratio of the longest to the shortest of the map's steps of one eighth.
float unevenness(const std::vector<sim::Rgb8>& map) {
    float least = 1e9F, most = 0;
    const std::size_t step = (map.size() - 1) / 8;
    for (std::size_t i = 0; i + step < map.size(); i += step) {
        const float length = (to_oklab(map[i + step]) - to_oklab(map[i])).norm();
        least = std::min(least, length);
        most = std::max(most, length);
    }
    return most / least;
}

TEST(ColourMap, oklab_goes_there_and_back) {
    for (const sim::Rgb8 colour :
         {sim::Rgb8{0, 0, 0}, sim::Rgb8{255, 255, 255}, sim::Rgb8{12, 200, 99}, sim::Rgb8{250, 3, 40}})
        EXPECT_EQ(from_oklab(to_oklab(colour)), colour);
    EXPECT_NEAR(to_oklab({255, 255, 255})[0], 1, 1e-4);
}

TEST(ColourMap, equal_steps_of_a_map_look_equal) {
    EXPECT_LT(unevenness(diverging_map()), 1.25F);
    EXPECT_LT(unevenness(sequential_map()), 1.25F);
}

TEST(ColourMap, the_diverging_map_is_lightest_in_its_neutral_middle_and_darkens_evenly_to_both_ends) {
    const std::vector<sim::Rgb8> map = diverging_map();
    ASSERT_EQ(map.size(), kMapColours);
    const std::size_t middle = map.size() / 2;
    const Vec3f neutral = to_oklab(map[middle]);
    EXPECT_LT(std::hypot(neutral[1], neutral[2]), 0.012F);
    for (std::size_t i = 8; i <= middle; i += 8) {
        EXPECT_GT(to_oklab(map[i])[0], to_oklab(map[i - 8])[0]) << i;
        EXPECT_LT(to_oklab(map[map.size() - 1 - (i - 8)])[0], to_oklab(map[map.size() - 1 - i])[0]) << i;
    }
    EXPECT_NEAR(to_oklab(map.front())[0], to_oklab(map.back())[0], 0.06F) << "neither side weighs more";
}

TEST(ColourMap, the_sequential_map_brightens_all_the_way) {
    const std::vector<sim::Rgb8> map = sequential_map();
    for (std::size_t i = 8; i < map.size(); i += 8)
        EXPECT_GT(to_oklab(map[i])[0], to_oklab(map[i - 8])[0] + 0.005F) << i;
}

TEST(ColourMap, who_confuses_red_and_green_tells_compression_from_extension) {
    const std::vector<sim::Rgb8> map = diverging_map();
    for (const std::size_t off : {32U, 64U, 128U}) {
        const Vec3f low = to_oklab(as_deuteranope(map[128 - off])), high = to_oklab(as_deuteranope(map[128 + off]));
        EXPECT_GT((high - low).norm(), 0.1F) << off;
    }
}

TEST(ColourMap, the_first_dozen_of_kinds_are_told_apart_by_everyone) {
    for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT((to_oklab(kind_colour(i)) - to_oklab(kind_colour(j))).norm(), 0.03F) << i << " and " << j;
            EXPECT_GT((to_oklab(line_colour(i)) - to_oklab(line_colour(j))).norm(), 0.05F) << i << " and " << j;
        }
    }
    for (std::size_t i = 1; i < 6; ++i) {
        const Vec3f a = to_oklab(as_deuteranope(kind_colour(i))), b = to_oklab(as_deuteranope(kind_colour(i - 1)));
        EXPECT_GT((a - b).norm(), 0.05F) << i;
    }
}

}  // namespace

}  // namespace selvedge::render
