#pragma once
// The same level everywhere: for experiments, tests and benches.
#include "sim/adaptive/adapt.h"

namespace selvedge {

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

}  // namespace selvedge
