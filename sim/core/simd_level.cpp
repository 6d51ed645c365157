#include "sim/core/simd_level.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <string>

#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

constexpr const char* kVariable = "SELVEDGE_SIMD";
constexpr std::array kLevels{SimdLevel::Plain, SimdLevel::Avx2, SimdLevel::Avx512};

SimdLevel wanted_by_environment() {
    const char* text = std::getenv(kVariable);
    if (text == nullptr || *text == '\0') return SimdLevel::Avx512;
    for (const SimdLevel level : kLevels)
        if (name_of(level) == text) return level;
    throw InputError(kVariable, "", "'" + std::string(text) + "' is none of plain, avx2, avx512");
}

std::atomic<SimdLevel>& limit() {
    static std::atomic<SimdLevel> level = SimdLevel::Avx512;
    return level;
}

}  // namespace

std::string_view name_of(SimdLevel level) {
    switch (level) {
        case SimdLevel::Plain:
            return "plain";
        case SimdLevel::Avx2:
            return "avx2";
        case SimdLevel::Avx512:
            break;
    }
    return "avx512";
}

SimdLevel detected_simd_level() {
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return SimdLevel::Plain;
    const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                            __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return has_avx512 ? SimdLevel::Avx512 : SimdLevel::Avx2;
}

SimdLevel simd_level() {
    static const SimdLevel allowed = std::min(detected_simd_level(), wanted_by_environment());
    return std::min(allowed, limit().load(std::memory_order_relaxed));
}

SimdLimit::SimdLimit(SimdLevel level) : before_(limit()) {
    limit() = std::min(level, before_);
}

SimdLimit::~SimdLimit() {
    limit() = before_;
}

}  // namespace selvedge::sim
