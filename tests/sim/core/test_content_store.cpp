// The store on disk gives back what was kept, nothing that is broken or of another maker, and stays small.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "sim/core/content_store.h"
#include "sim/core/error.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim::test {
namespace {

constexpr std::uint64_t kRoom = 1 << 20;

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

TEST(ContentStore, gives_back_what_was_kept_under_its_kind_and_text) {
    const TemporaryFolder folder;
    const std::string bytes("a\0b\n", 4);
    ContentStore(folder / "store", "one", kRoom).keep("field", "surface", bytes);
    const ContentStore again(folder / "store", "one", kRoom);
    EXPECT_EQ(again.find("field", "surface"), bytes);
    EXPECT_EQ(again.find("field", "other"), std::nullopt);
    EXPECT_EQ(again.find("body", "surface"), std::nullopt);
    EXPECT_EQ(ContentStore(folder / "store", "two", kRoom).find("field", "surface"), std::nullopt) << "another build";
}

TEST(ContentStore, what_is_broken_on_disk_is_not_found) {
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "one", kRoom);
    for (const std::size_t keep : {std::size_t(0), std::size_t(10), std::size_t(80)}) {
        store.keep("field", "surface", std::string(1000, 'x'));
        const std::filesystem::path file = files_in(folder / "store").at(0);
        std::filesystem::resize_file(file, keep);
        EXPECT_EQ(store.find("field", "surface"), std::nullopt) << keep << " bytes left";
    }
    store.keep("field", "surface", std::string(1000, 'x'));
    std::fstream(files_in(folder / "store").at(0), std::ios::in | std::ios::out).seekp(500) << 'y';
    EXPECT_EQ(store.find("field", "surface"), std::nullopt);
}

TEST(ContentStore, lets_go_of_what_was_used_longest_ago) {
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "one", 5000);
    const std::string bytes(1000, 'x');
    const auto age = [&](int hours) {  // of all entries
        for (const auto& file : files_in(folder / "store"))
            std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) - std::chrono::hours(hours));
    };
    for (const char* name : {"a", "b", "c", "d"}) {
        store.keep("field", name, bytes);
        age(1);
    }
    EXPECT_TRUE(store.find("field", "a").has_value()) << "used now";
    store.keep("field", "e", bytes);
    EXPECT_TRUE(store.find("field", "a").has_value());
    EXPECT_FALSE(store.find("field", "b").has_value());
    EXPECT_TRUE(store.find("field", "e").has_value());
    store.keep("field", "huge", std::string(6000, 'x'));
    EXPECT_TRUE(store.find("field", "e").has_value()) << "what cannot fit drives nothing out";
}

TEST(ContentStore, counts_and_removes_what_killed_writers_left) {
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "one", 5000);
    const std::vector<std::filesystem::path> left = {folder / "store" / ".selvedge-0123456789abcdef.tmp",
                                                     folder / "store" / ".selvedge-fedcba9876543210.tmp"};
    std::vector<int> locked;  // so that the next writer does not remove it, as if it were another user's
    for (const std::filesystem::path& path : left) {
        std::ofstream(path) << std::string(4500, 'x');
        locked.push_back(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        ASSERT_EQ(::flock(locked.back(), LOCK_EX), 0);
    }
    std::filesystem::last_write_time(left[0], std::filesystem::last_write_time(left[0]) - std::chrono::hours(2));
    store.keep("field", "a", std::string(1000, 'x'));
    for (const int fd : locked) ::close(fd);
    EXPECT_FALSE(std::filesystem::exists(left[0]));
    EXPECT_TRUE(std::filesystem::exists(left[1])) << "it may be one that is being written";
    EXPECT_TRUE(store.find("field", "a").has_value());
}

TEST(ContentStore, uses_a_folder_that_can_only_be_read) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const TemporaryFolder folder;
    ContentStore(folder / "store", "one", kRoom).keep("field", "a", "kept");
    std::filesystem::permissions(folder / "store", std::filesystem::perms{0500});
    const ContentStore store(folder / "store", "one", kRoom);
    EXPECT_EQ(store.find("field", "a"), "kept");
    store.keep("field", "b", "new");
    EXPECT_EQ(store.find("field", "b"), std::nullopt);
    std::filesystem::permissions(folder / "store", std::filesystem::perms{0700});
}

TEST(ContentStore, many_may_write_and_read_at_once) {
    const TemporaryFolder folder;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&] {
            const ContentStore store(folder / "store", "one", kRoom);
            for (int i = 0; i < 50; ++i) {
                const std::string name = std::to_string(i % 7);
                if (const auto found = store.find("field", name)) {
                    EXPECT_EQ(*found, std::string(5000, name[0]));
                }
                store.keep("field", name, std::string(5000, name[0]));
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

TEST(ContentStore, a_folder_that_cannot_be_made_is_refused) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "x";
    EXPECT_THROW(ContentStore(folder / "file/store", "one", kRoom), InputError);
    EXPECT_THROW(ContentStore(folder / "file", "one", kRoom), InputError);
}

}  // namespace
}  // namespace selvedge::sim::test
