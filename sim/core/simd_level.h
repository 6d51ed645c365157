#pragma once
// Which vector instructions the kernels may use. Kernels are compiled once for each level (selvedge_simd_sources in
// cmake/SelvedgeModule.cmake) and chosen at run time. Those with fused multiply-add (AVX2, AVX-512) give the same bits,
// plain ones are off by rounding; none has approximate reciprocals.
#include <string_view>

namespace selvedge::sim {

enum class SimdLevel { Plain, Avx2, Avx512 };  // Plain: any x86-64. Avx512: F, BW, DQ and VL

std::string_view name_of(SimdLevel level);  // "plain", "avx2", "avx512"

// The highest that this processor has.
SimdLevel detected_simd_level();

// The one to use: the detected one, unless the environment variable SELVEDGE_SIMD or a SimdLimit names a lower.
// Throws InputError when the variable holds no level's name.
SimdLevel simd_level();

// Holds the level while it lives, for tests and measurements; limits nest. Not while kernels run.
class SimdLimit {
 public:
    explicit SimdLimit(SimdLevel level);
    ~SimdLimit();
    SimdLimit(const SimdLimit&) = delete;
    SimdLimit& operator=(const SimdLimit&) = delete;

 private:
    SimdLevel before_;
};

}  // namespace selvedge::sim
