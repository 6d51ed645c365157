#include <gtest/gtest.h>
#include <unistd.h>
#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/core/guarded_child.h"
#include "sim/core/parallel.h"

namespace selvedge::sim {
namespace {

TEST(ChildProcess, returns_the_bytes_of_the_work) {
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

}  // namespace
}  // namespace selvedge::sim
