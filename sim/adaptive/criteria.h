#pragma once
// Criteria that look at the surface alone. Each holds references to the state's arrays (not spans: an adaptation may
// grow them), indexed by vertex id; splits must set them for the new centre.  (SPEC 1.3)
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct CurvatureOptions {
    float split_angle = 0.35F;   // rad, a larger angle between the normals of an edge's ends asks for a split
    float rejoin_angle = 0.10F;  // rad, below split_angle

    bool operator==(const CurvatureOptions&) const = default;
};

// Split edges where the cloth bends, rejoin them where it lies flat: at both ends and at the centre, or a symmetric
// bump would be flattened away.  (thesis 3.4)
// Normal: a vector of three, or of four with a fourth 0; unit.
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
        return dot(edge.ends[0], edge.ends[1]) < split_cosine_;
    }
    bool wants_split(const AdaptiveMesh&, const LeafEdge& e) const { return dot(e.a, e.b) < split_cosine_; }

    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        return dot(edge.ends[0], edge.ends[1]) > rejoin_cosine_ && dot(edge.ends[0], edge.centre) > rejoin_cosine_ &&
               dot(edge.centre, edge.ends[1]) > rejoin_cosine_;
    }

 private:
    float dot(VertexId a, VertexId b) const { return normals_[a.value].dot(normals_[b.value]); }

    const std::vector<Normal>& normals_;
    float split_cosine_;
    float rejoin_cosine_;
};

struct LengthOptions {
    float split_compression = 0.05F;   // of the rest length; an edge compressed by more asks for a split
    float rejoin_compression = 0.02F;  // below split_compression
};

// Split edges that are compressed against their rest length: there the cloth must wrinkle.
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

// Buckling: an edge that is shorter than its material cannot lie straight, it must curve.  (SPEC 1.3; thesis ch. 6)
//
// LengthCriterion asks the same question with the ratio the other way up, compression c = 1 - 1/r: it is meant for
// cloth that is simulated, and starts where a wrinkle pays (c = 0.05, r = 1.053). Buckling is meant for the surface
// that is drawn, whose curves bulge with r from the first percent on, and so starts at 1.02. Two classes, so that
// either can be had by its own name and thresholds; the comparison itself stands in LengthCriterion alone.

struct BucklingOptions {
    float split_ratio = 1.02F;   // rest length / length; a larger ratio asks for a split
    float rejoin_ratio = 1.01F;  // 1 or more, below split_ratio
};

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

// Regions that are never coarser than a level: what an editor paints with a round brush.  (SPEC 1.3)

// One dab of the brush.
struct MinimumLevelDisc {
    std::uint16_t panel = 0;
    Vec2f centre = Vec2f::Zero();  // material coordinates, m
    float radius = 0;              // m
    int level = 0;
};

// Asks for splits until every leaf that touches a disc has its level, and lets none of them rejoin below it. An edge
// also asks for discs within its triangle's size: a neighbour that stays coarse would keep the disc's border coarse
// (permissions, SPEC 1.2). A disc ends at its panel's seams; paint both sides where the seam itself must be fine.
struct MinimumLevelCriterion {
    std::span<const MinimumLevelDisc> discs;

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return is_above(mesh, e); }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return !is_above(mesh, e); }

 private:
    bool is_above(const AdaptiveMesh& mesh, EdgeId e) const;
};

// From a point to a triangle in the plane, m; 0 inside. Pre: anticlockwise.
float distance_to_triangle(const Vec2f& p, const std::array<Vec2f, 3>& triangle);

// A criterion that is asked only while it is switched on: off, it asks for nothing, agrees to all and vetoes nothing.
// So one adapt() over all criteria serves every combination that a user can choose. One function for each combination
// would double with each criterion; a switch is one bool in a register, and always goes the same way.

// A batch is noted even while it is off: then it agrees to all.
template <EdgeCriterion Criterion>
struct OptionalCriterion {
    static constexpr bool is_batch = BatchCriterion<Criterion>;
    OptionalCriterion(bool on, const Criterion& asked) : is_on(on), criterion(asked) {}

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
    OptionalCriterion(bool on, const Criterion& asked) : is_on(on), criterion(asked) {}

    bool is_on;
    const Criterion& criterion;  // outlives this

    bool vetoes(const AdaptiveMesh& mesh, EdgeId e) const { return is_on && criterion.vetoes(mesh, e); }
};

template <class Criterion>
OptionalCriterion(bool, const Criterion&) -> OptionalCriterion<Criterion>;

// Several as one: it asks for a split if any does, and agrees to a rejoin if all do.
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

// The same level everywhere: for experiments, tests and benches.

// Asks for every split and agrees to no rejoin.
struct AlwaysSplit {
    bool wants_split(const AdaptiveMesh&, EdgeId) const { return true; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return false; }
};

// Keeps no state at all.
struct NoState {
    void on_capacity(std::size_t) {}
    void on_split(VertexId, VertexId, VertexId) {}
    void on_rejoin(VertexId) {}
};

// Refines what is coarser and coarsens what is finer, until all leaves are at this level. Pre: 0 <= level <= max_level.
template <AdaptObserver State>
AdaptReport set_uniform_level(AdaptiveMesh& mesh, State& state, int level) {
    SELVEDGE_ASSERT(level >= 0 && level <= mesh.max_level());
    return adapt(mesh, state, {.max_level = level}, AlwaysSplit{});
}

// Lets an edge speak for the finer edges beside it, which may not split before it does.
//
// Permissions let an edge split only between regular triangles (SPEC 1.2). In a straight fold the edges along the fold
// are flat and never ask, so that their triangles stay in S1..S6 and the fold stays at level 1, however much the edges
// across it ask. With look-ahead an edge also asks when a finer edge of its triangles does. It is a choice of the
// criterion, made outside of the mesh; the permissions stay as they are.

// What a criterion says of the leaf edges that are there before an adaptation, asked in one flat loop. Edges that are
// made, or made anew, while it is under way are to be forgotten: see forget().
class LeafAnswers {
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

    // The edges that are new when t has changed its configuration.
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

// Whether holds_for is true of one of the edges that are finer by a level in the triangles beside e, and not too short
// to be split.
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
    // Pre: criterion and answers outlive this; answers are those of the criterion, or there are none.
    explicit LookAheadCriterion(const Criterion& criterion, const SplitLimits& limits = {},
                                const LeafAnswers& answers = kNone)
        : criterion_(criterion), limits_(limits), answers_(answers) {}

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const {
        return asks(mesh, e) || finer_edges_ask(mesh, e, limits_);
    }

    // Else what was split for others' sake would rejoin and split again, turn by turn. Finer edges that are too short
    // to be split have a say here: they ask, and would be lost.
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const {
        return criterion_.allows_rejoin(mesh, e) && !finer_edges_ask(mesh, e, {});
    }

 private:
    static inline const LeafAnswers kNone{};

    bool asks(const AdaptiveMesh& mesh, EdgeId e) const { return answers_.wants_split(mesh, e, criterion_); }

    bool finer_edges_ask(const AdaptiveMesh& mesh, EdgeId e, const SplitLimits& limits) const {
        return any_finer_edge(mesh, e, limits, [&](EdgeId finer) { return asks(mesh, finer); });
    }

    const Criterion& criterion_;
    SplitLimits limits_;
    const LeafAnswers& answers_;
};

}  // namespace selvedge::sim
