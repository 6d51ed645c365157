#pragma once
// Runs commands in a shell, for tests that treat the program as a black box; and helpers for the files that it writes.
#include <filesystem>
#include <string>

namespace selvedge::app {

struct ProgramResult {
    int exit_code = 0;
    std::string out;  // stdout
    std::string err;  // stderr
};

// command: shell syntax; the caller quotes arguments.
ProgramResult run_command(const std::string& command);

// An empty temporary folder; the destructor removes it.
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
