// A batch does each job once, whatever stops it, and gives the same results for any number of workers and shards.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "batch/gallery.h"
#include "batch/job_folder.h"
#include "batch/results.h"
#include "batch/run.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/inspection/report.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace selvedge::batch {
namespace {

using Path = std::filesystem::path;
using namespace std::chrono_literals;

std::string content_of(const Path& file) {
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<Job> numbered_jobs(int count) {
    std::vector<Job> jobs;
    for (int i = 0; i < count; ++i) {
        jobs.push_back({.name = "job" + std::to_string(1000 + i),
                        .garment = "g" + std::to_string(i) + ".json",
                        .over = {},
                        .body = {},
                        .fabric = {},
                        .options = {}});
    }
    return jobs;
}

// Stands in for dressing: writes a report with a fault for each fourth job.
int pretend(const Job& job, const Path& folder) {
    sim::DressReport report;
    report.garment = job.garment.stem().string();
    report.settled = true;
    const bool has_fault = std::stoi(report.garment.substr(1)) % 4 == 0;
    if (has_fault) report.faults = {{"does_not_fit", "too small at the waist by 3.2 cm", 0.032}};
    sim::write_file_atomically(folder / job_file::kReport, write_json(json_without_times(report)));
    std::ofstream(folder.parent_path().parent_path() / "tally", std::ios::app) << job.name + "\n";
    return exit_code_of(outcome_of(report));
}

BatchWork pretended_work() {
    return {.key = [](const Job& job) { return "key of " + job.garment.string(); },
            .prepare = [](const Job&) {},
            .dress = pretend,
            .have_inputs_changed = [](const Job&, const sim::Json&) { return false; },
            .progress = [](const BatchCounts&) {},
            .is_stopped = [] { return false; }};
}

std::string results_of(const std::vector<Job>& jobs, const Path& output) {
    const Results results = gather_results(jobs, output, pretended_work().key);
    EXPECT_TRUE(results.missing.empty());
    write_results(results, output);
    return content_of(output / "results.jsonl") + content_of(output / "results.csv") + gallery_html(results.rows, {});
}

TEST(Batch, gives_the_same_bytes_for_any_number_of_workers_shards_and_order) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(23);
    BatchOptions one{.output = folder / "one"}, four{.output = folder / "four", .workers = 4};
    const BatchCounts counts = run_batch(jobs, one, pretended_work());
    EXPECT_EQ(counts.done, 23U);
    EXPECT_EQ(counts.does_not_fit, 6U);
    EXPECT_TRUE(counts.is_complete());
    run_batch(jobs, four, pretended_work());
    BatchOptions shards{.output = folder / "shards", .workers = 2};
    for (const std::size_t shard : {3U, 1U, 2U}) {
        shards.shard = {.index = shard, .count = 3};
        run_batch(jobs, shards, pretended_work());
    }
    const std::string results = results_of(jobs, folder / "one");
    EXPECT_EQ(results, results_of(jobs, folder / "four"));
    EXPECT_EQ(results, results_of(jobs, folder / "shards"));
    EXPECT_NE(results.find("too small at the waist by 3.2 cm"), std::string::npos);
}

TEST(Batch, does_not_do_again_what_has_the_same_inputs) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(5);
    const BatchOptions options{.output = folder / "out"};
    run_batch(jobs, options, pretended_work());
    EXPECT_EQ(run_batch(jobs, options, pretended_work()).skipped, 5U);
    BatchWork changed = pretended_work();
    changed.key = [](const Job& job) {
        return job.name == "job1002" ? std::string("new") : "key of " + job.garment.string();
    };
    const BatchCounts again = run_batch(jobs, options, changed);
    EXPECT_EQ(again.skipped, 4U);
    EXPECT_EQ(again.done, 1U);
    EXPECT_EQ(again.does_not_fit, 2U) << "also those before";
    BatchOptions all = options;
    all.does_all_again = true;
    EXPECT_EQ(run_batch(jobs, all, changed).done, 5U);
}

TEST(Batch, prepares_a_body_for_several_jobs_once_a_garment_was_dressed_on_it) {
    const sim::TemporaryFolder folder;
    std::vector<Job> jobs = numbered_jobs(9);
    for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].body = i % 2 == 0 ? "even" : "odd";
    jobs[7].body = "odd";
    jobs[7].options = {{"body-unit", "cm", false}};
    BatchWork work = pretended_work();
    std::vector<std::string> prepared;
    work.prepare = [&](const Job& job) { prepared.push_back(job.name); };
    work.dress = [](const Job& job, const Path& path) -> int {
        if (job.name == "job1001") std::raise(SIGSEGV);
        return pretend(job, path);
    };
    EXPECT_EQ(run_batch(jobs, {.output = folder / "out"}, work).failed, 1U);
    EXPECT_EQ(prepared, (std::vector<std::string>{"job1002", "job1004", "job1006", "job1008"}))
        << "jobs on one body follow each other; the first on 'odd' crashed, and after the second there is one alone";
}

