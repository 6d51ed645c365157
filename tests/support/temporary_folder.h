#pragma once
// A temporary folder that is deleted when the test ends.
#include <gtest/gtest.h>
#include <unistd.h>
#include <filesystem>
#include <string>

namespace selvedge::sim {

class TemporaryFolder {
 public:
    TemporaryFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::temp_directory_path() / (std::string("selvedge_") + test->test_suite_name() + "_" +
                                                          test->name() + "_" + std::to_string(::getpid()));
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
    std::filesystem::path path_;
};

}  // namespace selvedge::sim
