#pragma once
// The files that were opened or saved last, kept from one run to the next.
#include <filesystem>
#include <string>
#include <vector>

namespace selvedge {

class RecentFiles {
 public:
    explicit RecentFiles(std::filesystem::path file) : file_(std::move(file)) {}

    std::vector<std::string> list() const;  // those that are still there, newest first

    // First from now on. What cannot be written is only forgotten.
    void add(const std::string& path) const;

 private:
    std::filesystem::path file_;
};

}  // namespace selvedge