TEST(Batch, a_job_that_fails_is_reported_and_tried_again_by_the_next_run) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(4);
    const BatchOptions options{.output = folder / "out", .workers = 2, .limits = {.seconds = 1}};
    BatchWork work = pretended_work();
    work.dress = [](const Job& job, const Path& path) -> int {
        if (job.name == "job1001") std::raise(SIGSEGV);
        if (job.name == "job1002") std::this_thread::sleep_for(60s);
        if (job.name == "job1003") throw sim::InputError("g3.json", "", "no such file");
        return pretend(job, path);
    };
    const BatchCounts counts = run_batch(jobs, options, work);
    EXPECT_EQ(counts.failed, 3U);
    const Results results = gather_results(jobs, options.output, work.key);
    ASSERT_EQ(results.rows.size(), 4U);
    EXPECT_EQ(results.rows[1].find("outcome")->string(), "failed");
    EXPECT_NE(results.rows[1].find("problem")->string().find("signal"), std::string::npos);
    EXPECT_EQ(results.rows[2].find("problem")->string(), "it took longer than 1 s");
    EXPECT_EQ(results.rows[3].find("outcome")->string(), "failed");
    EXPECT_EQ(results.rows[3].find("problem")->string(), "selvedge: g3.json: no such file");
    const BatchCounts again = run_batch(jobs, options, pretended_work());
    EXPECT_EQ(again.done, 3U) << "the failed ones";
    EXPECT_EQ(again.failed, 0U);
}

// Stands in for dress that refuses its input.
int refuse(const Path& folder) {
    sim::DressReport report;
    report.problem = "g.json: wrong";
    sim::write_file_atomically(folder / job_file::kReport, write_json(json_without_times(report)));
    return exit_code_of(sim::Outcome::Refused);
}

TEST(Batch, only_an_outcome_that_its_report_confirms_is_kept) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(6);
    const BatchOptions options{.output = folder / "out"};
    BatchWork work = pretended_work();
    work.dress = [](const Job& job, const Path& path) -> int {
        if (job.name == "job1001") return refuse(path);
        if (job.name == "job1002") return 0;
        if (job.name == "job1003") return 2;
        if (job.name == "job1005") return pretend(job, path);
        pretend(job, path);
        std::fprintf(stderr, "selvedge: garment.obj: no space left\n");
        return 2;
    };
    const BatchCounts counts = run_batch(jobs, options, work);
    EXPECT_EQ(counts.refused, 1U);
    EXPECT_EQ(counts.dressed, 1U);
    EXPECT_EQ(counts.failed, 4U);
    const Results results = gather_results(jobs, options.output, work.key);
    ASSERT_EQ(results.rows.size(), 6U);
    const auto problem = [&](std::size_t row) { return results.rows[row].find("problem")->string(); };
    EXPECT_EQ(problem(0), "selvedge: garment.obj: no space left");
    EXPECT_EQ(problem(1), "g.json: wrong");
    EXPECT_EQ(problem(2), "its process ended with exit code 0 and left no report of that");
    EXPECT_EQ(problem(3), "its process ended with exit code 2 and left no report of that");
    for (const std::size_t row : {0U, 2U, 3U, 4U})
        EXPECT_EQ(results.rows[row].find("outcome")->string(), "failed") << row;
    EXPECT_EQ(run_batch(jobs, options, pretended_work()).done, 4U) << "the failed ones";
}

TEST(Batch, goes_on_after_a_job_that_prints_much_or_whose_result_cannot_be_kept) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(4);
    const BatchOptions options{.output = folder / "out"};
    BatchWork work = pretended_work();
    work.dress = [](const Job& job, const Path& path) -> int {
        if (job.name == "job1001") {
            for (int i = 0; i < 100'000; ++i) std::printf("one of many lines\n");
            throw sim::InputError("g1.json", "", "no such file");
        }
        if (job.name == "job1002") std::ofstream(path.parent_path() / job.name) << "a file where the result is to be";
        return pretend(job, path);
    };
    const BatchCounts counts = run_batch(jobs, options, work);
    EXPECT_TRUE(counts.is_complete());
    EXPECT_EQ(counts.failed, 2U);
    EXPECT_EQ(counts.unrecorded, 1U);
    EXPECT_NE(counts.problem.find("job1002"), std::string::npos) << counts.problem;
    const Results results = gather_results(jobs, options.output, work.key);
    EXPECT_EQ(results.missing, std::vector<std::string>{"job1002"});
    ASSERT_EQ(results.rows.size(), 3U);
    EXPECT_EQ(results.rows[1].find("problem")->string(), "selvedge: g1.json: no such file");
}

