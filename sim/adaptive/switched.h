#pragma once
// A criterion that is asked only while it is switched on: off, it asks for nothing, agrees to all and vetoes nothing.
// So one adapt() over all criteria serves every combination that a user can choose. One function for each combination
// would double with each criterion; a switch is one bool in a register, and always goes the same way.
#include <tuple>

#include "sim/adaptive/adapt.h"

namespace selvedge {

// A batch is noted even while it is off: then it agrees to all.
template <EdgeCriterion Criterion>
struct Switched {
    static constexpr bool is_batch = BatchCriterion<Criterion>;
    Switched(bool on, const Criterion& asked) : is_on(on), criterion(asked) {}

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
struct Switched<Criterion> {
    static constexpr bool is_veto = true;
    Switched(bool on, const Criterion& asked) : is_on(on), criterion(asked) {}

    bool is_on;
    const Criterion& criterion;  // outlives this

    bool vetoes(const AdaptiveMesh& mesh, EdgeId e) const { return is_on && criterion.vetoes(mesh, e); }
};

template <class Criterion>
Switched(bool, const Criterion&) -> Switched<Criterion>;

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

}  // namespace selvedge
