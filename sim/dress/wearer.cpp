#include "sim/dress/wearer.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "sim/place/limb_pieces.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

// The lowest joint of both arms, m; none if one of them was not found.
std::optional<double> lowest_of_arms(const BodyLimbs& limbs) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const LimbKind kind : kArms) {
        if (!limbs[kind].is_found) return std::nullopt;
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
    if (!body->stands_otherwise() || has_arms(placed, pattern, body->measured().limbs())) return body;
    const std::shared_ptr<const PreparedBody> as_given = body->as_given();
    const std::optional<double> dressed = lowest_of_arms(body->measured().limbs());
    const std::optional<double> given = lowest_of_arms(as_given->measured().limbs());
    return dressed && given && *given > *dressed ? as_given : body;
}

}  // namespace selvedge::sim
