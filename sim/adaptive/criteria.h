#pragma once
// Refinement and coarsening criteria that depend only on the surface: curvature, edge length, buckling, painted minimum
// levels; and how criteria are combined, switched and given look-ahead. Each holds references to the state arrays (not
// spans, because an adaptation may resize them), indexed by vertex id; the observer sets the values of each new centre.
// (thesis 3.4.2, 3.4.3)
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/adaptive/criteria_options.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// Split edges where the cloth bends, rejoin them where it lies flat. A rejoin compares the normals at both ends and at
// the centre; otherwise it would remove a symmetric bump.  (thesis 3.4.2) The sign of a normal on a cut means nothing
// (sim/adaptive/surface_normals.h), so angles there count as at most a right angle.
// Normal: a unit vector of three components, or of four with the fourth 0.
template <class Normal>
class CurvatureCriterion {
 public:
    explicit CurvatureCriterion(const std::vector<Normal>& normals, const CurvatureOptions& options = {})
        : normals_(normals),
          split_cosine_(std::cos(options.split_angle)),
          rejoin_cosine_(std::cos(options.rejoin_angle)) {
        SELVEDGE_ASSERT(options.rejoin_angle < options.split_angle);
    }

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        return dot(mesh, edge.ends[0], edge.ends[1]) < split_cosine_;
    }
    bool wants_split(const AdaptiveMesh& mesh, const LeafEdge& e) const { return dot(mesh, e.a, e.b) < split_cosine_; }

    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        return dot(mesh, edge.ends[0], edge.ends[1]) > rejoin_cosine_ &&
               dot(mesh, edge.ends[0], edge.centre) > rejoin_cosine_ &&
               dot(mesh, edge.centre, edge.ends[1]) > rejoin_cosine_;
    }

 private:
    float dot(const AdaptiveMesh& mesh, VertexId a, VertexId b) const {
        const float cosine = normals_[a.value].dot(normals_[b.value]);
        const bool is_on_cut = mesh.has_cuts() && (mesh.vertex(a).on_cut || mesh.vertex(b).on_cut);
        return is_on_cut ? std::abs(cosine) : cosine;
    }

    const std::vector<Normal>& normals_;
    float split_cosine_;
    float rejoin_cosine_;
};

// Split edges that are shorter than their rest length: there the cloth must wrinkle.  (thesis 3.4.2)
// Position is any vector type whose first three coefficients are the position, m.
template <class Position>
class LengthCriterion {
 public:
    explicit LengthCriterion(const std::vector<Position>& x, const LengthOptions& options = {})
        : x_(x), split_share_(1.0F - options.split_compression), rejoin_share_(1.0F - options.rejoin_compression) {
        SELVEDGE_ASSERT(split_share_ < rejoin_share_);
    }

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return is_shorter(mesh, e, split_share_); }
    bool wants_split(const AdaptiveMesh&, const LeafEdge& e) const {
        return is_shorter(e.a, e.b, split_share_ * e.rest_length);
    }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return !is_shorter(mesh, e, rejoin_share_); }

 private:
    bool is_shorter(const AdaptiveMesh& mesh, EdgeId e, float share) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        return is_shorter(edge.ends[0], edge.ends[1], share * edge.rest_length);
    }
    // limit: m
    bool is_shorter(VertexId from, VertexId to, float limit) const {
        const Vec3f a = x_[from.value].template head<3>();
        const Vec3f b = x_[to.value].template head<3>();
        return (b - a).squaredNorm() < limit * limit;
    }

    const std::vector<Position>& x_;
    float split_share_;
    float rejoin_share_;
};

// Buckling: an edge under compression cannot lie straight, it must curve.  (thesis 6.2.5)
//
// With r = rest length / length, LengthCriterion compares the same quantity as a compression c = 1 - 1/r. It is meant
// for the simulated cloth, where a split lets it wrinkle: at c = 0.01 (r = 1.010). Buckling is meant for the drawn
// curved surface, whose curves bulge with r already: at r = 1.02. These are two classes so that each has its own name
// and thresholds; only LengthCriterion has the comparison.

template <class Position>
class BucklingCriterion {
 public:
    explicit BucklingCriterion(const std::vector<Position>& x, const BucklingOptions& options = {})
        : length_(x, {.split_compression = 1.0F - 1.0F / options.split_ratio,
                      .rejoin_compression = 1.0F - 1.0F / options.rejoin_ratio}) {}

    template <class Edge>
    bool wants_split(const AdaptiveMesh& mesh, const Edge& e) const {
        return length_.wants_split(mesh, e);
    }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return length_.allows_rejoin(mesh, e); }

 private:
    LengthCriterion<Position> length_;
};

