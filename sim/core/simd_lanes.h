#pragma once
// SIMD vectors of floats and ints, as wide as the instruction set of the source allows: 16 lanes with AVX-512, 8 with
// AVX2, otherwise 4. Arithmetic and comparisons are operators of the compiler's vector types; this header adds
// operations that have no operator, and loads and stores of points with four floats each. All give identical bits at
// every width, except functions that use multiply_add(). For kernels only (sim/core/simd_level.h): functions are
// inlined and in a namespace per instruction set, so that the linker cannot mix differently compiled versions.
#include <immintrin.h>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "sim/core/simd_level.h"

namespace selvedge::sim::lanes {

#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline namespace avx512 {

inline constexpr SimdLevel kLevel = SimdLevel::Avx512;
inline constexpr std::size_t kCount = 16;
using Floats [[gnu::vector_size(64)]] = float;
using Ints [[gnu::vector_size(64)]] = std::int32_t;  // a comparison gives 0 or -1 in each lane

[[gnu::always_inline]] inline Floats max(Floats a, Floats b) {
    return _mm512_max_ps(a, b);
}
[[gnu::always_inline]] inline Floats min(Floats a, Floats b) {
    return _mm512_min_ps(a, b);
}
[[gnu::always_inline]] inline Floats sqrt(Floats a) {
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

inline constexpr SimdLevel kLevel = SimdLevel::Avx2;
inline constexpr std::size_t kCount = 8;
using Floats [[gnu::vector_size(32)]] = float;
using Ints [[gnu::vector_size(32)]] = std::int32_t;

[[gnu::always_inline]] inline Floats max(Floats a, Floats b) {
    return _mm256_max_ps(a, b);
}
[[gnu::always_inline]] inline Floats min(Floats a, Floats b) {
    return _mm256_min_ps(a, b);
}
[[gnu::always_inline]] inline Floats sqrt(Floats a) {
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

inline constexpr SimdLevel kLevel = SimdLevel::Plain;
inline constexpr std::size_t kCount = 4;
using Floats [[gnu::vector_size(16)]] = float;
using Ints [[gnu::vector_size(16)]] = std::int32_t;

[[gnu::always_inline]] inline Floats max(Floats a, Floats b) {
    return _mm_max_ps(a, b);
}
[[gnu::always_inline]] inline Floats min(Floats a, Floats b) {
    return _mm_min_ps(a, b);
}
[[gnu::always_inline]] inline Floats sqrt(Floats a) {
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

// max(a, b) and min(a, b) return b in lanes where a or b is NaN. truncated() rounds toward zero. to_float() is exact
// for magnitudes up to 2^24. bits() packs a comparison into bits, lane 0 in the lowest. gather_pairs() loads
// from[index] into the lower 16 bits of each lane and from[index + 1] into the upper 16 bits.

// Loads and stores kCount consecutive values; no alignment is required.
[[gnu::always_inline]] inline Floats load(const float* from) {
    Floats a;
    std::memcpy(&a, from, sizeof a);
    return a;
}
[[gnu::always_inline]] inline void store(float* to, Floats a) {
    std::memcpy(to, &a, sizeof a);
}
[[gnu::always_inline]] inline Floats broadcast(float a) {
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
[[gnu::always_inline]] inline Ints broadcast_ints(std::int32_t a) {
    return a - Ints{};
}

[[gnu::always_inline]] inline Floats clamp_to_unit(Floats a) {
    return min(max(a, broadcast(0)), broadcast(1));
}

// a in lanes where the comparison is true, +0 in the others.
[[gnu::always_inline]] inline Floats where(Ints comparison, Floats a) {
    return Floats(comparison & Ints(a));
}

// The first and second value of each pair from gather_pairs(), sign-extended, as floats.
[[gnu::always_inline]] inline Floats first_of(Ints pairs) {
    return to_float((pairs << 16) >> 16);
}
[[gnu::always_inline]] inline Floats second_of(Ints pairs) {
    return to_float(pairs >> 16);
}

}  // namespace plain, avx2 or avx512
}  // namespace selvedge::sim::lanes

// Points of four floats each, moved between memory and lanes without gather instructions: each point is loaded with one
// 128-bit load, and x, y and z are then transposed into one vector each.

namespace selvedge::sim::lanes {

#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline namespace avx512 {

// a b + c: one rounding with AVX2 and AVX-512, two in plain kernels, which therefore differ in the last bit.
[[gnu::always_inline]] inline Floats multiply_add(Floats a, Floats b, Floats c) {
    return _mm512_fmadd_ps(a, b, c);
}
// x, y and z of each point in a, and w of each point in b.
[[gnu::always_inline]] inline Floats with_w_components(Floats a, Floats b) {
    return _mm512_mask_mov_ps(a, 0x8888, b);
}
[[gnu::always_inline]] inline Floats unpack_low(Floats a, Floats b) {
    return _mm512_unpacklo_ps(a, b);
}
[[gnu::always_inline]] inline Floats unpack_high(Floats a, Floats b) {
    return _mm512_unpackhi_ps(a, b);
}
template <int order>
[[gnu::always_inline]] inline Floats shuffle(Floats a, Floats b) {
    return _mm512_shuffle_ps(a, b, order);
}
// Point k of the row is loaded from from + index[4 k].
[[gnu::always_inline]] inline Floats gather_row(const float* from, const std::uint32_t* index) {
    Floats row = _mm512_castps128_ps512(_mm_load_ps(from + index[0]));
    row = _mm512_insertf32x4(row, _mm_load_ps(from + index[4]), 1);
    row = _mm512_insertf32x4(row, _mm_load_ps(from + index[8]), 2);
    return _mm512_insertf32x4(row, _mm_load_ps(from + index[12]), 3);
}
[[gnu::always_inline]] inline void scatter_row(float* to, const std::uint32_t* index, Floats row) {
    _mm_store_ps(to + index[0], _mm512_castps512_ps128(row));
    _mm_store_ps(to + index[4], _mm512_extractf32x4_ps(row, 1));
    _mm_store_ps(to + index[8], _mm512_extractf32x4_ps(row, 2));
    _mm_store_ps(to + index[12], _mm512_extractf32x4_ps(row, 3));
}

#elif defined(__AVX2__)
inline namespace avx2 {

[[gnu::always_inline]] inline Floats multiply_add(Floats a, Floats b, Floats c) {
    return _mm256_fmadd_ps(a, b, c);
}
[[gnu::always_inline]] inline Floats with_w_components(Floats a, Floats b) {
    return _mm256_blend_ps(a, b, 0x88);
}
[[gnu::always_inline]] inline Floats unpack_low(Floats a, Floats b) {
    return _mm256_unpacklo_ps(a, b);
}
[[gnu::always_inline]] inline Floats unpack_high(Floats a, Floats b) {
    return _mm256_unpackhi_ps(a, b);
}
template <int order>
[[gnu::always_inline]] inline Floats shuffle(Floats a, Floats b) {
    return _mm256_shuffle_ps(a, b, order);
}
[[gnu::always_inline]] inline Floats gather_row(const float* from, const std::uint32_t* index) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(from + index[0])), _mm_load_ps(from + index[4]), 1);
}
[[gnu::always_inline]] inline void scatter_row(float* to, const std::uint32_t* index, Floats row) {
    _mm_store_ps(to + index[0], _mm256_castps256_ps128(row));
    _mm_store_ps(to + index[4], _mm256_extractf128_ps(row, 1));
}

#else
inline namespace plain {

[[gnu::always_inline]] inline Floats multiply_add(Floats a, Floats b, Floats c) {
    return a * b + c;
}
[[gnu::always_inline]] inline Floats with_w_components(Floats a, Floats b) {
    const Floats zw = _mm_shuffle_ps(a, b, 0xFA);  // z z w w
    return _mm_shuffle_ps(a, zw, 0x84);            // x y z w
}
[[gnu::always_inline]] inline Floats unpack_low(Floats a, Floats b) {
    return _mm_unpacklo_ps(a, b);
}
[[gnu::always_inline]] inline Floats unpack_high(Floats a, Floats b) {
    return _mm_unpackhi_ps(a, b);
}
template <int order>
[[gnu::always_inline]] inline Floats shuffle(Floats a, Floats b) {
    return _mm_shuffle_ps(a, b, order);
}
[[gnu::always_inline]] inline Floats gather_row(const float* from, const std::uint32_t* index) {
    return _mm_load_ps(from + index[0]);
}
[[gnu::always_inline]] inline void scatter_row(float* to, const std::uint32_t* index, Floats row) {
    _mm_store_ps(to + index[0], row);
}

#endif

// kCount points, each as four consecutive floats: row j holds the points j, j + 4, j + 8 ...
struct Rows {
    Floats row[4];
};

// x, y and z of kCount points.
struct Xyz {
    Floats x, y, z;
};

// Loads the points at from + index[lane]. Pre: each address is aligned to 16 bytes; index counts floats, not points.
[[gnu::always_inline]] inline Rows gather_points(const float* from, const std::uint32_t* index) {
    return {{gather_row(from, index), gather_row(from, index + 1), gather_row(from, index + 2),
             gather_row(from, index + 3)}};
}
[[gnu::always_inline]] inline void scatter_points(float* to, const std::uint32_t* index, const Rows& points) {
    for (int j = 0; j < 4; ++j) scatter_row(to, index + j, points.row[j]);
}

[[gnu::always_inline]] inline Xyz transposed(const Rows& p) {
    const Floats xy01 = unpack_low(p.row[0], p.row[1]);
    const Floats zw01 = unpack_high(p.row[0], p.row[1]);
    const Floats xy23 = unpack_low(p.row[2], p.row[3]);
    const Floats zw23 = unpack_high(p.row[2], p.row[3]);
    return {shuffle<0x44>(xy01, xy23), shuffle<0xEE>(xy01, xy23), shuffle<0x44>(zw01, zw23)};
}

// The inverse of transposed(), with `fourth` (zero by default) as w of each point.
[[gnu::always_inline]] inline Rows rows_of(const Xyz& p, Floats fourth = Floats{}) {
    const Floats xy_low = unpack_low(p.x, p.y);
    const Floats xy_high = unpack_high(p.x, p.y);
    const Floats zw_low = unpack_low(p.z, fourth);
    const Floats zw_high = unpack_high(p.z, fourth);
    return {{shuffle<0x44>(xy_low, zw_low), shuffle<0xEE>(xy_low, zw_low), shuffle<0x44>(xy_high, zw_high),
             shuffle<0xEE>(xy_high, zw_high)}};
}

// Broadcasts w of each point of a row to all four components of that point.
[[gnu::always_inline]] inline Floats w_components(Floats row) {
    return shuffle<0xFF>(row, row);
}

// Takes one value per point in `lanes`, and broadcasts the values of the points in row j to all four components of each
// point.
template <int j>
[[gnu::always_inline]] inline Floats spread(Floats lanes) {
    return shuffle<j * 0x55>(lanes, lanes);
}

// 1 / sqrt(a) for a > 0 with a relative error below 1e-6: an estimate from the float's bits, then two Newton
// iterations with tuned constants.  (Moroz et al. 2018)
[[gnu::always_inline]] inline Floats inverse_root(Floats a) {
    Ints bits_of_a;
    std::memcpy(&bits_of_a, &a, sizeof a);
    const Ints estimate = 0x5F376908 - (bits_of_a >> 1);
    Floats y;
    std::memcpy(&y, &estimate, sizeof y);
    const Floats half = broadcast(-0.5F) * a;
    y = y * multiply_add(half * y, y, broadcast(1.5008789F));
    return y * multiply_add(half * y, y, broadcast(1.5000006F));
}

}  // namespace plain, avx2 or avx512
}  // namespace selvedge::sim::lanes
