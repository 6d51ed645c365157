#pragma once
// The SIMD instruction set that the kernels use. Each kernel is compiled once per level (selvedge_simd_sources in
// cmake/SelvedgeModule.cmake) and selected at run time. AVX2 and AVX-512 kernels use fused multiply-add and give
// identical bits; plain kernels differ from them by rounding. No kernel uses approximate reciprocal instructions.
#include <string_view>

namespace selvedge::sim {

enum class SimdLevel { Plain, Avx2, Avx512 };  // Plain: any x86-64. Avx512: F, BW, DQ and VL

std::string_view name_of(SimdLevel level);  // "plain", "avx2", "avx512"

// The highest level that this processor supports.
SimdLevel detected_simd_level();

// The level to use: the lowest of the detected level, the environment variable SELVEDGE_SIMD and the SimdLimit in
// force. Throws InputError if the variable is set and is not a level's name.
SimdLevel simd_level();

// The one of three sets of kernels that is compiled for the level.
template <class Kernels>
const Kernels& for_level(SimdLevel level, const Kernels& plain, const Kernels& avx2, const Kernels& avx512) {
    switch (level) {
        case SimdLevel::Avx512:
            return avx512;
        case SimdLevel::Avx2:
            return avx2;
        case SimdLevel::Plain:
            break;
    }
    return plain;
}

// Limits simd_level() to `level` during its lifetime, for tests and benchmarks. Limits nest. Do not construct or
// destroy one while kernels run.
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
