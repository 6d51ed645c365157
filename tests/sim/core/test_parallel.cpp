#include "sim/core/parallel.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <vector>

#include "tests/support/processor_time.h"
#include "tests/support/wait_until.h"

namespace selvedge::sim {
namespace {

// The largest number of iterations that run simultaneously. Each iteration waits until `expected` of them have met, and
// then a little for one more. If they do not meet, the first that has waited in vain lets the others go on.
int most_at_once(int expected) {
    std::atomic<int> running = 0;
    std::atomic<int> most = 0;
    std::atomic<bool> is_in_vain = false;
    parallel_for(16, 1, [&](std::size_t, std::size_t) {
        const int now = ++running;
        int seen = most;
        while (now > seen && !most.compare_exchange_weak(seen, now)) {
        }
        if (!wait_until([&] { return is_in_vain || most >= expected; })) is_in_vain = true;
        static_cast<void>(wait_until([&] { return most > expected; }, std::chrono::milliseconds(5)));
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

// No atomics here: under the thread sanitizer, the order that parallel_for() promises is the only one.
TEST(Parallel, passes_an_exception_on_after_all_ranges_that_were_started_have_ended) {
    struct Stop {};
    std::vector<int> started(64, 0), ended(64, 0);
    const auto run = [&] {
        parallel_for(started.size(), 1, [&](std::size_t first, std::size_t) {
            started[first] = 1;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            ended[first] = 1;
            if (first == 20) throw Stop();
        });
    };
    EXPECT_THROW(run(), Stop);
    EXPECT_EQ(started[20], 1);
    EXPECT_EQ(ended, started);
}

TEST(ThreadLimit, of_one_runs_one_iteration_at_a_time) {
    const ThreadLimit limit(1);
    EXPECT_EQ(most_at_once(1), 1);
}

TEST(ThreadLimit, of_two_lets_no_more_than_two_run_together) {
    if (available_threads() < 2) GTEST_SKIP() << "the machine has one thread";
    const ThreadLimit limit(2);
    EXPECT_EQ(most_at_once(2), 2);
}

TEST(ThreadLimit, ends_with_the_object_that_holds_it) {
    if (available_threads() < 2) GTEST_SKIP() << "the machine has one thread";
    { const ThreadLimit limit(1); }
    EXPECT_GE(most_at_once(2), 2);
}

TEST(ThreadLimit, of_any_number_gives_the_same_results) {
    const std::vector<double> alone = sines(1);
    EXPECT_EQ(sines(2), alone);
    EXPECT_EQ(sines(3), alone);
}

// Keeps every CPU busy with a process of its own.
class BusyMachine {
 public:
    BusyMachine() {
        for (int i = 0; i < available_threads(); ++i) {
            const pid_t child = ::fork();
            if (child == 0) {
                ::alarm(60);  // it ends also if the test does not
                for (volatile unsigned work = 0;;) work = work + 1;
            }
            if (child > 0) children_.push_back(child);
        }
    }
    ~BusyMachine() {
        for (const pid_t child : children_) {
            ::kill(child, SIGKILL);
            ::waitpid(child, nullptr, 0);
        }
    }
    BusyMachine(const BusyMachine&) = delete;
    BusyMachine& operator=(const BusyMachine&) = delete;

 private:
    std::vector<pid_t> children_;
};

// Short loops with work in between that only one thread does, as while a garment is dressed.
double processor_seconds_of_loops(int threads) {
    const ThreadLimit limit(threads);
    const double before = processor_seconds();
    std::vector<double> values(20'000);
    for (int loop = 0; loop < 100; ++loop) {
        parallel_for(values.size(), 500, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) values[i] = std::sin(static_cast<double>(i) + values[i]);
        });
        for (double& value : values) value = std::cos(value);
    }
    return processor_seconds() - before;
}

TEST(Parallel, threads_that_wait_take_no_processor_time_from_a_busy_machine) {
#if defined(SELVEDGE_THREAD_SANITIZER)
    GTEST_SKIP() << "the sanitizer's own threads take time";
#endif
    processor_seconds_of_loops(2);  // starts the threads
    const BusyMachine busy;
    const double alone = processor_seconds_of_loops(1);
    EXPECT_LT(processor_seconds_of_loops(2), 2 * alone);
}

}  // namespace
TEST(Parallel, loops_run_before_and_after_the_worker_threads_were_ended) {
    for (int round = 0; round < 3; ++round) {
        std::vector<int> counts(1000, 0);
        parallel_for(counts.size(), 10, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) ++counts[i];
        });
        EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), 1000);
        end_worker_threads();
    }
}

}  // namespace selvedge::sim
