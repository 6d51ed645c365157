#pragma once
// One adaptation (remeshing step): refine from level 0 down, then coarsen from the deepest level up. After each level
// the affected triangles are retriangulated. Criteria are evaluated per edge and combined at compile time: an edge is
// split if any criterion requests it and none vetoes; it is rejoined if any vetoes or all agree.  (thesis 3.4)
//
// A criterion has       bool wants_split(const AdaptiveMesh&, EdgeId) const;    called for unsplit edges
//                       bool allows_rejoin(const AdaptiveMesh&, EdgeId) const;  called for split edges
// A veto has            static constexpr bool is_veto = true;
//                       bool vetoes(const AdaptiveMesh&, EdgeId) const;         called for both
// A batch has           static constexpr bool is_batch = true;
//                       and is an expensive criterion, evaluated for many edges at once and only for edges that the
//                       other criteria leave undecided. adapt() calls note(e) for each such edge; look(mesh) evaluates
//                       them and returns them in the same order. Then wants_split or allows_rejoin is called as usual.
//                       A split is made if no veto applies by then, a rejoin if the other criteria still agree.
// The observer (the cloth, or a surface) holds the state by vertex id. It implements
//                       on_capacity(n)       the id capacity has become n: state arrays grow to n
//                       on_split(c, a, b)    c was created between a and b: set all values of c that criteria read
//                       on_rejoin(c)         c is about to be freed
// and, optionally,      before(t), after(t)  called before and after the configuration of t changes
//                       permits_rejoin(e)    asked last, when all criteria agree to the rejoin: false prevents it
// An adaptation that changes nothing evaluates each leaf edge, and each split edge with two leaf children, once.
//
// The header also defines SplitLimits, which says which edges may be split at all.
#include <algorithm>
#include <concepts>
#include <span>
#include <type_traits>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge::sim {

struct AdaptOptions {
    int max_level = kDeepestLevel;            // if below the mesh's own, deeper edges are rejoined where permitted
    TransitionCounts* transitions = nullptr;  // optional: each transition is counted here
};

struct AdaptReport {
    int splits = 0;
    int rejoins = 0;
    int transitions = 0;
    bool changed() const { return splits + rejoins > 0; }
};

template <class S>
concept AdaptObserver = requires(S& state, VertexId v, std::size_t capacity) {
    state.on_capacity(capacity);
    state.on_split(v, v, v);
    state.on_rejoin(v);
};

template <class C>
concept VetoCriterion = requires(const C& criterion, const AdaptiveMesh& mesh, EdgeId e) {
    requires C::is_veto;
    { criterion.vetoes(mesh, e) } -> std::same_as<bool>;
};

template <class C>
concept EdgeCriterion = VetoCriterion<C> || requires(const C& criterion, const AdaptiveMesh& mesh, EdgeId e) {
    { criterion.wants_split(mesh, e) } -> std::same_as<bool>;
    { criterion.allows_rejoin(mesh, e) } -> std::same_as<bool>;
};

template <class C>
concept BatchCriterion = EdgeCriterion<C> && requires(const C& criterion, const AdaptiveMesh& mesh, EdgeId e) {
    requires C::is_batch;
    criterion.note(e);
    { criterion.look(mesh) } -> std::convertible_to<std::span<const EdgeId>>;
};

