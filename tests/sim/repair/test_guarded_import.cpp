#include <gtest/gtest.h>
#include <unistd.h>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "sim/core/parallel.h"
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

TEST(ChildProcess, brings_home_what_the_work_returns) {
    const std::string large(3'000'000, 'x');
    const ChildResult result = run_in_child([&] { return large; });
    EXPECT_EQ(result.end, ChildEnd::Done);
    EXPECT_EQ(result.answer, large);
}

TEST(ChildProcess, what_the_child_changes_stays_in_the_child) {
    int value = 1;
    run_in_child([&] { return std::string(std::size_t(value = 2), 'x'); });
    EXPECT_EQ(value, 1);
}

TEST(ChildProcess, tells_a_crash) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
        const ChildResult result = run_in_child([&]() -> std::string {
            ::raise(signal);
            return "never";
        });
        EXPECT_EQ(result.end, ChildEnd::Crashed);
        EXPECT_TRUE(result.answer.empty());
    }
}

TEST(ChildProcess, takes_an_exception_that_leaves_the_work_for_a_crash) {
    const ChildResult result = run_in_child([]() -> std::string { throw std::runtime_error("lost"); });
    EXPECT_EQ(result.end, ChildEnd::Crashed);
}

TEST(ChildProcess, ends_work_that_hangs) {
    const ChildResult result = run_in_child(
        []() -> std::string {
            while (true) ::pause();
        },
        {.wall_seconds = 1});
    EXPECT_EQ(result.end, ChildEnd::TimedOut);
}

TEST(ChildProcess, ends_work_that_burns_processor_time) {
    const ChildResult result = run_in_child(
        []() -> std::string {
            for (volatile unsigned i = 0;;) i = i + 1;
        },
        {.processor_seconds = 1, .wall_seconds = 60});
    EXPECT_EQ(result.end, ChildEnd::TimedOut);
}

TEST(ChildProcess, refuses_an_answer_that_is_too_long) {
    const ChildResult result = run_in_child([] { return std::string(100'000, 'x'); }, {.answer_bytes = 1000});
    EXPECT_EQ(result.end, ChildEnd::TooMuch);
}

TEST(ChildProcess, work_that_eats_memory_ends_alone) {
#if defined(SELVEDGE_ADDRESS_SANITIZER)
    GTEST_SKIP() << "the sanitizer's own memory leaves no room for a limit";
#endif
    const ChildResult result = run_in_child(
        [] {
            std::vector<std::vector<char>> hoard;
            for (int i = 0; i < 64; ++i) hoard.emplace_back(std::size_t(16) << 20, char(i));
            return std::string(1, hoard.back().back());
        },
        {.memory_bytes = std::size_t(128) << 20});
    EXPECT_EQ(result.end, ChildEnd::Crashed);
}

TEST(ChildProcess, works_beside_the_threads_of_parallel_loops) {
    std::vector<int> done(64, 0);
    parallel_for(done.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            done[i] = run_in_child([] { return std::string("ok"); }).answer == "ok";
    });
    for (const int each : done) EXPECT_EQ(each, 1);
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

TEST(GuardedImport, says_of_a_reader_that_takes_too_long_that_this_may_pass) {
    const TemporaryFolder folder;
    std::ofstream(folder / "body.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_THROW(guarded_import(folder / "body.obj", ImportKind::Surface, {.child = {.wall_seconds = 0}}),
                 PassingError);
}

}  // namespace

}  // namespace selvedge::sim