TEST(Batch, a_result_whose_report_is_lost_is_made_again) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(3);
    const BatchOptions options{.output = folder / "out"};
    run_batch(jobs, options, pretended_work());
    const std::string results = results_of(jobs, options.output);
    std::filesystem::remove(job_folder(options.output, "job1000") / job_file::kReport);
    std::ofstream(job_folder(options.output, "job1001") / job_file::kReport) << "{\"outc";
    const Results left = gather_results(jobs, options.output, pretended_work().key);
    EXPECT_EQ(left.missing, (std::vector<std::string>{"job1000", "job1001"}));
    EXPECT_EQ(run_batch(jobs, options, pretended_work()).done, 2U);
    EXPECT_EQ(results_of(jobs, options.output), results);
}

TEST(Batch, a_job_that_read_another_input_than_its_key_says_is_done_again) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(3);
    const BatchOptions options{.output = folder / "out"};
    BatchWork work = pretended_work();
    work.have_inputs_changed = [](const Job&, const sim::Json& report) {
        return report.find("garment")->string() == "g1";
    };
    EXPECT_EQ(run_batch(jobs, options, work).failed, 1U);
    const Results results = gather_results(jobs, options.output, work.key);
    ASSERT_EQ(results.rows.size(), 3U);
    EXPECT_EQ(results.rows[1].find("problem")->string(), "one of its inputs was changed while the batch ran");
    EXPECT_EQ(run_batch(jobs, options, pretended_work()).done, 1U);
}

TEST(Batch, results_of_other_inputs_are_missing) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(3);
    run_batch(jobs, {.output = folder / "out"}, pretended_work());
    const Results results = gather_results(jobs, folder / "out", [](const Job& job) {
        return job.name == "job1001" ? std::string("new") : "key of " + job.garment.string();
    });
    EXPECT_EQ(results.rows.size(), 2U);
    EXPECT_EQ(results.missing, std::vector<std::string>{"job1001"});
}

TEST(Batch, a_result_that_is_made_again_takes_the_place_of_the_older_one) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(3);
    BatchOptions options{.output = folder / "out"};
    BatchWork work = pretended_work();
    work.dress = [](const Job& job, const Path& path) {
        std::ofstream(path / ".selvedge-0123456789abcdef.tmp") << "left by a child that was killed";
        return pretend(job, path);
    };
    run_batch(jobs, options, work);
    std::ofstream(job_folder(options.output, "job1000") / "old") << "x";
    options.does_all_again = true;
    EXPECT_EQ(run_batch(jobs, options, work).done, 3U);
    EXPECT_FALSE(std::filesystem::exists(job_folder(options.output, "job1000") / "old"));
    std::size_t folders = 0;
    for (const auto& entry : std::filesystem::directory_iterator(options.output / "jobs")) {
        EXPECT_FALSE(std::filesystem::exists(entry.path() / ".lock")) << entry.path();
        ++folders;
    }
    EXPECT_EQ(folders, 3U);
    const Results results = gather_results(jobs, options.output, work.key);
    ASSERT_EQ(results.rows.size(), 3U);
    EXPECT_EQ(write_json(*results.rows[0].find("files"), -1), "[\"report.json\"]");
}

TEST(Batch, stops_when_it_is_told_to_and_goes_on_later) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(8);
    const BatchOptions options{.output = folder / "out"};
    BatchWork work = pretended_work();
    bool is_stopped = false;
    work.progress = [&](const BatchCounts& counts) { is_stopped = counts.done >= 3; };
    work.is_stopped = [&] { return is_stopped; };
    const BatchCounts part = run_batch(jobs, options, work);
    EXPECT_EQ(part.done, 3U);
    EXPECT_FALSE(part.is_complete());
    EXPECT_EQ(gather_results(jobs, options.output, work.key).missing.size(), 5U);
    EXPECT_EQ(run_batch(jobs, options, pretended_work()).done, 5U);
}

TEST(Batch, only_one_process_does_a_shard_at_a_time) {
    const sim::TemporaryFolder folder;
    const BatchOptions options{.output = folder / "out"};
    BatchWork work = pretended_work();
    work.dress = [&](const Job& job, const Path& path) -> int {  // in another process
        try {
            run_batch(numbered_jobs(1), options, pretended_work());
        } catch (const sim::InputError&) {
            return pretend(job, path);
        }
        std::abort();
    };
    EXPECT_EQ(run_batch(numbered_jobs(1), options, work).failed, 0U);
}