// Regions with a minimum level, which the user paints in the editor with a round brush.

// One stroke position of the brush.
struct MinimumLevelDisc {
    std::uint16_t panel = 0;
    Vec2f centre = Vec2f::Zero();  // material coordinates, m
    float radius = 0;              // m
    int level = 0;
};

// Requests splits until every leaf that touches a disc has at least the disc's level, and prevents rejoins below it.
// A triangle also requests splits for discs within the length of its longest side: a neighbour that stays coarse would
// keep the border of the disc coarse (permissions, thesis fig. 3.11). A disc ends at the seams of its panel; paint both
// panels where the seam itself must be fine.
struct MinimumLevelCriterion {
    std::span<const MinimumLevelDisc> discs;

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return is_above(mesh, e); }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return !is_above(mesh, e); }

 private:
    bool is_above(const AdaptiveMesh& mesh, EdgeId e) const;
};

// Distance from a point to a triangle in the plane, m; 0 inside. Pre: the triangle is anticlockwise.
float distance_to_triangle(const Vec2f& p, const std::array<Vec2f, 3>& triangle);

// A criterion with a switch. While off, it requests no split, agrees to every rejoin and vetoes nothing. So a single
// instantiation of adapt() over all criteria serves every combination that a user can choose; otherwise each further
// criterion would double the number of instantiations. The switch costs one well-predicted branch.

// A batch criterion gets note(e) even while it is off; then it agrees to every rejoin.
template <EdgeCriterion Criterion>
struct OptionalCriterion {
    static constexpr bool is_batch = BatchCriterion<Criterion>;
    OptionalCriterion(bool on, const Criterion& given) : is_on(on), criterion(given) {}

    bool is_on;
    const Criterion& criterion;  // outlives this

    template <class Edge>
    bool wants_split(const AdaptiveMesh& mesh, const Edge& e) const {
        return is_on && criterion.wants_split(mesh, e);
    }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return !is_on || criterion.allows_rejoin(mesh, e); }

    void note(EdgeId e) const requires is_batch { criterion.note(e); }
    std::span<const EdgeId> look(const AdaptiveMesh& mesh) const requires is_batch {
        return is_on ? criterion.look(mesh) : criterion.noted();
    }
};

template <VetoCriterion Criterion>
struct OptionalCriterion<Criterion> {
    static constexpr bool is_veto = true;
    OptionalCriterion(bool on, const Criterion& given) : is_on(on), criterion(given) {}

    bool is_on;
    const Criterion& criterion;  // outlives this

    bool vetoes(const AdaptiveMesh& mesh, EdgeId e) const { return is_on && criterion.vetoes(mesh, e); }
};

template <class Criterion>
OptionalCriterion(bool, const Criterion&) -> OptionalCriterion<Criterion>;

// Several criteria combined into one: requests a split if any does, and agrees to a rejoin if all do.
template <EdgeCriterion... Criteria>
class AnyOf {
 public:
    explicit AnyOf(const Criteria&... criteria) : criteria_(criteria...) {}

    template <class Edge>
    bool wants_split(const AdaptiveMesh& mesh, const Edge& e) const {
        return std::apply([&](const auto&... criterion) { return (criterion.wants_split(mesh, e) || ...); }, criteria_);
    }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        return std::apply([&](const auto&... criterion) { return (criterion.allows_rejoin(mesh, e) && ...); },
                          criteria_);
    }

 private:
    std::tuple<Criteria...> criteria_;
};

// Uniform refinement, for experiments, tests and benchmarks.

// Requests every split and agrees to no rejoin.
struct AlwaysSplit {
    bool wants_split(const AdaptiveMesh&, EdgeId) const { return true; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return false; }
};

// An observer without state.
struct NoState {
    void on_capacity(std::size_t) {}
    void on_split(VertexId, VertexId, VertexId) {}
    void on_rejoin(VertexId) {}
};

// Splits and rejoins edges until all leaves are at this level. Pre: 0 <= level <= max_level.
template <AdaptObserver State>
AdaptReport set_uniform_level(AdaptiveMesh& mesh, State& state, int level) {
    SELVEDGE_ASSERT(level >= 0 && level <= mesh.max_level());
    return adapt(mesh, state, {.max_level = level}, AlwaysSplit{});
}

// Look-ahead: an edge also requests a split on behalf of the finer edges beside it, which may not be split before it.
//
// The permissions let an edge split only between regular triangles (thesis fig. 3.11). In a straight fold the edges
// along the fold are flat and never request a split. So their triangles stay in S1..S6 and the fold stays at level 1,
// even if edges across the fold request splits. With look-ahead, an edge also requests a split when a finer edge of its
// triangles does. Look-ahead changes only the criterion; the permissions of the mesh are unchanged.

