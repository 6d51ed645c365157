#include "sim/core/system_call_filter.h"

#include <fcntl.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>
#include <cerrno>
#include <memory>
#include <type_traits>
#include <vector>

namespace selvedge::sim {
namespace {

using Context = std::remove_pointer_t<scmp_filter_ctx>;

// By name, because not every architecture has every call.
constexpr const char* kAllowed[] = {
    // to read
    "read", "pread64", "readv", "lseek", "_llseek", "close", "fadvise64",
    // to look for files
    "fstat", "stat", "lstat", "newfstatat", "statx", "access", "faccessat", "faccessat2", "readlink", "readlinkat",
    "getcwd", "getdents", "getdents64",
    // memory, without execution and without writing to what others share: see below
    "munmap", "mremap", "madvise", "brk",
    // time, waiting, and the C library's and the sanitizers' own needs
    "clock_gettime", "clock_getres", "clock_nanosleep", "nanosleep", "gettimeofday", "time", "pause", "futex",
    "sched_yield", "sched_getaffinity", "getpid", "gettid", "getrandom", "sysinfo", "uname", "getrusage", "getrlimit",
    "restart_syscall", "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigaltstack",
    // to end
    "exit", "exit_group"};

class Filter {
 public:
    Filter() : context_(seccomp_init(SCMP_ACT_KILL_PROCESS), seccomp_release) {}

    void allow(const char* name, const std::vector<scmp_arg_cmp>& conditions = {}) {
        add(SCMP_ACT_ALLOW, name, conditions);
    }
    // The call is not made, and fails with this error.
    void fail(const char* name, unsigned error) { add(SCMP_ACT_ERRNO(error), name, {}); }

    bool load() { return is_sound_ && context_ && seccomp_load(context_.get()) == 0; }

 private:
    void add(std::uint32_t action, const char* name, const std::vector<scmp_arg_cmp>& conditions) {
        const int call = seccomp_syscall_resolve_name(name);
        if (!context_ || call == __NR_SCMP_ERROR) return;
        const int result = seccomp_rule_add_array(context_.get(), action, call,
                                                  static_cast<unsigned>(conditions.size()), conditions.data());
        // -EDOM: not a call of this architecture; -EEXIST: the same twice
        is_sound_ = is_sound_ && (result == 0 || result == -EDOM || result == -EEXIST);
    }

    std::unique_ptr<Context, decltype(&seccomp_release)> context_;
    bool is_sound_ = true;
};

// Of an int: the kernel ignores the upper half of its register.
scmp_arg_cmp equals(unsigned argument, int value) {
    return {argument, SCMP_CMP_MASKED_EQ, 0xFFFFFFFF, static_cast<std::uint32_t>(value)};
}

scmp_arg_cmp is_null(unsigned argument) {
    return {argument, SCMP_CMP_EQ, 0, 0};
}

// None of these bits of an argument is set.
scmp_arg_cmp has_none_of(unsigned argument, std::uint64_t bits) {
    return {argument, SCMP_CMP_MASKED_EQ, bits, 0};
}

}  // namespace

bool forbid_all_but_reading(int answer_end) {
    constexpr std::uint64_t kWriting = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND | (O_TMPFILE & ~O_DIRECTORY);
    Filter filter;
    for (const char* name : kAllowed) filter.allow(name);
    filter.allow("open", {has_none_of(1, kWriting)});
    filter.allow("openat", {has_none_of(2, kWriting)});
    for (const int end : {answer_end, STDOUT_FILENO, STDERR_FILENO}) {
        for (const char* name : {"write", "writev"}) filter.allow(name, {equals(0, end)});
    }
    for (const char* name : {"mmap", "mmap2"}) {
        filter.allow(name, {has_none_of(2, PROT_EXEC | PROT_WRITE)});
        filter.allow(name, {has_none_of(2, PROT_EXEC), has_none_of(3, MAP_SHARED)});
    }
    filter.allow("mprotect", {has_none_of(2, PROT_EXEC)});
    for (const int command : {F_GETFD, F_GETFL}) filter.allow("fcntl", {equals(1, command)});
    filter.allow("prlimit64", {is_null(2)});          // to ask, not to set
    filter.allow("tgkill", {equals(0, ::getpid())});  // abort()
    filter.fail("ioctl", ENOTTY);                     // isatty()
    filter.fail("prctl", EINVAL);                     // names of memory
    return filter.load();
}

}  // namespace selvedge::sim
