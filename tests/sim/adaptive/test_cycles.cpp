// Hundreds of random adaptions: sound after each, back to the base mesh bit by bit, the same for the same seed.
#include <gtest/gtest.h>

#include <random>

#include "sim/adaptive/check.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

// A run of random adaptions, now eager to split, now to rejoin. Stops the test at the first broken invariant.
void adapt_at_random(AdaptiveMesh& mesh, PositionState& state, unsigned seed, int adaptions) {
    std::mt19937 random(seed);
    for (int i = 0; i < adaptions; ++i) {
        const double eagerness = static_cast<double>(random() % 100) / 100.0;
        const RandomCriterion criterion{random, eagerness, 1.0 - eagerness};
        adapt(mesh, state, {}, criterion);
        const std::vector<std::string> problems = check(mesh);
        ASSERT_TRUE(problems.empty()) << "seed " << seed << ", adaption " << i << ": " << problems.front();
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
    expect_cycles_to_come_back(make_square(), 60);
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

TEST(Cycles, with_the_same_seed_give_the_same_bits) {
    const GarmentMesh base = make_square();
    AdaptiveMesh first(base), second(base);
    PositionState first_state(base, first), second_state(base, second);
    adapt_at_random(first, first_state, 11, 20);
    adapt_at_random(second, second_state, 11, 20);
    EXPECT_EQ(Snapshot(first), Snapshot(second));
    EXPECT_EQ(first.leaves(), second.leaves());  // in the same order, too
    EXPECT_EQ(first_state, second_state);
    EXPECT_GT(first.leaf_triangles().size(), 32U);
}

// A pass either splits or rejoins, so that one of two states that follow each other holds all split edges of the other.
TEST(Cycles, reach_every_transition_that_a_pass_can_ask_for) {
    AdaptiveMesh mesh(make_square(), {.max_level = 2});
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
}  // namespace selvedge::test
