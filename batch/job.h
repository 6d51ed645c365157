#pragma once
// One job of a batch: a garment on a body in a fabric, as the command dress takes it.
#include <filesystem>
#include <string>
#include <vector>

namespace selvedge::batch {

// An option of dress without its two hyphens, such as {"seconds", "8"}.
struct JobOption {
    std::string name;
    std::string value;       // empty for a flag
    bool is_flag = false;    // takes no value
    bool is_off = false;     // a flag that is not set, also where all jobs have it
    bool is_common = false;  // of all jobs of the manifest, not this job's own

    bool operator==(const JobOption&) const = default;
};

bool has_option(const std::vector<JobOption>& options, const std::string& name);

struct Job {
    std::string name;  // of its folder: letters of ASCII, digits, '.', '_' and '-'; unique in its batch
    std::filesystem::path garment;
    std::vector<std::filesystem::path> over;  // worn over it, from the inside out
    std::string body;                         // a file, or mannequin:...; empty: the pattern's
    std::string fabric;                       // a shipped fabric, or a file; empty: the pattern's
    std::vector<JobOption> options;
    std::string origin{};  // where its manifest has it: "jobs.csv: line 12"; empty without one

    bool operator==(const Job&) const = default;
};

// What follows "selvedge dress", without outputs.
std::vector<std::string> dress_arguments(const Job& job);

// The command line that does this job alone, for a shell: it writes the report and the picture into the working folder.
std::string replay_command(const Job& job);

// The body that is worn and how it is read: equal for jobs that may share it.
std::string body_key(const Job& job);

// A name for the job's folder that says what it holds; long ones end in a hash. Different jobs may get the same name,
// as those of "a b.json" and "a-b.json" do: name_jobs() tells them apart.
std::string describe_job(const Job& job);

// Whether a text can be a job's name: 1 to 120 characters, not starting with '.'.
bool is_job_name(const std::string& text);

}  // namespace selvedge::batch
