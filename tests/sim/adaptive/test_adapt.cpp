// Adaptation: combination of criteria, the changes that the mesh reports, and hundreds of random adaptations. The mesh
// is valid after each, coarsening restores the base mesh bit by bit, and the same seed gives the same mesh.
#include <gtest/gtest.h>
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "sim/adaptive/adapt.h"
#include "sim/adaptive/check.h"
#include "sim/adaptive/criteria.h"
#include "sim/mesh/square.h"
#include "tests/sim/adaptive/fixtures.h"
#include "tests/support/right_wrong.h"

namespace selvedge::sim::test {
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

// Counts how often each edge is evaluated; changes nothing.
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
    AdaptiveMesh mesh(sim::make_square());
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
    AdaptiveMesh mesh(sim::make_square(), {.max_level = 1});
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
    EXPECT_EQ(counts.by_configuration[2][5], 1U);  // keeps the existing diagonal
    EXPECT_EQ(counts.between_states(2, 4), 1U);
}

TEST(Adapt, rejoins_what_lies_deeper_than_a_lowered_limit) {
    AdaptiveMesh mesh(sim::make_square());
    NoState state;
    set_uniform_level(mesh, state, 3);
    adapt(mesh, state, {.max_level = 1}, Fixed{.split = true, .rejoin = false});
    EXPECT_EQ(mesh.leaf_triangles().size(), 128U);
    EXPECT_TRUE(check(mesh).empty());
}

TEST(Adapt, tells_the_observer_of_more_room_before_it_uses_it) {
    const GarmentMesh base = sim::make_square({.columns = 8, .rows = 8});
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    const std::size_t before = state.x.size();
    set_uniform_level(mesh, state, 3);  // on_split fails the test if the id of the centre is beyond the state arrays
    EXPECT_GT(state.x.size(), before);
    EXPECT_EQ(state.x.size(), mesh.vertex_capacity());
    EXPECT_EQ(std::count(state.is_used.begin(), state.is_used.end(), true), 4225);
}

TEST(Adapt, finds_the_same_ids_when_it_splits_again_what_it_just_rejoined) {
    AdaptiveMesh mesh(sim::make_square(), {.max_level = 1});
    NoState state;
    const EdgeId e(7);
    adapt(mesh, state, {}, ChosenEdges{{e}});
    const Snapshot split(mesh);
    adapt(mesh, state, {}, ChosenEdges{});
    adapt(mesh, state, {}, ChosenEdges{{e}});
    EXPECT_EQ(Snapshot(mesh), split);
}

// The leaf lists by id, as a client would store them.
struct Copy {
    std::set<VertexId> vertices;
    std::map<EdgeId, LeafEdge> edges;
    std::map<TriangleId, LeafTriangle> triangles;
    std::map<EdgeId, Hinge> hinges;

    explicit Copy(const LeafLists& lists) : vertices(lists.vertices.begin(), lists.vertices.end()) {
        for (const LeafEdge& e : lists.edges) edges[e.edge] = e;
        for (const LeafTriangle& t : lists.triangles) triangles[t.triangle] = t;
        for (const Hinge& h : lists.hinges) hinges[h.edge] = h;
    }
    bool operator==(const Copy&) const = default;
};

template <class Key, class Value>
void take_over(std::map<Key, Value>& old, const std::map<Key, Value>& now, const std::vector<Key>& changed) {
    for (const Key key : changed) {
        if (const auto it = now.find(key); it != now.end()) old[key] = it->second;
    }
}

// Updates a copy using only the changes that the mesh reports.
void follow(Copy& copy, const Copy& now, const LeafChanges& changes) {
    for (const VertexId v : changes.vertices_removed) EXPECT_EQ(copy.vertices.erase(v), 1U);
    for (const EdgeId e : changes.edges_removed) {
        EXPECT_EQ(copy.edges.erase(e), 1U);
        copy.hinges.erase(e);
    }
    for (const TriangleId t : changes.triangles_removed) EXPECT_EQ(copy.triangles.erase(t), 1U);
    for (const VertexId v : changes.vertices_added) EXPECT_TRUE(copy.vertices.insert(v).second);
    for (const EdgeId e : changes.edges_added) EXPECT_FALSE(copy.edges.contains(e));
    for (const TriangleId t : changes.triangles_added) EXPECT_FALSE(copy.triangles.contains(t));
    for (const EdgeId e : changes.hinges_changed) EXPECT_TRUE(copy.hinges.contains(e));
    take_over(copy.edges, now.edges, changes.edges_added);
    take_over(copy.hinges, now.hinges, changes.edges_added);
    take_over(copy.hinges, now.hinges, changes.hinges_changed);
    take_over(copy.triangles, now.triangles, changes.triangles_added);
}

