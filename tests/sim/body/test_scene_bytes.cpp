#include "sim/body/scene_bytes.h"

#include <gtest/gtest.h>

#include <random>

namespace selvedge {
namespace {

ImportAnswer some_answer() {
    ImportedMesh mesh;
    mesh.name = "shirt";
    mesh.material = "linen";
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.u = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.skin.resize(3);
    ImportAnswer answer;
    answer.scene.meshes = {mesh, mesh};
    answer.scene.bones = {{"hips", -1, {0, 1, 0}}, {"spine", 0, {0, 1.2, 0}}};
    return answer;
}

TEST(SceneBytes, come_back_as_they_went) {
    const auto back = from_bytes(to_bytes(some_answer()));
    ASSERT_TRUE(back);
    ASSERT_EQ(back->scene.meshes.size(), 2U);
    EXPECT_EQ(back->scene.meshes[1].name, "shirt");
    EXPECT_EQ(back->scene.meshes[1].x, some_answer().scene.meshes[1].x);
    EXPECT_EQ(back->scene.meshes[1].u, some_answer().scene.meshes[1].u);
    EXPECT_EQ(back->scene.meshes[1].triangles, some_answer().scene.meshes[1].triangles);
    ASSERT_EQ(back->scene.bones.size(), 2U);
    EXPECT_EQ(back->scene.bones[1].name, "spine");
    EXPECT_EQ(back->scene.bones[1].parent, 0);
    EXPECT_EQ(back->scene.bones[1].joint, Vec3d(0, 1.2, 0));
}

TEST(SceneBytes, are_refused_when_cut_anywhere_or_followed_by_more) {
    const std::string bytes = to_bytes(some_answer());
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(from_bytes(std::string_view(bytes).substr(0, length))) << length;
    EXPECT_FALSE(from_bytes(bytes + "x"));
}

TEST(SceneBytes, with_any_lengths_garbled_are_read_without_harm) {
    std::mt19937 random(3);
    const std::string sound = to_bytes(some_answer());
    for (int round = 0; round < 2000; ++round) {
        std::string bytes = sound;
        for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = char(random());
        if (const auto answer = from_bytes(bytes)) {
            EXPECT_LE(answer->scene.meshes.size(), bytes.size());
        }
    }
}

}  // namespace
}  // namespace selvedge
