#include "sim/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

namespace selvedge::sim {
namespace {

// The largest number of iterations that run simultaneously. Each iteration sleeps for 5 ms, so that they overlap.
int most_at_once() {
    std::atomic<int> running = 0;
    std::atomic<int> most = 0;
    parallel_for(16, 1, [&](std::size_t, std::size_t) {
        const int now = ++running;
        int seen = most;
        while (now > seen && !most.compare_exchange_weak(seen, now)) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        --running;
    });
    return most;
}

std::vector<double> sines(int threads) {
    const ThreadLimit limit(threads);
    std::vector<double> values(10007);
    parallel_for(values.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) values[i] = std::sin(static_cast<double>(i)) / 3;
    });
    return values;
}

TEST(Parallel, covers_every_index_once_in_ranges_no_longer_than_the_grain) {
    std::vector<std::atomic<int>> visits(1000);
    std::atomic<std::size_t> longest = 0;
    parallel_for(visits.size(), 7, [&](std::size_t first, std::size_t last) {
        std::size_t seen = longest;
        while (last - first > seen && !longest.compare_exchange_weak(seen, last - first)) {
        }
        for (std::size_t i = first; i < last; ++i) ++visits[i];
    });
    for (const std::atomic<int>& count : visits) ASSERT_EQ(count, 1);
    EXPECT_LE(longest, 7U);
    EXPECT_GT(longest, 0U);
}

TEST(ThreadLimit, of_one_runs_one_iteration_at_a_time) {
    const ThreadLimit limit(1);
    EXPECT_EQ(most_at_once(), 1);
}

TEST(ThreadLimit, of_two_lets_no_more_than_two_run_together) {
    if (available_threads() < 2) GTEST_SKIP() << "the machine has one thread";
    const ThreadLimit limit(2);
    EXPECT_EQ(most_at_once(), 2);
}

TEST(ThreadLimit, ends_with_the_object_that_holds_it) {
    if (available_threads() < 2) GTEST_SKIP() << "the machine has one thread";
    { const ThreadLimit limit(1); }
    EXPECT_GT(most_at_once(), 1);
}

TEST(ThreadLimit, of_any_number_gives_the_same_results) {
    const std::vector<double> alone = sines(1);
    EXPECT_EQ(sines(2), alone);
    EXPECT_EQ(sines(3), alone);
}

}  // namespace
}  // namespace selvedge::sim
