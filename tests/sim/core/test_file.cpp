#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "sim/core/atomic_file.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"

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

TEST_F(File, writes_the_missing_target_of_a_link_and_leaves_the_link) {
    std::filesystem::create_directories(folder_ / "elsewhere");
    std::filesystem::create_symlink("elsewhere/a.txt", folder_ / "link.txt");
    std::filesystem::create_symlink("link.txt", folder_ / "link_to_link.txt");
    write_file_atomically(folder_ / "link_to_link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.txt"));
    EXPECT_EQ(read_file(folder_ / "elsewhere" / "a.txt", 100), "new");
    std::filesystem::create_symlink("loop", folder_ / "loop");
    EXPECT_THROW(write_file_atomically(folder_ / "loop", "x"), InputError);
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "loop"));
}

TEST_F(File, does_not_replace_a_device_or_a_pipe) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(write_file_atomically(folder_ / "pipe", "x"), InputError);
    EXPECT_TRUE(std::filesystem::is_fifo(folder_ / "pipe"));
    EXPECT_THROW(write_file_atomically("/dev/null", "x"), InputError);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(File, keeps_permissions_of_what_it_replaces_and_gives_new_ones_those_of_the_umask) {
    const auto rights = [&](const char* name) {
        return static_cast<unsigned>(std::filesystem::status(folder_ / name).permissions());
    };
    for (const TemporaryName name : {TemporaryName::None, TemporaryName::Random}) {
        for (const unsigned mode : {0600U, 0640U, 0755U}) {
            write_file_atomically(folder_ / "a.txt", "old");
            std::filesystem::permissions(folder_ / "a.txt", std::filesystem::perms{mode});
            AtomicFile(folder_ / "a.txt", name).commit();
            EXPECT_EQ(rights("a.txt"), mode);
        }
        const mode_t before = ::umask(027);
        AtomicFile(folder_ / "new.txt", name).commit();
        ::umask(before);
        EXPECT_EQ(rights("new.txt"), 0640U);
        std::filesystem::remove(folder_ / "new.txt");
    }
}

