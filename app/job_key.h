#pragma once
// The keys of a batch's jobs: hashes of what their results follow from: the program, whether it uses fused
// multiply-add, the options, the outputs, and all files that are read. A job whose key is that of an earlier result
// need not be done again. Shared libraries of the system, its fonts and its graphics are not in the keys.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch/job.h"
#include "sim/core/json.h"

namespace selvedge::app {

// What a batch writes for each job.
struct JobOutputs {
    bool has_pictures = true;
    std::vector<std::string> exports{};  // extensions
};

// Reads each file once: a change to it while this exists is not seen.
class JobKeys {
 public:
    // Throws InputError if this program cannot be read.
    explicit JobKeys(JobOutputs outputs);

    const std::string& program() const { return program_; }  // its hash

    // A file that cannot be read counts as such: the job reports it.
    std::string operator()(const batch::Job& job);

    // Whether a file of the job was changed since its key was made: the report on it names another content, or it was
    // refused and the files are others now.
    bool have_changed(const batch::Job& job, const sim::Json& report);

 private:
    JobKeys(JobOutputs outputs, std::string program);  // its hash
    std::string hash_of(const std::filesystem::path& file);
    std::vector<std::filesystem::path> inputs_of(const batch::Job& job);
    const std::vector<std::string>& named_by_garment(const std::filesystem::path& garment);
    const std::vector<std::string>& named_by_fabric(const std::string& fabric);
    const std::vector<std::filesystem::path>& buffers_of(const std::filesystem::path& body);

    JobOutputs outputs_;
    std::string program_;
    std::map<std::string, std::string> hashes_;
    std::map<std::string, std::vector<std::string>> named_by_garments_;
    std::map<std::string, std::vector<std::string>> named_by_fabrics_;
    std::map<std::string, std::vector<std::filesystem::path>> buffers_;
};

}  // namespace selvedge::app
