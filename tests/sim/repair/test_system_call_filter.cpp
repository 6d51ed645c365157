// What the child that reads bodies may not do.
#include "sim/core/system_call_filter.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "sim/repair/guarded_import.h"
#include "sim/repair/load_body.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// Whether this kernel has filters of system calls: asked of the kernel itself, so that a filter that does not load
// fails the tests.
bool has_filters() {
    const std::uint32_t action = SECCOMP_RET_KILL_PROCESS;
    return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

// What the work does is forbidden to the child.
void expect_forbidden(const char* what, const std::function<void()>& work) {
    SCOPED_TRACE(what);
    const ChildResult result = run_in_child([&] {
        work();
        return std::string("done");
    });
    EXPECT_EQ(result.end, ChildEnd::Forbidden);
    EXPECT_TRUE(result.answer.empty());
}

TEST(SystemCallFilter, forbids_to_change_files) {
    if (!has_filters()) GTEST_SKIP() << "this kernel has no filters of system calls";
    const TemporaryFolder folder;
    const std::string file = folder / "file", other = folder / "other";
    std::ofstream(file) << "kept";
    expect_forbidden("open for writing", [&] { ::open(file.c_str(), O_WRONLY); });
    expect_forbidden("open for reading and writing", [&] { ::open(file.c_str(), O_RDWR); });
    expect_forbidden("truncate", [&] { ::open(file.c_str(), O_RDONLY | O_TRUNC); });
    expect_forbidden("create", [&] { ::open(other.c_str(), O_RDONLY | O_CREAT, 0600); });
    expect_forbidden("a stream", [&] { std::ofstream(other) << "new"; });
    expect_forbidden("unlink", [&] { ::unlink(file.c_str()); });
    expect_forbidden("rename", [&] { std::rename(file.c_str(), other.c_str()); });
    expect_forbidden("make a folder", [&] { std::filesystem::create_directory(other); });
    expect_forbidden("link", [&] { std::filesystem::create_symlink(file, other); });
    expect_forbidden("change the mode", [&] { std::filesystem::permissions(file, std::filesystem::perms::none); });
    std::string text;
    std::getline(std::ifstream(file), text);
    EXPECT_EQ(text, "kept");
    EXPECT_FALSE(std::filesystem::exists(other));
}

TEST(SystemCallFilter, forbids_to_write_to_what_its_parent_had_open) {
    if (!has_filters()) GTEST_SKIP() << "this kernel has no filters of system calls";
    const TemporaryFolder folder;
    const std::string path = folder / "open";
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_GE(file, 0);
    expect_forbidden("write", [&] { static_cast<void>(!::write(file, "x", 1)); });
    ::close(file);
    EXPECT_EQ(std::filesystem::file_size(path), 0U);
}

TEST(SystemCallFilter, leaves_the_child_nothing_that_its_parent_had_open) {
    const TemporaryFolder folder;
    const int low = ::open((folder / "open").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_GE(low, 0);
    const int high = ::fcntl(low, F_DUPFD_CLOEXEC, 500);
    ASSERT_GE(high, 500);
    const ChildResult result = run_in_child([&] {
        char byte = 0;
        std::string text;
        for (const int file : {low, high}) text += ::read(file, &byte, 1) < 0 && errno == EBADF ? "closed " : "open ";
        return text;
    });
    EXPECT_EQ(result.end, ChildEnd::Done);
    EXPECT_EQ(result.answer, "closed closed ");
    EXPECT_EQ(::close(low), 0) << "the parent's own stays open";
    EXPECT_EQ(::close(high), 0);
}

TEST(SystemCallFilter, forbids_to_write_to_memory_that_others_share) {
    if (!has_filters()) GTEST_SKIP() << "this kernel has no filters of system calls";
    constexpr std::size_t kBytes = 4096;
    const auto map = [](int protection, int flags) {
        return ::mmap(nullptr, kBytes, protection, flags | MAP_ANONYMOUS, -1, 0) == MAP_FAILED ? "refused " : "mapped ";
    };
    expect_forbidden("shared", [&] { map(PROT_READ | PROT_WRITE, MAP_SHARED); });
    expect_forbidden("shared, another way", [&] { map(PROT_WRITE, MAP_SHARED_VALIDATE); });
    expect_forbidden("executable", [&] { map(PROT_READ | PROT_EXEC, MAP_PRIVATE); });
    expect_forbidden("executable and shared", [&] { map(PROT_EXEC, MAP_SHARED); });
    const ChildResult result = run_in_child(
        [&] { return std::string(map(PROT_READ | PROT_WRITE, MAP_PRIVATE)) + map(PROT_READ, MAP_SHARED); });
    EXPECT_EQ(result.end, ChildEnd::Done);
    EXPECT_EQ(result.answer, "mapped mapped ");
}

TEST(SystemCallFilter, forbids_sockets_programs_and_processes) {
    if (!has_filters()) GTEST_SKIP() << "this kernel has no filters of system calls";
    expect_forbidden("socket", [] { ::socket(AF_INET, SOCK_STREAM, 0); });
    expect_forbidden("socket of this machine", [] { ::socket(AF_UNIX, SOCK_STREAM, 0); });
    expect_forbidden("exec", [] { ::execl("/bin/true", "true", nullptr); });
    expect_forbidden("fork", [] {
        if (::fork() == 0) ::_exit(0);
    });
    expect_forbidden("trace", [] { ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr); });
    expect_forbidden("kill the parent", [] { ::kill(::getppid(), 0); });
}

TEST(SystemCallFilter, lets_the_child_read) {
    const TemporaryFolder folder;
    const std::string file = folder / "file";
    std::ofstream(file) << "content";
    const ChildResult result = run_in_child([&] {
        std::string text;
        std::getline(std::ifstream(file), text);
        std::FILE* again = std::fopen(file.c_str(), "rb");
        if (!again) return std::string("not opened");
        text += static_cast<char>(std::fgetc(again));
        std::fclose(again);
        return text + (std::filesystem::exists(file) ? "!" : "?") + std::string(2'000'000, 'x');
    });
    EXPECT_EQ(result.end, ChildEnd::Done);
    EXPECT_TRUE(result.answer.starts_with("contentc!xx"));
}

TEST(SystemCallFilter, lets_the_reader_of_gltf_open_the_buffers_beside_the_file) {
    const TemporaryFolder folder;
    const std::array<float, 12> x{0, 0, 0, 1, 0, 0, 0, 1.7F, 0, 0, 0, 0.3F};
    const std::array<std::uint16_t, 12> corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    std::ofstream buffer(folder / "tetrahedron.bin", std::ios::binary);
    buffer.write(reinterpret_cast<const char*>(x.data()), sizeof x);
    buffer.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
    buffer.close();
    std::ofstream(folder / "tetrahedron.gltf")
        << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0],
                       "max": [1, 1.7, 0.3]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "buffers": [{"byteLength": 72, "uri": "tetrahedron.bin"}]})";
    EXPECT_EQ(load_body(folder / "tetrahedron.gltf").triangles.size(), 4U);
}

}  // namespace
}  // namespace selvedge::sim
