#pragma once
// Runs a command as a user's shell would, for tests that look at the program from outside.
#include <filesystem>
#include <string>

namespace selvedge::app {

struct ProgramResult {
    int exit_code = 0;
    std::string out;  // what it wrote to stdout
    std::string err;  // and to stderr
};

// command: for the shell; the caller quotes what needs it.
ProgramResult run_command(const std::string& command);

// An empty folder that is there until the object goes.
class ScratchFolder {
 public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
    std::filesystem::path path_;
};

std::string content_of(const std::filesystem::path& file);

int count_lines(const std::string& text);

}  // namespace selvedge::app
