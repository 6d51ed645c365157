#pragma once
// Points of four floats each, moved between memory and lanes without gather instructions: whole points are loaded where
// they stand, and only what a kernel computes with is transposed. For kernels only, see sim/core/simd_lanes.h.
#include "sim/core/simd_lanes.h"

namespace selvedge::lanes {

#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline namespace avx512 {

// a b + c, rounded once where the processor can; so plain kernels differ from the others in the last bit.
[[gnu::always_inline]] inline Floats multiply_add(Floats a, Floats b, Floats c) {
    return _mm512_fmadd_ps(a, b, c);
}
// a, but with the fourth floats of b.
[[gnu::always_inline]] inline Floats with_fourths(Floats a, Floats b) {
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
// Point k of the row is the one at index[4 k].
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
[[gnu::always_inline]] inline Floats with_fourths(Floats a, Floats b) {
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
[[gnu::always_inline]] inline Floats with_fourths(Floats a, Floats b) {
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

// kCount points as they stand in memory: row j holds the points j, j + 4, j + 8 ...
struct Rows {
    Floats row[4];
};

// x, y and z of kCount points.
struct Xyz {
    Floats x, y, z;
};

// The points at from + index[lane], all aligned to 16 bytes; index counts floats.
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

// Back again; 0 as the fourth float of each point unless it is given.
[[gnu::always_inline]] inline Rows rows_of(const Xyz& p, Floats fourth = Floats{}) {
    const Floats xy_low = unpack_low(p.x, p.y);
    const Floats xy_high = unpack_high(p.x, p.y);
    const Floats zw_low = unpack_low(p.z, fourth);
    const Floats zw_high = unpack_high(p.z, fourth);
    return {{shuffle<0x44>(xy_low, zw_low), shuffle<0xEE>(xy_low, zw_low), shuffle<0x44>(xy_high, zw_high),
             shuffle<0xEE>(xy_high, zw_high)}};
}

// The fourth float of each point of a row, in all four places.
[[gnu::always_inline]] inline Floats fourths(Floats row) {
    return shuffle<0xFF>(row, row);
}

// Of one value per lane, those of the points in row j, each in all four places.
template <int j>
[[gnu::always_inline]] inline Floats spread(Floats lanes) {
    return shuffle<j * 0x55>(lanes, lanes);
}

// 1 / sqrt(a) to about 5e-7, of positive a: an estimate from the exponent, then Newton's
// iteration twice with adjusted constants.  (Moroz et al. 2018)
[[gnu::always_inline]] inline Floats inverse_root(Floats a) {
    Ints bits_of_a;
    std::memcpy(&bits_of_a, &a, sizeof a);
    const Ints estimate = 0x5F376908 - (bits_of_a >> 1);
    Floats y;
    std::memcpy(&y, &estimate, sizeof y);
    const Floats half = all(-0.5F) * a;
    y = y * multiply_add(half * y, y, all(1.5008789F));
    return y * multiply_add(half * y, y, all(1.5000006F));
}

}  // namespace plain, avx2 or avx512
}  // namespace selvedge::lanes
