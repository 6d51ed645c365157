#pragma once
// As many floats at once as the instructions that a source is compiled for allow: 16 with AVX-512, 8 with AVX2, else 4.
// Arithmetic and comparisons are the compiler's own on its vector types; here stands what it has no operator for, each
// with the same bits at every width. For kernels only (sim/core/simd_level.h): everything is inlined or named after its
// instructions, so that the linker cannot mix what was compiled differently.
#include <immintrin.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace selvedge::lanes {

#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline namespace avx512 {

inline constexpr std::size_t kCount = 16;
using Floats [[gnu::vector_size(64)]] = float;
using Ints [[gnu::vector_size(64)]] = std::int32_t;  // a comparison gives 0 or -1 in each lane

[[gnu::always_inline]] inline Floats greater(Floats a, Floats b) {
    return _mm512_max_ps(a, b);
}
[[gnu::always_inline]] inline Floats lesser(Floats a, Floats b) {
    return _mm512_min_ps(a, b);
}
[[gnu::always_inline]] inline Floats root(Floats a) {
    return _mm512_sqrt_ps(a);
}
[[gnu::always_inline]] inline Ints truncated(Floats a) {
    return Ints(_mm512_cvttps_epi32(a));
}
[[gnu::always_inline]] inline Floats to_float(Ints a) {
    return _mm512_cvtepi32_ps(__m512i(a));
}
[[gnu::always_inline]] inline unsigned bits(Ints mask) {
    return _mm512_movepi32_mask(__m512i(mask));
}
[[gnu::always_inline]] inline Ints gather(const std::int32_t* from, Ints index) {
    return Ints(_mm512_i32gather_epi32(__m512i(index), from, 4));
}
[[gnu::always_inline]] inline Floats gather(const float* from, Ints index) {
    return _mm512_i32gather_ps(__m512i(index), from, 4);
}
[[gnu::always_inline]] inline Ints gather_pairs(const std::int16_t* from, Ints index) {
    return Ints(_mm512_i32gather_epi32(__m512i(index), from, 2));
}

#elif defined(__AVX2__)
inline namespace avx2 {

inline constexpr std::size_t kCount = 8;
using Floats [[gnu::vector_size(32)]] = float;
using Ints [[gnu::vector_size(32)]] = std::int32_t;

[[gnu::always_inline]] inline Floats greater(Floats a, Floats b) {
    return _mm256_max_ps(a, b);
}
[[gnu::always_inline]] inline Floats lesser(Floats a, Floats b) {
    return _mm256_min_ps(a, b);
}
[[gnu::always_inline]] inline Floats root(Floats a) {
    return _mm256_sqrt_ps(a);
}
[[gnu::always_inline]] inline Ints truncated(Floats a) {
    return Ints(_mm256_cvttps_epi32(a));
}
[[gnu::always_inline]] inline Floats to_float(Ints a) {
    return _mm256_cvtepi32_ps(__m256i(a));
}
[[gnu::always_inline]] inline unsigned bits(Ints mask) {
    return unsigned(_mm256_movemask_ps(__m256(mask)));
}
[[gnu::always_inline]] inline Ints gather(const std::int32_t* from, Ints index) {
    return Ints(_mm256_i32gather_epi32(from, __m256i(index), 4));
}
[[gnu::always_inline]] inline Floats gather(const float* from, Ints index) {
    return _mm256_i32gather_ps(from, __m256i(index), 4);
}
[[gnu::always_inline]] inline Ints gather_pairs(const std::int16_t* from, Ints index) {
    const void* untyped = from;
    return Ints(_mm256_i32gather_epi32(static_cast<const int*>(untyped), __m256i(index), 2));
}

#else
inline namespace plain {

inline constexpr std::size_t kCount = 4;
using Floats [[gnu::vector_size(16)]] = float;
using Ints [[gnu::vector_size(16)]] = std::int32_t;

[[gnu::always_inline]] inline Floats greater(Floats a, Floats b) {
    return _mm_max_ps(a, b);
}
[[gnu::always_inline]] inline Floats lesser(Floats a, Floats b) {
    return _mm_min_ps(a, b);
}
[[gnu::always_inline]] inline Floats root(Floats a) {
    return _mm_sqrt_ps(a);
}
[[gnu::always_inline]] inline Ints truncated(Floats a) {
    return Ints(_mm_cvttps_epi32(a));
}
[[gnu::always_inline]] inline Floats to_float(Ints a) {
    return _mm_cvtepi32_ps(__m128i(a));
}
[[gnu::always_inline]] inline unsigned bits(Ints mask) {
    return unsigned(_mm_movemask_ps(__m128(mask)));
}
[[gnu::always_inline]] inline Ints gather(const std::int32_t* from, Ints index) {
    return Ints{from[index[0]], from[index[1]], from[index[2]], from[index[3]]};
}
[[gnu::always_inline]] inline Floats gather(const float* from, Ints index) {
    return Floats{from[index[0]], from[index[1]], from[index[2]], from[index[3]]};
}
[[gnu::always_inline]] inline Ints gather_pairs(const std::int16_t* from, Ints index) {
    std::int32_t pairs[4];
    for (int i = 0; i < 4; ++i) std::memcpy(&pairs[i], from + index[i], sizeof(std::int32_t));
    return Ints{pairs[0], pairs[1], pairs[2], pairs[3]};
}

#endif

// greater(a, b) and lesser(a, b) give b where a is no number. truncated() rounds to 0; to_float() is exact below 2^24.
// bits() packs a comparison, lane 0 lowest. gather_pairs() reads two neighbours at from[index], the first in the lower
// half; the index counts single ones.

// Lanes side by side in memory; the address may be any.
[[gnu::always_inline]] inline Floats load(const float* from) {
    Floats a;
    std::memcpy(&a, from, sizeof a);
    return a;
}
[[gnu::always_inline]] inline void store(float* to, Floats a) {
    std::memcpy(to, &a, sizeof a);
}
[[gnu::always_inline]] inline Floats all(float a) {
    return a - Floats{};
}
[[gnu::always_inline]] inline Ints load_ints(const std::uint32_t* from) {
    Ints a;
    std::memcpy(&a, from, sizeof a);
    return a;
}
[[gnu::always_inline]] inline void store_ints(std::uint32_t* to, Ints a) {
    std::memcpy(to, &a, sizeof a);
}
[[gnu::always_inline]] inline Ints all_ints(std::int32_t a) {
    return a - Ints{};
}

[[gnu::always_inline]] inline Floats held_to_unit(Floats a) {
    return lesser(greater(a, all(0)), all(1));
}

// a where the comparison holds, elsewhere +0.
[[gnu::always_inline]] inline Floats where(Ints comparison, Floats a) {
    return Floats(comparison & Ints(a));
}

// The halves of what gather_pairs() gave, with their signs.
[[gnu::always_inline]] inline Floats first_of(Ints pairs) {
    return to_float((pairs << 16) >> 16);
}
[[gnu::always_inline]] inline Floats second_of(Ints pairs) {
    return to_float(pairs >> 16);
}

}  // namespace plain, avx2 or avx512
}  // namespace selvedge::lanes
