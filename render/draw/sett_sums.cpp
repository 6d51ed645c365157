#include "render/draw/sett_sums.h"

#include "render/scene/colour.h"
#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

SettSums sum_colours(const std::vector<sim::Rgb8>& colours) {
    SELVEDGE_ASSERT(!colours.empty());
    Vec3d mean = Vec3d::Zero();
    for (const sim::Rgb8& colour : colours) mean += to_linear(colour).cast<double>();
    mean /= static_cast<double>(colours.size());

    SettSums result;
    result.mean = mean.cast<float>();
    result.sums.push_back(Vec3f::Zero());
    Vec3d sum = Vec3d::Zero();
    for (const sim::Rgb8& colour : colours) {
        sum += to_linear(colour).cast<double>() - mean;
        result.sums.push_back(sum.cast<float>());
    }
    result.sums.back().setZero();
    return result;
}

}  // namespace

SettSums sum_warp(const sim::Sett& sett) {
    return sum_colours(thread_colours(sett));
}

SettSums sum_weft(const sim::Sett& sett) {
    return sum_colours(weft_thread_colours(sett));
}

}  // namespace selvedge::render
