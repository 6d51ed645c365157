// Whatever a job does to its process, the others and the pool go on.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "batch/worker_pool.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::batch {
namespace {

using namespace std::chrono_literals;

class WorkerPoolTest : public testing::Test {
 protected:
    std::map<std::size_t, WorkResult> run_all(WorkerPool& pool) const {
        std::map<std::size_t, WorkResult> results;
        while (pool.running() > 0) {
            if (const auto result = pool.wait(10s)) results[result->job] = *result;
        }
        return results;
    }
    std::string log(const char* name) const {
        std::ifstream file(folder_ / name);
        std::stringstream text;
        text << file.rdbuf();
        return text.str();
    }
    const sim::TemporaryFolder folder_;
};

TEST_F(WorkerPoolTest, tells_how_each_of_its_jobs_ended) {
    WorkerPool pool({.seconds = 120, .memory_bytes = std::size_t(500) << 20});
    const auto start = [&](std::size_t job, const std::function<int()>& work) {
        pool.start(job, folder_ / ("log" + std::to_string(job)).c_str(), work);
    };
    start(0, [] { return 0; });
    start(1, [] { return 3; });
    start(2, []() -> int { std::abort(); });
    start(4, []() -> int { throw std::runtime_error("wrong input"); });
    start(5, []() -> int {
        std::vector<std::vector<char>> all;
        for (;;) all.emplace_back(std::size_t(64) << 20, 'x');
    });
    start(6, []() -> int {
        std::printf("printed\n");
        return 0;
    });
    std::map<std::size_t, WorkResult> results = run_all(pool);
    ASSERT_EQ(results.size(), 6U);
    EXPECT_EQ(results[0].end, WorkEnd::Exited);
    EXPECT_EQ(results[1].code, 3);
    EXPECT_EQ(results[2].end, WorkEnd::Crashed);
    EXPECT_EQ(results[2].signal, SIGABRT);
    EXPECT_EQ(results[4].code, 2);
    EXPECT_EQ(log("log4"), "selvedge: wrong input\n");
#if !defined(SELVEDGE_ADDRESS_SANITIZER)
    EXPECT_EQ(results[5].end, WorkEnd::OutOfMemory);
#endif
    EXPECT_EQ(log("log6"), "printed\n");
    EXPECT_GT(results[0].peak_memory_mb, 0);
}

TEST_F(WorkerPoolTest, kills_a_job_whose_time_is_over) {
    WorkerPool pool({.seconds = 0.5});
    pool.start(0, folder_ / "log", []() -> int {
        for (;;) std::this_thread::sleep_for(1s);
    });
    const std::map<std::size_t, WorkResult> results = run_all(pool);
    ASSERT_EQ(results.size(), 1U);
    EXPECT_EQ(results.at(0).end, WorkEnd::TimedOut);
    EXPECT_GE(results.at(0).wall_s, 0.5);
}

TEST_F(WorkerPoolTest, believes_a_job_that_ended_in_time_though_nobody_looked) {
    WorkerPool pool({.seconds = 0.3});
    pool.start(0, folder_ / "log", [] { return 3; });
    std::this_thread::sleep_for(1s);
    const std::map<std::size_t, WorkResult> results = run_all(pool);
    ASSERT_EQ(results.size(), 1U);
    EXPECT_EQ(results.at(0).end, WorkEnd::Exited);
    EXPECT_EQ(results.at(0).code, 3);
}

TEST_F(WorkerPoolTest, kills_what_still_runs_with_its_own_children_when_it_goes) {
    const std::filesystem::path mark = folder_ / "alive";
    {
        WorkerPool pool({});
        pool.start(0, folder_ / "log", [&]() -> int {
            const pid_t grandchild = ::fork();
            std::ofstream(mark.string() + (grandchild == 0 ? "1" : "0")) << ::getpid();
            for (;;) std::this_thread::sleep_for(1s);
        });
        for (int i = 0;
             i < 500 && !(std::filesystem::exists(mark.string() + "0") && std::filesystem::exists(mark.string() + "1"));
             ++i)
            std::this_thread::sleep_for(10ms);
    }
    for (const char* which : {"0", "1"}) {
        int pid = 0;
        std::ifstream(mark.string() + which) >> pid;
        ASSERT_GT(pid, 0);
        bool is_gone = false;
        for (int i = 0; i < 500 && !is_gone; ++i) {
            std::ifstream status("/proc/" + std::to_string(pid) + "/stat");
            std::string number, name, state;
            is_gone = !(status >> number >> name >> state) || state == "Z";
            if (!is_gone) std::this_thread::sleep_for(10ms);
        }
        EXPECT_TRUE(is_gone) << which;
    }
}

}  // namespace
}  // namespace selvedge::batch
