#include "sim/dress/wearer.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

// Of both arms, m; minus infinity if one was not found.
double lowest_of_arms(const BodyLimbs& limbs) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const LimbKind kind : kArms) {
        if (!limbs[kind].is_found) return -lowest;
        for (const LimbJoint& joint : limbs[kind].joints) lowest = std::min(lowest, joint.centre.y());
    }
    return lowest;
}

bool has_arms(const GarmentMesh& placed, const Pattern& pattern, const BodyLimbs& limbs) {
    const std::vector<bool> without = panels_without_arms(placed, pattern, limbs);
    const auto is_with = [&](const GarmentTriangle& t) { return !without[static_cast<std::size_t>(t.panel)]; };
    return std::ranges::any_of(placed.triangles, is_with);
}

}  // namespace

std::shared_ptr<const PreparedBody> wearer_of(const GarmentMesh& placed, const Pattern& pattern,
                                              const std::shared_ptr<const PreparedBody>& body) {
    const std::shared_ptr<const PreparedBody> as_given = body->as_given();
    if (!as_given) return body;
    const BodyLimbs &dressed = body->measured().limbs(), &given = as_given->measured().limbs();
    const bool is_in_way = lowest_of_arms(given) > lowest_of_arms(dressed);
    return is_in_way && !has_arms(placed, pattern, dressed) ? as_given : body;
}

}  // namespace selvedge::sim
