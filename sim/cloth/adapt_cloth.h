#pragma once
// Adapting a cloth: which criteria ask, and what a split or rejoin does to the state of its vertices.  (SPEC 1.3, 1.4)
#include <algorithm>
#include <span>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/back_face.h"
#include "sim/adaptive/criteria.h"
#include "sim/adaptive/triangle_budget.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/collision_criterion.h"

namespace selvedge::sim {

class Collider;

// Vetoes the split of edges that are short enough: below that size cloth of a real weight only crumples, and the solver
// has to carry the whole garment's tension through vertices that weigh next to nothing.
struct ShortestEdgeCriterion {
    static constexpr bool is_veto = true;
    float length = 0.02F;  // m

    bool vetoes(const AdaptiveMesh& mesh, EdgeId edge) const { return mesh.rest_length(edge) < length; }
};

// While the cloth comes to rest it keeps what is split, so that edges near a threshold do not split and rejoin for
// ever.
struct HoldCriterion {
    bool may_rejoin = true;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return may_rejoin; }
};

// Keeps single vertices: what is pinned or pulled by hand. Lists are short.
struct KeptVertexCriterion {
    std::span<const VertexId> vertices;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId edge) const {
        return std::ranges::find(vertices, mesh.centre(edge)) == vertices.end();
    }
};

struct CriteriaOptions {
    bool collision = true;
    bool curvature = true;
    bool length = true;
    bool buckling = false;

    bool operator==(const CriteriaOptions&) const = default;
};

// What decides between two diagonals where either conforms, see sim/adaptive/diagonal.h.
enum class DiagonalChoice { MinimalChange, Length, RestLength, Curvature };

struct AdaptClothOptions {
    CriteriaOptions criteria{};
    CurvatureOptions curvature{};
    LengthOptions length{};
    BucklingOptions buckling{};
    std::span<const MinimumLevelDisc> minimum_levels{};
    std::span<const VertexId> kept_vertices{};  // never rejoined, but where a limit of levels or a veto asks for it
    Visibility* visibility = nullptr;           // what it does not see is coarsened, when given
    TriangleBudget* budget = nullptr;           // kept to, when given: it scales the thresholds of all but collision
    float shortest_edge = 0.02F;                // m, an edge shorter than this is not split
    int max_level = kDeepestLevel;              // below the mesh's own
    bool may_rejoin = true;
    DiagonalChoice diagonal = DiagonalChoice::MinimalChange;
    TransitionCounts* transitions = nullptr;  // counted up when given
};

// One adaptation. Post: masses sum to what they were, solver lists and contact points are fresh.
AdaptReport adapt_cloth(Cloth& cloth, const Collider& body, const AdaptClothOptions& options = {},
                        const ContactOptions& contact = {});

}  // namespace selvedge::sim