std::size_t count_of_folders(const Path& jobs) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(jobs)) ++count;
    return count;
}

TEST(JobFolder, of_a_job_that_another_process_does_is_no_stray) {
    const sim::TemporaryFolder folder;
    const Path output = folder / "out";
    const pid_t pid = ::fork();
    if (pid == 0) {
        const UnfinishedJob job(output, "a");
        std::ofstream(folder / "begun") << "x";
        for (;;) std::this_thread::sleep_for(1s);
    }
    EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(folder / "begun"); }));
    delete_strays(output, {"a"});
    EXPECT_EQ(count_of_folders(output / "jobs"), 1U);
    ::kill(pid, SIGKILL);
    ::waitpid(pid, nullptr, 0);
    delete_strays(output, {"b"});
    EXPECT_EQ(count_of_folders(output / "jobs"), 1U) << "it is of a job that another run may do";
    delete_strays(output, {"a", "b"});
    EXPECT_EQ(count_of_folders(output / "jobs"), 0U);
}

TEST(JobFolder, that_was_being_replaced_takes_its_place_again) {
    const sim::TemporaryFolder folder;
    const Path output = folder / "out";
    UnfinishedJob(output, "a").finish({.key = "k"});
    std::filesystem::rename(job_folder(output, "a"), job_folder(output, "a.old@0123"));
    delete_strays(output, {"b"});
    EXPECT_FALSE(read_record(output, "a"));
    delete_strays(output, {"a"});
    ASSERT_TRUE(read_record(output, "a"));
    EXPECT_EQ(read_record(output, "a")->key, "k");
    std::filesystem::create_directories(job_folder(output, "a.old@4567"));
    delete_strays(output, {"a"});
    EXPECT_EQ(count_of_folders(output / "jobs"), 1U);
}

// Runs the batch in a process of its own, which is killed after `pause` unless it has ended; returns whether it had.
bool ends_before(std::chrono::milliseconds pause, const std::vector<Job>& jobs, const BatchOptions& options) {
    const pid_t pid = ::fork();
    if (pid == 0) {
        BatchWork work = pretended_work();
        work.dress = [](const Job& job, const Path& path) {
            std::this_thread::sleep_for(5ms);
            return pretend(job, path);
        };
        try {
            ::_exit(run_batch(jobs, options, work).is_complete() ? 0 : 1);
        } catch (const sim::InputError&) {
            ::_exit(2);
        }
    }
    std::this_thread::sleep_for(pause);
    int status = 0;
    const bool has_ended = ::waitpid(pid, &status, WNOHANG) == pid;
    if (!has_ended) {
        ::kill(pid, SIGKILL);
        ::waitpid(pid, &status, 0);
    } else {
        EXPECT_EQ(status, 0) << "it was not complete, or refused";
    }
    return has_ended;
}

TEST(Batch, kills_at_any_moment_lose_no_result_and_leave_no_half_one) {
    const sim::TemporaryFolder folder;
    const std::vector<Job> jobs = numbered_jobs(120);
    const BatchOptions options{.output = folder / "out", .workers = 3};
    std::mt19937 random(7);
    std::size_t known = 0;
    int kills = 0;
    while (kills < 200 && !ends_before(std::chrono::milliseconds(1 + random() % 40), jobs, options)) {
        ++kills;
        for (const auto& entry : std::filesystem::directory_iterator(options.output / "jobs")) {
            const std::string name = entry.path().filename().string();
            if (!is_job_name(name)) continue;  // not finished
            EXPECT_TRUE(read_record(options.output, name) && read_report(entry.path())) << name << " is half done";
        }
        const Results results = gather_results(jobs, options.output, pretended_work().key);
        EXPECT_GE(results.rows.size(), known) << "after " << kills << " kills";
        known = results.rows.size();
    }
    EXPECT_GT(kills, 5);
    run_batch(jobs, options, pretended_work());
    BatchOptions other{.output = folder / "other"};
    run_batch(jobs, other, pretended_work());
    EXPECT_EQ(results_of(jobs, options.output), results_of(jobs, other.output));
    EXPECT_EQ(count_of_folders(options.output / "jobs"), jobs.size()) << "strays are deleted";
}

TEST(Batch, parses_shards) {
    EXPECT_EQ(parse_shard("3/8").index, 3U);
    EXPECT_EQ(parse_shard("3/8").count, 8U);
    for (const char* text : {"", "3", "0/8", "9/8", "a/b", "1/2x", "-1/2", "1/0"})
        EXPECT_THROW(parse_shard(text), sim::InputError) << text;
}

}  // namespace
}  // namespace selvedge::batch
