// How criteria combine, what an adaption asks, reports and tells the observer.
#include "sim/adaptive/adapt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "sim/adaptive/check.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

struct Fixed {
    bool split = false;
    bool rejoin = false;

    bool wants_split(const AdaptiveMesh&, EdgeId) const { return split; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return rejoin; }
};

struct FixedVeto {
    static constexpr bool is_veto = true;
    bool veto = false;

    bool vetoes(const AdaptiveMesh&, EdgeId) const { return veto; }
};

// Counts how often each edge is asked; changes nothing.
struct Counting {
    std::map<EdgeId, int>& splits;
    std::map<EdgeId, int>& rejoins;

    bool wants_split(const AdaptiveMesh&, EdgeId e) const { return ++splits[e] < 0; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId e) const { return ++rejoins[e] < 0; }
};

template <class... Criteria>
int leaves_after(int start_level, const Criteria&... criteria) {
    AdaptiveMesh mesh(one_triangle(), {.max_level = 1});
    NoState state;
    set_uniform_level(mesh, state, start_level);
    adapt(mesh, state, {}, criteria...);
    return static_cast<int>(mesh.leaf_triangles().size());
}

TEST(Criteria, split_when_any_asks) {
    EXPECT_EQ(leaves_after(0, Fixed{.split = true}, Fixed{.split = false}), 4);
    EXPECT_EQ(leaves_after(0, Fixed{.split = false}, Fixed{.split = true}), 4);
    EXPECT_EQ(leaves_after(0, Fixed{.split = false}, Fixed{.split = false}), 1);
}

TEST(Criteria, rejoin_only_when_all_agree) {
    EXPECT_EQ(leaves_after(1, Fixed{.rejoin = true}, Fixed{.rejoin = true}), 1);
    EXPECT_EQ(leaves_after(1, Fixed{.rejoin = true}, Fixed{.rejoin = false}), 4);
    EXPECT_EQ(leaves_after(1, Fixed{.rejoin = false}, Fixed{.rejoin = true}), 4);
}

TEST(Criteria, a_veto_forbids_what_all_ask_and_rejoins_what_none_lets_go) {
    EXPECT_EQ(leaves_after(0, Fixed{.split = true}, FixedVeto{.veto = true}), 1);
    EXPECT_EQ(leaves_after(0, Fixed{.split = true}, FixedVeto{.veto = false}), 4);
    EXPECT_EQ(leaves_after(1, Fixed{.rejoin = false}, FixedVeto{.veto = true}), 1);
    EXPECT_EQ(leaves_after(1, Fixed{.rejoin = false}, FixedVeto{.veto = false}), 4);
    EXPECT_EQ(leaves_after(1, Fixed{.rejoin = true}, FixedVeto{.veto = false}), 1);
    EXPECT_EQ(leaves_after(0, FixedVeto{.veto = false}, FixedVeto{.veto = true}, Fixed{.split = true}), 1);
}

TEST(Criteria, a_veto_alone_asks_for_nothing) {
    EXPECT_EQ(leaves_after(0, FixedVeto{.veto = false}), 1);
}

TEST(Adapt, that_changes_nothing_asks_each_edge_at_most_once) {
    AdaptiveMesh mesh(make_square());
    NoState state;
    std::mt19937 random(5);
    for (int i = 0; i < 4; ++i) adapt(mesh, state, {}, RandomCriterion{random, 0.7, 0.1});
    std::map<EdgeId, int> splits, rejoins;
    const LeafEdge* before = mesh.leaf_edges().data();
    const AdaptReport report = adapt(mesh, state, {}, Counting{splits, rejoins});
    EXPECT_FALSE(report.changed());
    EXPECT_EQ(report.transitions, 0);
    EXPECT_EQ(mesh.leaf_edges().data(), before);
    ASSERT_GT(splits.size(), 10U);
    ASSERT_GT(rejoins.size(), 10U);
    for (const auto& [edge, count] : splits) EXPECT_TRUE(count == 1 && !mesh.is_split(edge));
    for (const auto& [edge, count] : rejoins) EXPECT_TRUE(count == 1 && mesh.is_split(edge));
}

TEST(Adapt, makes_one_transition_per_triangle_however_many_edges_change) {
    AdaptiveMesh mesh(make_square(), {.max_level = 1});
    NoState state;
    TransitionCounts counts;
    const AdaptReport up = adapt(mesh, state, {.transitions = &counts}, AlwaysSplit{});
    EXPECT_EQ(up.splits, 56);
    EXPECT_EQ(up.transitions, 32);
    EXPECT_EQ(counts.between_states(0, 7), 32U);
    const AdaptReport down = adapt(mesh, state, {.max_level = 0, .transitions = &counts}, AlwaysSplit{});
    EXPECT_EQ(down.rejoins, 56);
    EXPECT_EQ(down.transitions, 32);
    EXPECT_EQ(counts.between_states(7, 0), 32U);
    EXPECT_EQ(counts.between_states(0, 4), 0U);
}

TEST(Adapt, counts_transitions_by_configuration_and_by_state) {
    AdaptiveMesh mesh(one_triangle(), {.max_level = 1});
    NoState state;
    TransitionCounts counts;
    const std::array<EdgeId, 3> e = mesh.triangle(TriangleId(0)).edges;
    adapt(mesh, state, {.transitions = &counts}, ChosenEdges{{e[1]}});
    adapt(mesh, state, {.transitions = &counts}, ChosenEdges{{e[0], e[1]}});
    EXPECT_EQ(counts.by_configuration[0][2], 1U);
    EXPECT_EQ(counts.by_configuration[2][5], 1U);  // keeps the diagonal that is there
    EXPECT_EQ(counts.between_states(2, 4), 1U);
}

TEST(Adapt, rejoins_what_lies_deeper_than_a_lowered_limit) {
    AdaptiveMesh mesh(make_square());
    NoState state;
    set_uniform_level(mesh, state, 3);
    adapt(mesh, state, {.max_level = 1}, Fixed{.split = true, .rejoin = false});
    EXPECT_EQ(mesh.leaf_triangles().size(), 128U);
    EXPECT_TRUE(check(mesh).empty());
}

TEST(Adapt, tells_the_observer_of_more_room_before_it_uses_it) {
    const GarmentMesh base = make_square({.columns = 8, .rows = 8});
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    const std::size_t before = state.x.size();
    set_uniform_level(mesh, state, 3);  // on_split fails the test when the centre lies beyond the state's arrays
    EXPECT_GT(state.x.size(), before);
    EXPECT_EQ(state.x.size(), mesh.vertex_capacity());
    EXPECT_EQ(std::count(state.is_used.begin(), state.is_used.end(), true), 4225);
}

TEST(Adapt, finds_the_same_ids_when_it_splits_again_what_it_just_rejoined) {
    AdaptiveMesh mesh(make_square(), {.max_level = 1});
    NoState state;
    const EdgeId e(7);
    adapt(mesh, state, {}, ChosenEdges{{e}});
    const Snapshot split(mesh);
    adapt(mesh, state, {}, ChosenEdges{});
    adapt(mesh, state, {}, ChosenEdges{{e}});
    EXPECT_EQ(Snapshot(mesh), split);
}

}  // namespace
}  // namespace selvedge::test
