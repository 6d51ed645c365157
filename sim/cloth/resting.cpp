#include "sim/cloth/resting.h"

#include <algorithm>

#include "sim/cloth/cloth.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/step.h"

namespace selvedge::sim {
namespace {

bool has_other_surroundings(RestingState& resting, const Collider& body, const StepOptions& options) {
    const bool is_same =
        resting.body == &body && resting.gravity == options.gravity && resting.contact == options.contact;
    resting.body = &body;
    resting.gravity = options.gravity;
    resting.contact = options.contact;
    return !is_same;
}

bool has_kinematic_target(const Cloth& cloth, std::span<const KinematicVertex> all) {
    return std::ranges::any_of(all, [&](const KinematicVertex& kinematic) {
        return (kinematic.to - cloth.x[kinematic.vertex].head<3>()).norm() > kKinematicReach;
    });
}

bool has_left_reach(const Cloth& cloth) {
    const std::vector<Vec4f>& anchors = cloth.solver->resting.anchors;
    return std::ranges::any_of(cloth.mesh.leaf_vertices(), [&](VertexId v) {
        return (cloth.x[v.value] - anchors[v.value]).squaredNorm() > kRestReach * kRestReach;
    });
}

// A cloth at rest has x = x_prev = anchors; any difference means that something else moved it. No criterion of stress
// is needed: the whole cloth rests, so nothing that moves hangs from what rests.
bool was_touched(const Cloth& cloth) {
    const std::vector<Vec4f>& anchors = cloth.solver->resting.anchors;
    return std::ranges::any_of(cloth.mesh.leaf_vertices(), [&](VertexId v) {
        return cloth.x[v.value] != anchors[v.value] || cloth.x_prev[v.value] != anchors[v.value];
    });
}

bool has_moved(const Cloth& cloth) {
    if (cloth.solver->resting.anchors.size() != cloth.x.size()) return true;
    return is_at_rest(cloth) ? was_touched(cloth) : has_left_reach(cloth);
}

}  // namespace

bool stays_at_rest(Cloth& cloth, const Collider& body, const StepOptions& options) {
    RestingState& resting = cloth.solver->resting;
    const bool is_elsewhere = has_other_surroundings(resting, body, options);
    if (!options.may_rest || is_elsewhere || !options.seams.empty() || has_kinematic_target(cloth, options.kinematic))
        reactivate(cloth);
    if (!options.may_rest) return false;
    if (resting.still_seconds == 0 || has_moved(cloth)) {
        resting.anchors = cloth.x;
        resting.still_seconds = 0;
    }
    const bool rested = is_at_rest(cloth);
    resting.still_seconds += step_seconds(cloth, options);
    if (is_at_rest(cloth) && !rested) resting.anchors = cloth.x_prev = cloth.x;
    return is_at_rest(cloth);
}

bool is_at_rest(const Cloth& cloth) {
    return cloth.solver->resting.still_seconds >= kRestSeconds;
}

void reactivate(Cloth& cloth) {
    cloth.solver->resting.still_seconds = 0;
}

}  // namespace selvedge::sim
