#pragma once
// Adaptation of a cloth: the choice of criteria, and the state of the vertices that splits create.  (thesis 3.4)
#include <algorithm>
#include <functional>
#include <span>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/back_face.h"
#include "sim/adaptive/criteria.h"
#include "sim/adaptive/criteria_options.h"
#include "sim/adaptive/triangle_budget.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/collision_criterion.h"
#include "sim/cloth/contact_options.h"

namespace selvedge::sim {

class Collider;

// Vetoes the split of edges shorter than `length`: finer cloth of realistic weight only crumples, and the solver would
// have to transmit the tension of the whole garment through vertices of very small mass.
struct ShortestEdgeCriterion {
    static constexpr bool is_veto = true;
    float length = 0.02F;  // m

    bool vetoes(const AdaptiveMesh& mesh, EdgeId edge) const { return mesh.rest_length(edge) < length; }
};

// Prevents all rejoins if may_rejoin is false. Used while the cloth comes to rest, so that edges near a threshold do
// not split and rejoin for ever.
struct RejoinSwitch {
    bool may_rejoin = true;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return may_rejoin; }
};

// Prevents the rejoin of edges whose centre is one of these vertices, which are pinned or dragged by the user. Searches
// linearly, so the list should be short.
struct PinnedVertexCriterion {
    std::span<const VertexId> vertices;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId edge) const {
        return std::ranges::find(vertices, mesh.centre(edge)) == vertices.end();
    }
};

struct AdaptClothOptions {
    CriteriaOptions criteria{};
    CurvatureOptions curvature{};
    LengthOptions length{};
    BucklingOptions buckling{};
    std::span<const MinimumLevelDisc> minimum_levels{};
    std::span<const VertexId> kept_vertices{};  // not removed, except where max_level or a veto forces a rejoin
    Visibility* visibility = nullptr;           // optional: hidden parts are coarsened
    TriangleBudget* budget = nullptr;           // optional: scales the thresholds of curvature, length and buckling
    float shortest_edge = 0.02F;                // m, an edge shorter than this is not split
    int max_level = kDeepestLevel;              // if below the mesh's own, deeper edges are rejoined
    bool may_rejoin = true;
    TransitionCounts* transitions = nullptr;                // optional: each transition is counted here
    std::function<float(const Diagonal&)> diagonal_cost{};  // optional: a choice, see sim/adaptive/adaptive_mesh.h
};

// One adaptation. Post: the total mass is unchanged; solver lists and contact samples are up to date.
AdaptReport adapt_cloth(Cloth& cloth, const Collider& body, const AdaptClothOptions& options = {},
                        const ContactOptions& contact = {});

}  // namespace selvedge::sim