void follow_random_adaptations(const GarmentMesh& base, unsigned seed) {
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    std::mt19937 random(seed);
    Copy copy(mesh.leaves());
    std::size_t changes = 0;
    for (int i = 0; i < 40; ++i) {
        const double eagerness = static_cast<double>(random() % 100) / 100.0;
        adapt(mesh, state, {}, RandomCriterion{random, eagerness, 1.0 - eagerness});
        const Copy now(mesh.leaves());
        follow(copy, now, mesh.changes());
        changes += mesh.changes().triangles_added.size() + mesh.changes().hinges_changed.size();
        ASSERT_EQ(copy, now) << "seed " << seed << ", adaptation " << i;
        ASSERT_TRUE(check(mesh).empty()) << check(mesh).front();
    }
    EXPECT_GT(changes, 100U);
}

TEST(Changes, let_a_copy_of_the_lists_follow_them) {
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) follow_random_adaptations(sim::make_square(), seed);
    follow_random_adaptations(tube(5, 2), 6);
    follow_random_adaptations(octahedron(), 7);
    follow_random_adaptations(bow_tie(), 8);
    follow_random_adaptations(moebius_band(3), 9);
}

TEST(Changes, are_all_of_the_lists_of_a_fresh_mesh) {
    const AdaptiveMesh mesh(sim::make_square());
    EXPECT_EQ(mesh.changes().vertices_added.size(), 25U);
    EXPECT_EQ(mesh.changes().edges_added.size(), 56U);
    EXPECT_EQ(mesh.changes().triangles_added.size(), 32U);
    EXPECT_TRUE(mesh.changes().triangles_removed.empty());
}

TEST(Changes, are_none_when_nothing_changes) {
    AdaptiveMesh mesh(sim::make_square());
    NoState state;
    set_uniform_level(mesh, state, 1);
    EXPECT_FALSE(mesh.changes().triangles_added.empty());
    set_uniform_level(mesh, state, 1);
    EXPECT_TRUE(mesh.changes().triangles_added.empty() && mesh.changes().triangles_removed.empty());
    EXPECT_TRUE(mesh.changes().edges_added.empty() && mesh.changes().edges_removed.empty());
    EXPECT_TRUE(mesh.changes().vertices_added.empty() && mesh.changes().vertices_removed.empty());
    EXPECT_TRUE(mesh.changes().hinges_changed.empty());
}

// One split edge of a square: only elements at its two triangles change, whatever the size of the square.
TEST(Changes, of_one_split_are_as_few_in_a_large_mesh_as_in_a_small_one) {
    for (const int quads : {4, 40}) {
        AdaptiveMesh mesh(sim::make_square({.columns = quads, .rows = quads}));
        NoState state;
        EdgeId inner;
        for (const Hinge& h : mesh.hinges()) inner = h.edge;
        adapt(mesh, state, {}, ChosenEdges{{inner}});
        EXPECT_EQ(mesh.changes().triangles_removed.size(), 2U);
        EXPECT_EQ(mesh.changes().triangles_added.size(), 4U);
        EXPECT_EQ(mesh.changes().edges_removed.size(), 1U);
        EXPECT_EQ(mesh.changes().edges_added.size(), 4U);
        EXPECT_EQ(mesh.changes().vertices_added.size(), 1U);
        EXPECT_LE(mesh.changes().hinges_changed.size(), 4U);
    }
}

TEST(Changes, leave_what_did_not_change_in_its_place) {
    AdaptiveMesh mesh(sim::make_square());
    NoState state;
    const std::vector<LeafTriangle> before(mesh.leaf_triangles().begin(), mesh.leaf_triangles().end());
    adapt(mesh, state, {}, ChosenEdges{{mesh.hinges()[3].edge}});
    std::size_t moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) moved += mesh.leaf_triangles()[i] == before[i] ? 0 : 1;
    EXPECT_EQ(moved, 2U);
}