namespace adapt_detail {

template <class C>
bool requests_split(const C& criterion, const AdaptiveMesh& mesh, EdgeId e) {
    if constexpr (VetoCriterion<C> || BatchCriterion<C>) {
        return false;
    } else {
        return criterion.wants_split(mesh, e);
    }
}

template <class C>
bool agrees_to_rejoin(const C& criterion, const AdaptiveMesh& mesh, EdgeId e) {
    if constexpr (VetoCriterion<C> || BatchCriterion<C>) {
        return true;
    } else {
        return criterion.allows_rejoin(mesh, e);
    }
}

template <class C>
bool vetoes(const C& criterion, const AdaptiveMesh& mesh, EdgeId e) {
    if constexpr (VetoCriterion<C>) {
        return criterion.vetoes(mesh, e);
    } else {
        return false;
    }
}

template <class... C>
bool is_vetoed([[maybe_unused]] const AdaptiveMesh& mesh, [[maybe_unused]] EdgeId e, const C&... criteria) {
    return (vetoes(criteria, mesh, e) || ...);
}

template <class... C>
inline constexpr bool has_batch = (BatchCriterion<C> || ...);

template <class... C>
void note([[maybe_unused]] EdgeId e, const C&... criteria) {
    const auto one = [&](const auto& criterion) {
        if constexpr (BatchCriterion<std::remove_cvref_t<decltype(criterion)>>) criterion.note(e);
    };
    (one(criteria), ...);
}

// Evaluates the batch criterion, if there is one, and calls then(e, criterion) for each noted edge.
template <class Then, class... C>
void look(const AdaptiveMesh& mesh, const Then& then, const C&... criteria) {
    static_assert((static_cast<int>(BatchCriterion<C>) + ... + 0) <= 1, "one batch at most");
    const auto one = [&](const auto& criterion) {
        if constexpr (BatchCriterion<std::remove_cvref_t<decltype(criterion)>>) {
            for (const EdgeId e : criterion.look(mesh)) then(e, criterion);
        }
    };
    (one(criteria), ...);
}

// Calls state.before(t) and state.after(t) around each transition if the observer has both functions.
template <class State, class Choice>
int retriangulate(AdaptiveMesh& mesh, State& state, int level, TransitionCounts* counts, const Choice& choice) {
    if constexpr (requires(TriangleId t) { state.before(t), state.after(t); }) {
        return mesh.retriangulate(level, counts, choice, state);
    } else {
        NoObserver watch;
        return mesh.retriangulate(level, counts, choice, watch);
    }
}

template <class State>
bool is_rejoin_permitted(State& state, EdgeId e) {
    if constexpr (requires { state.permits_rejoin(e); }) {
        return state.permits_rejoin(e);
    } else {
        return true;
    }
}

template <class State>
void split(AdaptiveMesh& mesh, State& state, EdgeId e) {
    const std::size_t capacity = mesh.vertex_capacity();
    const VertexId centre = mesh.split(e);
    if (mesh.vertex_capacity() != capacity) state.on_capacity(mesh.vertex_capacity());
    state.on_split(centre, mesh.end(e, 0), mesh.end(e, 1));
}

// Cheap tests come first: vetoes, and mesh.may_split(), which reads only the edge and its two sides.
template <class State, class... C>
int refine_level(AdaptiveMesh& mesh, State& state, int level, const C&... criteria) {
    int splits = 0;
    const auto split_one = [&](EdgeId e) {
        split(mesh, state, e);
        ++splits;
    };
    for (const EdgeId e : mesh.unsplit_edges(level)) {
        if (is_vetoed(mesh, e, criteria...) || !mesh.may_split(e)) continue;
        if ((requests_split(criteria, mesh, e) || ...)) {
            split_one(e);
        } else {
            note(e, criteria...);
        }
    }
    const auto ask = [&](EdgeId e, const auto& criterion) {
        if (criterion.wants_split(mesh, e) && !is_vetoed(mesh, e, criteria...)) split_one(e);
    };
    look(mesh, ask, criteria...);
    return splits;
}

template <class State, class... C>
int coarsen_level(AdaptiveMesh& mesh, State& state, int level, bool beyond_limit, const C&... criteria) {
    int rejoins = 0;
    const auto rejoin_one = [&](EdgeId e, bool is_forced) {
        if (!mesh.may_rejoin(e)) return;  // reads more of the mesh than the criteria do, so it comes last
        if (!is_forced && !is_rejoin_permitted(state, e)) return;
        state.on_rejoin(mesh.centre(e));
        mesh.rejoin(e);
        ++rejoins;
    };
    for (const EdgeId e : mesh.split_edges(level)) {
        if (!mesh.has_leaf_children(e)) continue;
        if (beyond_limit || is_vetoed(mesh, e, criteria...)) {
            rejoin_one(e, true);
        } else if ((agrees_to_rejoin(criteria, mesh, e) && ...)) {
            if constexpr (has_batch<C...>) {
                note(e, criteria...);
            } else {
                rejoin_one(e, false);
            }
        }
    }
    const auto ask = [&](EdgeId e, const auto& criterion) {
        if (criterion.allows_rejoin(mesh, e) && (agrees_to_rejoin(criteria, mesh, e) && ...)) rejoin_one(e, false);
    };
    look(mesh, ask, criteria...);
    return rejoins;
}

}  // namespace adapt_detail

// Pre: the state arrays have mesh.vertex_capacity() entries. Post: check(mesh) reports no new problem; the leaf lists
// are up to date, and mesh.changes() lists how they changed. For `choice` see sim/adaptive/adaptive_mesh.h.
template <class Choice, AdaptObserver State, EdgeCriterion... Criteria>
AdaptReport adapt_choosing(const Choice& choice, AdaptiveMesh& mesh, State& state, const AdaptOptions& options,
                           const Criteria&... criteria) {
    AdaptReport report;
    const int limit = std::min(options.max_level, mesh.max_level());
    for (int level = 0; level < limit; ++level) {
        const int splits = adapt_detail::refine_level(mesh, state, level, criteria...);
        if (splits > 0)
            report.transitions += adapt_detail::retriangulate(mesh, state, level, options.transitions, choice);
        report.splits += splits;
    }
    for (int level = mesh.max_level() - 1; level >= 0; --level) {
        const int rejoins = adapt_detail::coarsen_level(mesh, state, level, level >= limit, criteria...);
        if (rejoins > 0)
            report.transitions += adapt_detail::retriangulate(mesh, state, level, options.transitions, choice);
        report.rejoins += rejoins;
    }
    mesh.refresh_lists();
    return report;
}

template <AdaptObserver State, EdgeCriterion... Criteria>
AdaptReport adapt(AdaptiveMesh& mesh, State& state, const AdaptOptions& options, const Criteria&... criteria) {
    return adapt_choosing(MinimalChange{}, mesh, state, options, criteria...);
}

// Which edges may be split, by length and level.

struct SplitLimits {
    float shortest_edge = 0;        // m, an edge shorter than this is not split
    int max_level = kDeepestLevel;  // an edge of this level, or of the mesh's deepest level, is not split

    bool allow(const AdaptiveMesh& mesh, EdgeId e) const {
        return mesh.level(e) < std::min(max_level, mesh.max_level()) && mesh.rest_length(e) >= shortest_edge;
    }

    bool operator==(const SplitLimits&) const = default;
};

}  // namespace selvedge::sim
