#include "sim/core/process_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

namespace selvedge::sim {
namespace {

#if defined(SELVEDGE_ADDRESS_SANITIZER)
constexpr bool kLimitMemory = false;
#else
constexpr bool kLimitMemory = true;
#endif

// Bytes.
std::size_t address_space_in_use() {
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    unsigned long pages = 0;
    if (file) {
        if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    return std::size_t(pages) * std::size_t(::sysconf(_SC_PAGESIZE));
}

}  // namespace

void limit_more_memory(std::size_t bytes) {
    if (!kLimitMemory) return;
    const rlim_t most = address_space_in_use() + bytes;
    const rlimit memory{most, most};
    ::setrlimit(RLIMIT_AS, &memory);
}

std::optional<std::size_t> address_space_left() {
    rlimit memory{};
    if (!kLimitMemory || ::getrlimit(RLIMIT_AS, &memory) != 0 || memory.rlim_cur == RLIM_INFINITY) return std::nullopt;
    const std::size_t used = address_space_in_use();
    return memory.rlim_cur > used ? memory.rlim_cur - used : 0;
}

}  // namespace selvedge::sim