TEST_F(File, keeps_the_owner_of_what_it_replaces) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
    write_file_atomically(folder_ / "a.txt", "old");
    ASSERT_EQ(::chown((folder_ / "a.txt").c_str(), 1234, 4321), 0);
    write_file_atomically(folder_ / "a.txt", "new");
    struct stat status {};
    ASSERT_EQ(::stat((folder_ / "a.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 1234U);
    EXPECT_EQ(status.st_gid, 4321U);
}

TEST_F(File, takes_a_name_as_long_as_the_system_allows) {
    const std::string name(255, 'n');
    write_file_atomically(folder_ / name, "old");
    AtomicFile(folder_ / name, TemporaryName::Random).commit();
    EXPECT_EQ(read_file(folder_ / name, 100), "");
    EXPECT_THROW(write_file_atomically(folder_ / (name + "n"), "x"), InputError);
}

// A program that is killed with its file half written.
void kill_while_writing(const std::filesystem::path& path, TemporaryName name) {
    const pid_t child = ::fork();
    if (child == 0) {
        AtomicFile file(path, name);
        file.append("half");
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
}

std::vector<std::filesystem::path> hidden_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename().native().front() == '.') files.push_back(entry.path());
    return files;
}

TEST_F(File, a_killed_program_leaves_nothing_or_what_the_next_one_removes) {
    kill_while_writing(folder_ / "a.txt", TemporaryName::None);
    EXPECT_TRUE(hidden_files(folder_).empty());
    kill_while_writing(folder_ / "a.txt", TemporaryName::Random);
    ASSERT_EQ(hidden_files(folder_).size(), 1U);
    write_file_atomically(folder_ / "b.txt", "");
    ASSERT_EQ(hidden_files(folder_).size(), 1U) << "it may be one that was made just now";
    const auto long_ago = std::filesystem::file_time_type::clock::now() - std::chrono::minutes(2);
    std::filesystem::last_write_time(hidden_files(folder_)[0], long_ago);
    AtomicFile under_way(folder_ / "c.txt", TemporaryName::Random);
    std::filesystem::last_write_time(under_way.temporary(), long_ago);
    for (const char* name : {".selvedge-mine.tmp", ".a.txt.tmp", ".selvedge-0123456789abcdef.tmp.txt"}) {
        write_file_atomically(folder_ / name, "");
        std::filesystem::last_write_time(folder_ / name, long_ago);
    }
    write_file_atomically(folder_ / "b.txt", "");
    EXPECT_EQ(hidden_files(folder_).size(), 4U) << "files of others and one that is being written stay";
    under_way.commit();
    EXPECT_TRUE(std::filesystem::exists(folder_ / "c.txt"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.txt"));
}

TEST_F(File, what_a_killed_program_left_is_removed_even_if_it_may_only_be_read) {
    kill_while_writing(folder_ / "a.txt", TemporaryName::Random);
    const std::filesystem::path left = hidden_files(folder_).at(0);
    std::filesystem::permissions(left, std::filesystem::perms{0444});
    std::filesystem::last_write_time(left, std::filesystem::file_time_type::clock::now() - std::chrono::minutes(2));
    write_file_atomically(folder_ / "b.txt", "");
    EXPECT_TRUE(hidden_files(folder_).empty());
}

// From now on the system refuses fchmod(), as file systems without permissions may.
bool refuse_fchmod() {
    std::array<sock_filter, 4> code{{
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
        {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_fchmod},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | EPERM},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    }};
    const sock_fprog program{.len = static_cast<unsigned short>(code.size()), .filter = code.data()};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
}

TEST_F(File, that_cannot_be_begun_leaves_nothing_on_disk_and_nothing_open) {
    write_file_atomically(folder_ / "a.txt", "old");
    const auto count = [](const std::filesystem::path& folder) {
        return std::distance(std::filesystem::directory_iterator(folder), {});
    };
    constexpr int kSound = 0, kNoFilter = 1, kNotThrown = 2, kLeftOpen = 3, kLeftOnDisk = 4;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const auto open_before = count("/proc/self/fd");
        if (!refuse_fchmod()) ::_exit(kNoFilter);
        for (const TemporaryName name : {TemporaryName::None, TemporaryName::Random}) {
            try {
                const AtomicFile file(folder_ / "a.txt", name);
                ::_exit(kNotThrown);
            } catch (const InputError&) {
            }
        }
        if (count("/proc/self/fd") != open_before) ::_exit(kLeftOpen);
        ::_exit(count(folder_) == 1 ? kSound : kLeftOnDisk);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kNoFilter) GTEST_SKIP() << "this kernel has no filters of system calls";
    EXPECT_EQ(WEXITSTATUS(status), kSound);
}

TEST_F(File, paths_that_cannot_be_looked_at_are_missing) {
    std::filesystem::create_symlink("loop", folder_ / "loop");
    for (const std::filesystem::path& path :
         {folder_ / "loop", folder_ / "loop" / "in", folder_ / std::string(300, 'n'),
          folder_ / std::string(5000, '/') / std::string(5000, 'n')}) {
        EXPECT_FALSE(file_exists(path));
        EXPECT_FALSE(is_file(path));
        EXPECT_FALSE(is_folder(path));
        EXPECT_TRUE(canonical_path(path).is_absolute());
        std::error_code error;
        EXPECT_TRUE(entries_of(path, error).empty());
        EXPECT_TRUE(error);
    }
    std::error_code error;
    EXPECT_EQ(entries_of(folder_, error), std::vector<std::filesystem::path>{folder_ / "loop"});
    EXPECT_FALSE(error);
    EXPECT_EQ(canonical_path(folder_ / "no" / ".." / "x"), canonical_path(folder_ / "x"));
}

TEST_F(File, written_in_parts_appears_when_it_is_complete) {
    write_file_atomically(folder_ / "a.bin", "old");
    {
        AtomicFile file(folder_ / "a.bin");
        file.append("0123");
        file.append("4567");
        file.overwrite(2, "xyz");
        EXPECT_EQ(file.size(), 8U);
        EXPECT_EQ(read_file(folder_ / "a.bin", 100), "old");
        file.commit();
    }
    EXPECT_EQ(read_file(folder_ / "a.bin", 100), "01xyz567");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(File, written_in_parts_and_not_completed_leaves_nothing) {
    write_file_atomically(folder_ / "a.bin", "old");
    { AtomicFile(folder_ / "a.bin").append("new"); }
    EXPECT_EQ(read_file(folder_ / "a.bin", 100), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(File, names_what_a_full_disk_has_left) {
    EXPECT_NO_THROW(require_free_space(folder_ / "a.bin", 1));
    try {
        require_free_space(folder_ / "a.bin", 3'000'000'000'000'000'000);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(error.problem().find("needs 3.0 EB, and "), std::string::npos) << error.what();
        EXPECT_NE(error.problem().find(" are free on the disk"), std::string::npos) << error.what();
    }
}

TEST_F(File, size_is_told_in_three_digits) {
    EXPECT_EQ(bytes_text(0), "0 bytes");
    EXPECT_EQ(bytes_text(999), "999 bytes");
    EXPECT_EQ(bytes_text(1000), "1.0 kB");
    EXPECT_EQ(bytes_text(9'949'000), "9.9 MB");
    EXPECT_EQ(bytes_text(9'990'000), "10 MB");
    EXPECT_EQ(bytes_text(999'600'000), "1.0 GB");
    EXPECT_EQ(bytes_text(4'294'967'295), "4.3 GB");
}

}  // namespace

namespace {

// The error message for the text; empty if it is valid.
std::string complaint(const std::string& text) {
    try {
        parse_json(text, "f.json");
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

std::string nested(std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
}

TEST(Json, keeps_the_order_of_keys_and_the_text_of_numbers) {
    const std::string text = R"({"b":25,"a":1.50,"c":[1e2,-0.0,12345678901234567890,0.1],"A":"\u00e9\n"})";
    EXPECT_EQ(write_json(parse_json(text, ""), -1),
              R"({"b":25,"a":1.50,"c":[1e2,-0.0,12345678901234567890,0.1],"A":"é\n"})");
}

TEST(Json, reads_back_what_it_writes_indented) {
    Json json;
    json["flags"] = Json::array({true, false, Json()});
    json["deep"]["deeper"]["numbers"] = Json::array({0.1, 1e-9, 3, -7});
    json["text"] = std::string(200, 'x');
    json["empty"] = Json::object();
    EXPECT_EQ(write_json(parse_json(write_json(json), ""), -1), write_json(json, -1));
}

TEST(Json, breaks_lines_only_where_they_grow_long) {
    Json json;
    json["point"] = Json::array({1, 2.5});
    json["points"] = Json::array(std::vector<Json>(30, Json::array({1, 2})));
    const std::string text = write_json(json);
    EXPECT_NE(text.find("  \"point\": [1, 2.5],\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\n    [1, 2],\n"), std::string::npos) << text;
    for (std::size_t from = 0, to = 0; from < text.size(); from = to + 1) {
        to = text.find('\n', from);
        EXPECT_LE(to - from, 100U);
    }
}

TEST(Json, writes_the_shortest_text_that_gives_the_number_back) {
    EXPECT_EQ(Json(25.0).number_text(), "25");
    EXPECT_EQ(Json(0.1).number_text(), "0.1");
    EXPECT_EQ(parse_json(Json(1.0 / 3).number_text(), "").number(), 1.0 / 3);
}

TEST(Json, has_null_for_what_is_not_finite) {
    EXPECT_TRUE(Json(std::numeric_limits<double>::quiet_NaN()).is_null());
    EXPECT_TRUE(Json(-std::numeric_limits<double>::infinity()).is_null());
}

TEST(Json, allows_64_levels_and_refuses_the_65th) {
    EXPECT_EQ(complaint(nested(64)), "");
    EXPECT_NE(complaint(nested(65)).find("nested deeper than 64 levels"), std::string::npos);
    EXPECT_NE(complaint(nested(1'000'000)).find("nested deeper than 64 levels"), std::string::npos);
}

TEST(Json, refuses_numbers_that_no_double_holds) {
    EXPECT_NE(complaint("[1, 1e999]").find("f.json: [1]: "), std::string::npos) << complaint("[1, 1e999]");
    EXPECT_NE(complaint("[1, 1e999]").find("1e999"), std::string::npos);
    EXPECT_NE(complaint("[NaN]"), "");
    EXPECT_NE(complaint("[Infinity]"), "");
    EXPECT_EQ(complaint("[1e308, 1e-400]"), "");
}

TEST(Json, refuses_a_key_that_stands_twice_and_says_where) {
    EXPECT_EQ(complaint(R"({"a":{"b":[0,{"c":1,"c":2}]}})"), "f.json: a.b[1].c: the key 'c' is a duplicate key");
}

TEST(Json, names_the_line_where_the_text_stops_being_json) {
    EXPECT_NE(complaint("{\n\"a\": 1,\n}").find("not JSON at line 3"), std::string::npos)
        << complaint("{\n\"a\": 1,\n}");
    EXPECT_NE(complaint(""), "");
    EXPECT_NE(complaint("{} {}"), "");
    EXPECT_NE(complaint("// comment\n{}"), "");
    EXPECT_NE(complaint("[\"\xff\"]"), "");
}

TEST(Json, tells_what_is_wrong_on_a_short_line_however_long_the_broken_token_is) {
    const std::string cut_off = complaint("{\n\"a\": \"" + std::string(5000, 'x'));
    EXPECT_LT(cut_off.size(), 160U) << cut_off;
    EXPECT_TRUE(cut_off.starts_with("f.json: not JSON at line 2, column 500")) << cut_off;
    EXPECT_LT(complaint("[1" + std::string(5000, '0') + "e999]").size(), 160U);
    EXPECT_NE(complaint("[tru]").find("last read: '[tru]'"), std::string::npos) << complaint("[tru]");
}

TEST(Json, refuses_more_than_64_megabytes_and_more_than_four_million_values) {
    EXPECT_NE(complaint(std::string((std::size_t{64} << 20) + 1, ' ')).find("over 64 MB"), std::string::npos);
    std::string many = "[0";
    for (int i = 0; i < 4'000'000; ++i) many += ",0";
    EXPECT_NE(complaint(many + "]").find("more than 4000000 values"), std::string::npos);
}

TEST(JsonView, says_which_value_is_of_the_wrong_kind) {
    const Json json = parse_json(R"({"a":{"b":[1,"two"]},"n":2.5})", "");
    const JsonView view(json, "f.json");
    EXPECT_EQ(view.at("a").at("b").at(std::size_t{0}).number(), 1);
    const auto problem_of = [](auto read) {
        try {
            read();
            return std::string();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
    };
    EXPECT_EQ(problem_of([&] { view.at("a").at("b").numbers(); }), "f.json: a.b[1]: a string where a number should be");
    EXPECT_EQ(problem_of([&] { view.at("c"); }), "f.json: no key 'c'");
    EXPECT_EQ(problem_of([&] { view.at("a").at("b").at(std::size_t{2}); }), "f.json: a.b: only 2 elements");
    EXPECT_EQ(problem_of([&] { view.at("n").integer(); }), "f.json: n: 2.5 is not a whole number");
    EXPECT_EQ(problem_of([&] { view.at("n").number_between(3, 4); }), "f.json: n: 2.5 is not between 3 and 4");
}

}  // namespace

}  // namespace selvedge::sim
