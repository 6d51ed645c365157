#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <vector>

#include "sim/core/passing_error.h"
#include "sim/repair/guarded_import.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
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

TEST(SceneBytes, are_refused_when_they_name_a_bone_that_is_not_there_though_it_has_no_weight) {
    ImportAnswer answer = some_answer();
    EXPECT_NO_THROW(scene_of(answer, "some.glb", ImportKind::Surface));
    answer.scene.meshes[1].skin[2].bones[3] = 2;
    EXPECT_THROW(scene_of(answer, "some.glb", ImportKind::Surface), InputError);
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
    int read = 0;
    for (int round = 0; round < 2000; ++round) {
        std::string bytes = sound;
        for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = char(random());
        if (const auto answer = from_bytes(bytes)) {
            EXPECT_LE(answer->scene.meshes.size(), bytes.size());
            ++read;
        }
    }
    EXPECT_GT(read, 100);
    EXPECT_LT(read, 1900) << "hardly any length was garbled";
}

TEST(GuardedImport, says_of_a_reader_that_wants_memory_that_this_may_pass) {
    const TemporaryFolder folder;
    {
        std::ofstream file(folder / "body.obj");
        for (int i = 0; i < 400'000; ++i) file << "v " << i << " 0 0\nv " << i << " 1 0\nv " << i << " 0 1\n";
        for (int i = 0; i < 400'000; ++i) file << "f " << 3 * i + 1 << " " << 3 * i + 2 << " " << 3 * i + 3 << "\n";
    }
    EXPECT_THROW(
        guarded_import(folder / "body.obj", ImportKind::Surface, {.child = {.memory_bytes = std::size_t(16) << 20}}),
        PassingError);
}

TEST(GuardedImport, of_polygons_that_take_long_to_cut_into_triangles_is_refused) {
    const TemporaryFolder folder;
    const auto problem_of = [&](int corners, int polygons) {
        {
            std::ofstream file(folder / "body.obj");
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * M_PI * i / corners;
                file << "v " << std::cos(angle) << ' ' << std::sin(angle) << " 0\n";
            }
            for (int k = 0; k < polygons; ++k) {
                file << 'f';
                for (int i = 1; i <= corners; ++i) file << ' ' << i;
                file << '\n';
            }
        }
        try {
            return std::to_string(guarded_import(folder / "body.obj").meshes.at(0).triangles.size()) + " triangles";
        } catch (const InputError& error) {
            return error.problem();
        }
    };
    EXPECT_EQ(problem_of(300, 2), "596 triangles");
    EXPECT_EQ(problem_of(1001, 1), "cannot be read: a polygon of 1001 corners: at most 1000");
    EXPECT_EQ(problem_of(1000, 11), "cannot be read: its polygons have too many corners: save it in triangles");
}

TEST(GuardedImport, says_of_a_reader_that_takes_too_long_that_this_may_pass) {
    const TemporaryFolder folder;
    std::ofstream(folder / "body.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_THROW(guarded_import(folder / "body.obj", ImportKind::Surface, {.child = {.wall_seconds = 0}}),
                 PassingError);
}

}  // namespace

}  // namespace selvedge::sim
