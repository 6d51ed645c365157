// Which edges may split and rejoin (SPEC 1.2, fig. 3.11), and the trap.
#include <gtest/gtest.h>

#include "sim/adaptive/check.h"
#include "sim/adaptive/uniform.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

constexpr VertexId V0{0}, V1{1}, V2{2}, V3{3};
constexpr TriangleId kOwner{0};

std::size_t state_of_owner(const AdaptiveMesh& mesh) {
    return state_of(mesh.triangle(kOwner).configuration);
}

void split_edges(AdaptiveMesh& mesh, std::set<EdgeId> chosen) {
    NoState state;
    adapt(mesh, state, {}, ChosenEdges{std::move(chosen)});
    EXPECT_TRUE(check(mesh).empty()) << check(mesh).front();
}

TEST(Permission, lets_one_split_follow_another_in_the_same_triangle) {
    AdaptiveMesh mesh(one_triangle());
    const EdgeId e0 = edge_between(mesh, V0, V1), e1 = edge_between(mesh, V1, V2), e2 = edge_between(mesh, V2, V0);
    split_edges(mesh, {e0});
    EXPECT_EQ(state_of_owner(mesh), 1U);
    split_edges(mesh, {e0, e1});
    EXPECT_EQ(state_of_owner(mesh), 4U);
    split_edges(mesh, {e0, e1, e2});
    EXPECT_EQ(state_of_owner(mesh), 7U);
}

TEST(Permission, lets_an_irregular_triangle_go_to_any_state_at_once) {
    for (unsigned from = 0; from < 8; ++from) {
        for (unsigned to = 0; to < 8; ++to) {
            AdaptiveMesh mesh(one_triangle());
            std::set<EdgeId> before, after;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const EdgeId e = mesh.triangle(kOwner).edges[k];
                if ((from >> k & 1U) != 0) before.insert(e);
                if ((to >> k & 1U) != 0) after.insert(e);
            }
            split_edges(mesh, before);
            EXPECT_EQ(state_of_owner(mesh), state_of(static_cast<SplitMask>(from)));
            split_edges(mesh, after);
            EXPECT_EQ(state_of_owner(mesh), state_of(static_cast<SplitMask>(to)));
        }
    }
}

TEST(Permission, denies_a_split_inside_or_beside_an_irregular_triangle) {
    AdaptiveMesh mesh(two_triangles());
    const EdgeId shared = edge_between(mesh, V1, V2);
    split_edges(mesh, {shared});
    for (const EdgeId e : mesh.unsplit_edges(1)) EXPECT_FALSE(mesh.may_split(e));
    EXPECT_EQ(mesh.unsplit_edges(1).size(), 4U);  // two children, two internal edges
    for (const EdgeId e : mesh.unsplit_edges(0)) EXPECT_TRUE(mesh.may_split(e));
}

TEST(Permission, lets_a_child_split_only_when_both_neighbours_are_regular) {
    AdaptiveMesh mesh(two_triangles());
    const EdgeId shared = edge_between(mesh, V1, V2);
    const std::set<EdgeId> one_side = {shared, edge_between(mesh, V0, V1), edge_between(mesh, V0, V2)};
    split_edges(mesh, one_side);
    EXPECT_EQ(state_of_owner(mesh), 7U);
    EXPECT_FALSE(mesh.may_split(mesh.edge(shared).children[0]));
    std::set<EdgeId> both_sides = one_side;
    both_sides.insert({edge_between(mesh, V1, V3), edge_between(mesh, V3, V2)});
    split_edges(mesh, both_sides);
    EXPECT_TRUE(mesh.may_split(mesh.edge(shared).children[0]));
}

TEST(Permission, denies_a_split_at_the_maximum_level_and_of_a_split_edge) {
    AdaptiveMesh mesh(one_triangle(), {.max_level = 1});
    NoState state;
    set_uniform_level(mesh, state, 1);
    ASSERT_EQ(mesh.leaf_edges().size(), 9U);
    for (const LeafEdge& e : mesh.leaf_edges()) EXPECT_FALSE(mesh.may_split(e.edge));
    for (const EdgeId e : mesh.split_edges(0)) EXPECT_FALSE(mesh.may_split(e));
}

TEST(Permission, denies_a_rejoin_while_a_child_is_split) {
    AdaptiveMesh mesh(one_triangle());
    const EdgeId e0 = edge_between(mesh, V0, V1), e1 = edge_between(mesh, V1, V2), e2 = edge_between(mesh, V2, V0);
    split_edges(mesh, {e0, e1, e2});
    EXPECT_TRUE(mesh.may_rejoin(e0) && mesh.may_rejoin(e1) && mesh.may_rejoin(e2));
    split_edges(mesh, {e0, e1, e2, mesh.edge(e0).children[0]});
    EXPECT_FALSE(mesh.may_rejoin(e0));
    // Its neighbours' children are whole, but theirs is the same S7 triangle, which must stay as it is.
    EXPECT_FALSE(mesh.may_rejoin(e1));
    EXPECT_FALSE(mesh.may_rejoin(e2));
}

TEST(Permission, denies_a_rejoin_while_an_internal_edge_is_split) {
    AdaptiveMesh mesh(one_triangle());
    const std::set<EdgeId> external = {EdgeId(0), EdgeId(1), EdgeId(2)};
    split_edges(mesh, external);
    std::set<EdgeId> with_internal = external;
    with_internal.insert(mesh.triangle(kOwner).internal_edges[1]);
    split_edges(mesh, with_internal);
    for (const EdgeId e : external) EXPECT_FALSE(mesh.may_rejoin(e));
    split_edges(mesh, external);
    for (const EdgeId e : external) EXPECT_TRUE(mesh.may_rejoin(e));
}

TEST(Permission, binds_across_an_edge_but_not_beyond_the_neighbour) {
    AdaptiveMesh mesh(two_triangles());
    NoState state;
    set_uniform_level(mesh, state, 1);
    const EdgeId shared = edge_between(mesh, V1, V2);
    std::set<EdgeId> keep = {mesh.edge(edge_between(mesh, V0, V1)).children[0]};
    for (const EdgeId e : mesh.split_edges(0)) keep.insert(e);
    split_edges(mesh, keep);
    EXPECT_FALSE(mesh.may_rejoin(shared));                     // its left side is S7 with a split child
    EXPECT_TRUE(mesh.may_rejoin(edge_between(mesh, V1, V3)));  // borders the right triangle alone
}

}  // namespace
}  // namespace selvedge::test
