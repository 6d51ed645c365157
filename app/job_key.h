#pragma once
// The keys of a batch's jobs: hashes of all that their results follow from. A job whose key is that of an earlier
// result need not be done again.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch/job.h"

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

    // Of the program, the options, the outputs, and the content of all files that the job reads. A file that cannot be
    // read counts as such: the job reports it.
    std::string operator()(const batch::Job& job);

 private:
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