// Random adaptations with changing probabilities of splits and rejoins. Stops at the first broken invariant.
void adapt_at_random(AdaptiveMesh& mesh, PositionState& state, unsigned seed, int adaptations) {
    std::mt19937 random(seed);
    for (int i = 0; i < adaptations; ++i) {
        const double eagerness = static_cast<double>(random() % 100) / 100.0;
        const RandomCriterion criterion{random, eagerness, 1.0 - eagerness};
        adapt(mesh, state, {}, criterion);
        const std::vector<std::string> problems = check(mesh);
        ASSERT_TRUE(problems.empty()) << "seed " << seed << ", adaptation " << i << ": " << problems.front();
        ASSERT_EQ(static_cast<std::size_t>(std::count(state.is_used.begin(), state.is_used.end(), true)),
                  mesh.vertices().size());
    }
}

void expect_cycles_to_come_back(const GarmentMesh& base, int cycles, int max_level = 3) {
    AdaptiveMesh mesh(base, {.max_level = max_level});
    PositionState state(base, mesh);
    const PositionState first_state = state;
    const Snapshot first = Snapshot(mesh).cut_to(mesh);
    for (int cycle = 0; cycle < cycles; ++cycle) {
        adapt_at_random(mesh, state, static_cast<unsigned>(cycle), 6);
        if (testing::Test::HasFatalFailure()) return;
        set_uniform_level(mesh, state, 0);
        ASSERT_EQ(mesh.vertices().size(), base.x.size());
        ASSERT_EQ(mesh.triangles().size(), base.triangles.size());
        ASSERT_EQ(mesh.edges().size(), mesh.base_edge_count());
        ASSERT_EQ(Snapshot(mesh).cut_to(mesh), first) << "cycle " << cycle;
        for (std::size_t v = 0; v < base.x.size(); ++v) ASSERT_EQ(state.x[v], first_state.x[v]);
    }
}

TEST(Cycles, bring_a_square_back) {
    expect_cycles_to_come_back(sim::make_square(), 60);
}

TEST(Cycles, bring_one_triangle_back) {
    expect_cycles_to_come_back(one_triangle(), 60, 5);
}

TEST(Cycles, bring_two_triangles_that_share_a_vertex_back) {
    expect_cycles_to_come_back(bow_tie(), 40);
}

TEST(Cycles, bring_a_closed_surface_back) {
    expect_cycles_to_come_back(octahedron(), 40);
}

TEST(Cycles, bring_a_sewn_tube_back) {
    expect_cycles_to_come_back(tube(5, 2), 40);
}

TEST(Cycles, bring_two_sewn_panels_back) {
    expect_cycles_to_come_back(front_and_back(3, 1.3), 40);
}

TEST(Cycles, bring_panels_back_that_are_sewn_right_side_to_wrong_side) {
    GarmentMesh base = front_and_back(3, 1.3);
    mirror_panel(base, 1);
    expect_cycles_to_come_back(base, 40);
}

TEST(Cycles, bring_a_moebius_band_back) {
    expect_cycles_to_come_back(moebius_band(3), 40);
    GarmentMesh base = moebius_band(3);
    mirror_panel(base, 1);
    expect_cycles_to_come_back(base, 40);
    expect_cycles_to_come_back(moebius_band(1), 40);
}

TEST(Cycles, with_the_same_seed_give_the_same_bits) {
    const GarmentMesh base = sim::make_square();
    AdaptiveMesh first(base), second(base);
    PositionState first_state(base, first), second_state(base, second);
    adapt_at_random(first, first_state, 11, 20);
    adapt_at_random(second, second_state, 11, 20);
    EXPECT_EQ(Snapshot(first), Snapshot(second));
    EXPECT_EQ(first.leaves(), second.leaves());  // in the same order
    EXPECT_EQ(first_state, second_state);
    EXPECT_GT(first.leaf_triangles().size(), 32U);
}

// Between two retriangulations edges are either only split or only rejoined. So of two successive states of a triangle,
// the split edges of one include those of the other.
TEST(Cycles, reach_every_transition_that_a_pass_can_ask_for) {
    AdaptiveMesh mesh(sim::make_square(), {.max_level = 2});
    NoState state;
    TransitionCounts counts;
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) adapt(mesh, state, {.transitions = &counts}, RandomCriterion{random, 0.5, 0.5});
    for (SplitMask from = 0; from < 8; ++from) {
        for (SplitMask to = 0; to < 8; ++to) {
            const bool is_nested = (from & to) == from || (from & to) == to;
            EXPECT_EQ(counts.between_states(state_of(from), state_of(to)) > 0, is_nested && from != to)
                << int{from} << " to " << int{to};
        }
    }
}

}  // namespace
}  // namespace selvedge::sim::test
