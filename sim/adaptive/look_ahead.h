#pragma once
// Lets an edge speak for the finer edges beside it, which may not split before it does.
//
// Permissions let an edge split only between regular triangles (SPEC 1.2). In a straight fold the edges along the fold
// are flat and never ask, so that their triangles stay in S1..S6 and the fold stays at level 1, however much the edges
// across it ask. With look-ahead an edge also asks when a finer edge of its triangles does. It is a choice of the
// criterion, made outside of the mesh; the permissions stay as they are.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/split_limits.h"

namespace selvedge {

// What a criterion says of the leaf edges that are there before an adaption, asked in one flat loop. Edges that are
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

}  // namespace selvedge
