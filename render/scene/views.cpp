#include "render/scene/views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/assert.h"

namespace selvedge {

bool is_detail(View view) {
    return view == View::Close || view == View::Hem;
}

std::vector<Vec3f> detail_patch(const std::vector<Vec3f>& garment, View view) {
    SELVEDGE_ASSERT(is_detail(view) && !garment.empty());
    Vec3f low = garment.front(), high = garment.front();
    for (const Vec3f& x : garment) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    constexpr float overlap = 0.02F;  // m, beyond the edge
    const float middle = (low.x() + high.x()) / 2, half = kDetailSize / 2;
    const float bottom = view == View::Close ? high.y() + overlap - kDetailSize : low.y() - overlap;
    float front = -std::numeric_limits<float>::infinity();
    for (const Vec3f& x : garment) {
        const bool is_inside = std::abs(x.x() - middle) < half && x.y() > bottom && x.y() < bottom + kDetailSize;
        if (is_inside) front = std::max(front, x.z());
    }
    if (!std::isfinite(front)) front = high.z();
    std::vector<Vec3f> corners;
    for (const float side : {-half, half}) {
        for (const float up : {0.0F, kDetailSize}) corners.emplace_back(middle + side, bottom + up, front);
    }
    return corners;
}

}  // namespace selvedge
