#include "sim/core/file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

class File : public ::testing::Test {
 protected:
    void SetUp() override {
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ("selvedge_file_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_;
};

TEST_F(File, gives_back_what_was_written_and_leaves_nothing_beside_it) {
    const std::string content("one\0two\n", 8);
    write_file_atomically(folder_ / "a.txt", "old and longer than the new");
    write_file_atomically(folder_ / "a.txt", content);
    EXPECT_EQ(read_file(folder_ / "a.txt", 100), content);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(File, refuses_a_file_over_the_limit_a_folder_and_a_missing_file) {
    write_file_atomically(folder_ / "a.txt", "12345");
    EXPECT_THROW(read_file(folder_ / "a.txt", 4), InputError);
    EXPECT_THROW(read_file(folder_, 100), InputError);
    EXPECT_THROW(read_file(folder_ / "b.txt", 100), InputError);
}

TEST_F(File, leaves_the_old_file_when_the_new_one_cannot_take_its_place) {
    std::filesystem::create_directories(folder_ / "taken" / "inside");
    EXPECT_THROW(write_file_atomically(folder_ / "taken", "x"), InputError);
    EXPECT_THROW(write_file_atomically(folder_ / "no" / "such" / "folder.txt", "x"), InputError);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "taken" / "inside"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(File, writes_what_a_link_points_to_and_leaves_the_link) {
    std::filesystem::create_directories(folder_ / "elsewhere");
    write_file_atomically(folder_ / "elsewhere" / "a.txt", "old");
    std::filesystem::create_symlink(folder_ / "elsewhere" / "a.txt", folder_ / "link.txt");
    write_file_atomically(folder_ / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.txt"));
    EXPECT_EQ(read_file(folder_ / "elsewhere" / "a.txt", 100), "new");
}

}  // namespace
}  // namespace selvedge::sim
