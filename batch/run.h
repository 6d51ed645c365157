#pragma once
// Does the jobs of a batch in child processes, and leaves out those that were done before with the same inputs.
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "batch/job.h"
#include "batch/worker_pool.h"
#include "sim/core/json.h"

namespace selvedge::batch {

// The jobs number `index`, `index` + `count`, ... of the list, from 1.
struct Shard {
    std::size_t index = 1;
    std::size_t count = 1;
};

// Parses "3/8". Throws InputError.
Shard parse_shard(const std::string& text);

struct BatchOptions {
    std::filesystem::path output;
    int workers = 1;
    JobLimits limits{};
    Shard shard{};
    bool does_all_again = false;
};

// How far a batch is.
struct BatchCounts {
    std::size_t jobs = 0;     // of this shard
    std::size_t skipped = 0;  // of these, done before
    std::size_t done = 0;     // by this run
    std::size_t dressed = 0;  // of all that are done, also before: these five
    std::size_t does_not_fit = 0;
    std::size_t defects = 0;
    std::size_t refused = 0;
    std::size_t failed = 0;
    std::size_t unrecorded = 0;  // of the failed ones, those whose folder could not be written
    std::string problem{};       // of the first of these
    double seconds = 0;          // since the first job began

    bool is_complete() const { return skipped + done == jobs; }
};

// What the program does for a batch.
struct BatchWork {
    // The hash of what the result follows from.
    std::function<std::string(const Job&)> key;
    // Makes ready in this process what the job's process, which is a copy of it, would make too: its body. Called
    // before a job begins, once a garment was dressed on that body, so that nothing untried is done here.
    std::function<void(const Job&)> prepare;
    // Dresses, and writes into the folder; returns the exit code of dress. Runs in the child process.
    std::function<int(const Job&, const std::filesystem::path& folder)> dress;
    // Whether an input of the job, which left this report, was changed since its key was made.
    std::function<bool(const Job&, const sim::Json& report)> have_inputs_changed;
    std::function<void(const BatchCounts&)> progress;  // called several times a second
    std::function<bool()> is_stopped;                  // true: no other job begins; those that run go on to their end
};

// A job whose result does not follow from its inputs alone, such as one that crashed, took too long, could not write
// a file or read another input than its key says, is reported as failed, and done again by the next run. Jobs on the
// same body follow each other. Pre: the jobs have names (name_jobs()); this process has started no threads. Throws
// InputError if the output folder cannot be made, if another process does the same shard in it, or if no process can be
// started for long.
BatchCounts run_batch(const std::vector<Job>& jobs, const BatchOptions& options, const BatchWork& work);

}  // namespace selvedge::batch
