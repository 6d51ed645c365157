// An adaptation allocates no memory in steady state. This program counts the calls of operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "sim/adaptive/criteria.h"
#include "sim/mesh/square.h"

namespace {
std::atomic<std::size_t> allocations{0};
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace selvedge::sim {
namespace {

void refine_and_coarsen(AdaptiveMesh& mesh, NoState& state) {
    for (const int level : {1, 3, 2, 3, 0}) set_uniform_level(mesh, state, level);
}

// Requests splits in a strip about x = at and allows rejoins elsewhere. wander() moves it along the same way each time.
struct Strip {
    float at;

    bool wants_split(const AdaptiveMesh& mesh, EdgeId e) const { return lies_inside(mesh, e); }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return !lies_inside(mesh, e); }

 private:
    bool lies_inside(const AdaptiveMesh& mesh, EdgeId e) const {
        const AdaptiveEdge& edge = mesh.edge(e);
        const AdaptiveTriangle& side = mesh.triangle(edge.sides[0] ? edge.sides[0] : edge.sides[1]);
        return std::abs(side.u[0].x() - at) < 0.2F;
    }
};

int wander(AdaptiveMesh& mesh, NoState& state) {
    int changes = 0;
    for (int turn = 0; turn < 20; ++turn) {
        const AdaptReport report = adapt(mesh, state, {}, Strip{0.05F * static_cast<float>(turn)});
        changes += report.splits + report.rejoins;
    }
    return changes;
}

TEST(Allocation, happens_while_the_mesh_first_grows_and_never_again) {
    AdaptiveMesh mesh(sim::make_square({.columns = 8, .rows = 8}));
    NoState state;
    const std::size_t at_start = allocations;
    refine_and_coarsen(mesh, state);
    const std::size_t after_growth = allocations;
    EXPECT_GT(after_growth, at_start);
    refine_and_coarsen(mesh, state);
    EXPECT_EQ(allocations, after_growth);
}

TEST(Allocation, does_not_happen_in_adaptations_once_the_mesh_was_as_large) {
    AdaptiveMesh mesh(sim::make_square({.columns = 8, .rows = 8}));
    NoState state;
    refine_and_coarsen(mesh, state);
    const std::size_t after_growth = allocations;
    EXPECT_GT(wander(mesh, state), 1000);
    EXPECT_EQ(allocations, after_growth);
}

TEST(Allocation, does_not_happen_when_one_edge_splits_and_rejoins) {
    AdaptiveMesh mesh(sim::make_square({.columns = 8, .rows = 8}));
    const auto split_and_rejoin = [&](EdgeId e) {
        mesh.split(e);
        mesh.retriangulate(0);
        mesh.refresh_lists();
        mesh.rejoin(e);
        mesh.retriangulate(0);
        mesh.refresh_lists();
    };
    for (int i = 0; i < 3; ++i) split_and_rejoin(EdgeId(7));
    const std::size_t after_warm_up = allocations;
    for (int i = 0; i < 100; ++i) split_and_rejoin(EdgeId(7));
    EXPECT_EQ(allocations, after_warm_up);
}

}  // namespace
}  // namespace selvedge::sim
