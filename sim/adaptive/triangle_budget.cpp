#include "sim/adaptive/triangle_budget.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {
namespace {

constexpr float kGreatestAngle = 3.0F;         // rad, maximum scaled split angle: close to opposite normals (pi)
constexpr float kGreatestCompression = 0.98F;  // maximum scaled split compression: the threshold length stays above 0

}  // namespace

TriangleBudget::TriangleBudget(const BudgetOptions& options) : options_(options) {
    SELVEDGE_ASSERT(options.band > 0 && options.gain > 0 && options.min_scale < options.max_scale);
}

void TriangleBudget::start(const AdaptiveMesh& mesh) {
    const auto target = static_cast<float>(std::max<std::size_t>(options_.target, 1));
    count_ = static_cast<std::ptrdiff_t>(mesh.leaf_triangles().size());
    lower_ = std::lround(target * (1 - options_.band));
    upper_ = std::lround(target * (1 + options_.band));
    if (count_ < lower_ || count_ > upper_)
        scale_ *= std::exp(options_.gain * std::log(static_cast<float>(count_) / target));
    scale_ = std::clamp(scale_, options_.min_scale, options_.max_scale);
    is_at_end_ = scale_ >= options_.max_scale;
}

CurvatureOptions scaled(const CurvatureOptions& options, float scale) {
    const float most = std::min(scale, kGreatestAngle / options.split_angle);
    return {.split_angle = options.split_angle * most, .rejoin_angle = options.rejoin_angle * most};
}

LengthOptions scaled(const LengthOptions& options, float scale) {
    const float most = std::min(scale, kGreatestCompression / options.split_compression);
    return {.split_compression = options.split_compression * most,
            .rejoin_compression = options.rejoin_compression * most};
}

BucklingOptions scaled(const BucklingOptions& options, float scale) {
    return {.split_ratio = 1 + (options.split_ratio - 1) * scale,
            .rejoin_ratio = 1 + (options.rejoin_ratio - 1) * scale};
}

}  // namespace selvedge::sim
