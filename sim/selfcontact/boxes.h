#pragma once
// Axis-aligned boxes of four floats per corner, of which the fourth is ignored: one comparison per corner.
#include <emmintrin.h>

#include <limits>

#include "sim/core/math.h"

namespace selvedge::sim {

struct ContactBox {
    Vec4f low = Vec4f::Constant(std::numeric_limits<float>::max());  // m
    Vec4f high = Vec4f::Constant(std::numeric_limits<float>::lowest());
};

inline ContactBox around(const ContactBox& a, const ContactBox& b) {
    return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

inline bool overlap(const ContactBox& a, const ContactBox& b) {
    constexpr int kXyz = 7;
    const __m128 above = _mm_cmpgt_ps(_mm_load_ps(a.low.data()), _mm_load_ps(b.high.data()));
    const __m128 below = _mm_cmplt_ps(_mm_load_ps(a.high.data()), _mm_load_ps(b.low.data()));
    return (_mm_movemask_ps(_mm_or_ps(above, below)) & kXyz) == 0;
}

}  // namespace selvedge::sim