// Cached results of a criterion's wants_split for all leaf edges before an adaptation, computed in one flat loop. The
// results of edges that are created or rewritten during the adaptation must be discarded: see forget().
class CachedSplitRequests {
 public:
    template <EdgeCriterion Criterion>
    void ask(const AdaptiveMesh& mesh, const Criterion& criterion) {
        answers_.assign(mesh.edges().capacity(), Answer::None);
        for (const LeafEdge& e : mesh.leaf_edges()) {
            answers_[e.edge.value] = criterion.wants_split(mesh, e) ? Answer::Yes : Answer::No;
        }
    }

    template <EdgeCriterion Criterion>
    bool wants_split(const AdaptiveMesh& mesh, EdgeId e, const Criterion& criterion) const {
        const Answer answer = e.value < answers_.size() ? answers_[e.value] : Answer::None;
        if (answer == Answer::No || mesh.is_split(e)) return false;
        return answer == Answer::Yes || criterion.wants_split(mesh, e);
    }

    // Discards the results of the edges that may be new after a transition of t.
    void forget(const AdaptiveMesh& mesh, TriangleId t) {
        const AdaptiveTriangle& owner = mesh.triangle(t);
        for (std::size_t i = 0; i < layout(owner.configuration).edge_count; ++i) forget(owner.internal_edges[i]);
        for (const EdgeId e : owner.edges) {
            if (mesh.is_split(e)) forget_children(mesh, e);
        }
    }
    void forget_children(const AdaptiveMesh& mesh, EdgeId e) {
        for (const EdgeId child : mesh.edge(e).children) forget(child);
    }

 private:
    enum class Answer : std::uint8_t { None, No, Yes };
    void forget(EdgeId e) {
        if (e.value < answers_.size()) answers_[e.value] = Answer::None;
    }

    std::vector<Answer> answers_;  // by EdgeId
};

// Whether holds_for is true for an edge one level finer than e, in or on the two triangles beside e, that the limits
// allow to be split.
template <class Holds>
bool any_finer_edge(const AdaptiveMesh& mesh, EdgeId e, const SplitLimits& limits, const Holds& holds_for) {
    if (mesh.level(e) + 1 >= std::min(mesh.max_level(), limits.max_level)) return false;
    const auto holds = [&](EdgeId finer) { return limits.allow(mesh, finer) && holds_for(finer); };
    const auto holds_inside = [&](const AdaptiveTriangle& owner) {
        for (std::size_t i = 0; i < layout(owner.configuration).edge_count; ++i) {
            if (holds(owner.internal_edges[i])) return true;
        }
        for (const EdgeId outer : owner.edges) {
            if (!mesh.is_split(outer)) continue;
            const std::array<EdgeId, 2>& children = mesh.edge(outer).children;
            if (holds(children[0]) || holds(children[1])) return true;
        }
        return false;
    };
    const std::array<TriangleId, 2>& sides = mesh.edge(e).sides;
    return (sides[0] && holds_inside(mesh.triangle(sides[0]))) || (sides[1] && holds_inside(mesh.triangle(sides[1])));
}

template <EdgeCriterion Criterion>
class LookAheadCriterion {
 public:
    // Pre: criterion and answers outlive this; answers belong to this criterion, or are empty.
    explicit LookAheadCriterion(const Criterion& criterion, const SplitLimits& limits = {},
                                const CachedSplitRequests& answers = kNone)
        : criterion_(criterion), limits_(limits), answers_(answers) {}

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const {
        return requests_split(mesh, e) || finer_edges_ask(mesh, e, limits_);
    }

    // A finer edge that requests a split also prevents the rejoin; otherwise an edge that was split on its behalf would
    // rejoin and split in turns. Finer edges that are too short to be split count here, because a rejoin would remove
    // them.
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        return criterion_.allows_rejoin(mesh, e) && !finer_edges_ask(mesh, e, {});
    }

 private:
    static inline const CachedSplitRequests kNone{};

    bool requests_split(const AdaptiveMesh& mesh, EdgeId e) const { return answers_.wants_split(mesh, e, criterion_); }

    bool finer_edges_ask(const AdaptiveMesh& mesh, EdgeId e, const SplitLimits& limits) const {
        return any_finer_edge(mesh, e, limits, [&](EdgeId finer) { return requests_split(mesh, finer); });
    }

    const Criterion& criterion_;
    SplitLimits limits_;
    const CachedSplitRequests& answers_;
};

}  // namespace selvedge::sim
