#pragma once
// How a garment is dressed, and how far that has come. Apart from the dressing (sim/dress/dressing.h), so that who only
// stores, reports or parses options does not depend on the simulation.
#include <optional>

#include "sim/adaptive/criteria_options.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {

inline constexpr double kFinishTime = 0.2;  // s, of the finer sub-steps at the end of a drape

struct DressOptions {
    MeshOptions mesh{};
    std::optional<double> edge_length{};  // m, of the base mesh; overrides the pattern's
    int max_level = 3;
    std::optional<int> deepest_level{};  // to which max_level may be raised while the garment hangs; none: max_level
    double shortest_edge = 0.02;         // m, shorter edges are not split, regardless of max_level
    CriteriaOptions criteria{};
    CurvatureOptions curvature{};
    std::optional<int> triangle_budget{};  // target number of leaf triangles; none: no limit
    std::optional<Vec3f> seen_from{};      // unit, to a viewer: coarse where cloth faces away; none: nowhere
    std::optional<Fabric> fabric{};        // overrides the pattern's
    double max_seconds = 12;               // of simulated time, without sewing
    double finish_time = kFinishTime;      // s, see DrapeOptions
    bool has_gravity = true;
    bool self_collision = true;         // whether the cloth collides with itself
    bool may_rest = false;              // whether steps skip a cloth at rest (sim/cloth/resting.h)
    std::optional<double> most_work{};  // see DrapeOptions

    bool operator==(const DressOptions&) const = default;
};

enum class DressingStage {
    Place,  // the panels stand around the body, unsewn
    Sew,    // the seams are closing
    Relax,  // sewn, without gravity and friction: the tension of the seams relaxes
    Fall,   // under gravity until at rest, at the end in finer sub-steps
    Done    // at rest, out of time, or a value is not finite
};

}  // namespace selvedge::sim
