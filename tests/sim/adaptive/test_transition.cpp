// Permissions of splits and rejoins (thesis fig. 3.11), configurations, and all transitions between them.
#include <gtest/gtest.h>
#include <algorithm>
#include <map>
#include <vector>

#include "sim/adaptive/check.h"
#include "sim/adaptive/configuration.h"
#include "sim/adaptive/criteria.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::sim::test {
namespace {

std::vector<Configuration> all_configurations() {
    std::vector<Configuration> all;
    for (std::size_t i = 0; i < kConfigurations; ++i) all.push_back(static_cast<Configuration>(i));
    return all;
}

// One base triangle with all edges split, whose configuration the test then sets.
AdaptiveMesh with_all_edges_split() {
    AdaptiveMesh mesh(one_triangle(), {.max_level = 1});
    for (std::uint32_t e = 0; e < 3; ++e) mesh.split(EdgeId(e));
    mesh.retriangulate(0);
    return mesh;
}

AdaptiveMesh in_configuration(Configuration c) {
    AdaptiveMesh mesh = with_all_edges_split();
    mesh.change_configuration(kOwner, Configuration::C0);
    mesh.change_configuration(kOwner, c);
    return mesh;
}

using Corners = std::array<VertexId, 3>;

std::map<Corners, TriangleId> triangles_inside(const AdaptiveMesh& mesh) {
    std::map<Corners, TriangleId> inside;
    const AdaptiveTriangle& owner = mesh.triangle(kOwner);
    for (std::size_t i = 0; i < layout(owner.configuration).triangle_count; ++i) {
        const TriangleId t = owner.internal_triangles[i];
        inside[mesh.triangle(t).vertices] = t;
    }
    return inside;
}

std::map<std::array<VertexId, 2>, EdgeId> edges_inside(const AdaptiveMesh& mesh) {
    std::map<std::array<VertexId, 2>, EdgeId> inside;
    const AdaptiveTriangle& owner = mesh.triangle(kOwner);
    for (std::size_t i = 0; i < layout(owner.configuration).edge_count; ++i) {
        const EdgeId e = owner.internal_edges[i];
        inside[mesh.edge(e).ends] = e;
    }
    return inside;
}

template <class Map>
auto keys(const Map& map) {
    std::vector<typename Map::key_type> all;
    for (const auto& [key, value] : map) all.push_back(key);
    return all;
}

// The number of leaf triangles found by triangles_at(), summed over all vertices.
std::size_t listed_corners(const AdaptiveMesh& mesh) {
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < 6; ++v) {
        for (const TriangleId t : mesh.triangles_at(VertexId(v))) {
            EXPECT_TRUE(is_leaf(mesh.triangle(t)));
            ++count;
        }
    }
    return count;
}

template <class F>
void for_each_transition(F&& f) {
    for (const Configuration from : all_configurations()) {
        for (const Configuration to : all_configurations()) {
            SCOPED_TRACE("C" + std::to_string(index_of(from)) + " to C" + std::to_string(index_of(to)));
            if (from != to) f(from, to);
        }
    }
}

TEST(Transition, directly_gives_the_same_triangles_as_by_way_of_none) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh direct = in_configuration(from);
        direct.change_configuration(kOwner, to);
        const AdaptiveMesh by_way_of_c0 = in_configuration(to);
        EXPECT_EQ(keys(triangles_inside(direct)), keys(triangles_inside(by_way_of_c0)));
        EXPECT_EQ(keys(edges_inside(direct)), keys(edges_inside(by_way_of_c0)));
        EXPECT_EQ(direct.triangles().size(), by_way_of_c0.triangles().size());
        EXPECT_EQ(direct.edges().size(), by_way_of_c0.edges().size());
    });
}

TEST(Transition, keeps_the_ids_of_all_that_both_configurations_share) {
    int kept = 0;
    for_each_transition([&](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        const auto old_triangles = triangles_inside(mesh);
        const auto old_edges = edges_inside(mesh);
        mesh.change_configuration(kOwner, to);
        for (const auto& [corners, id] : triangles_inside(mesh)) {
            if (!old_triangles.contains(corners)) continue;
            EXPECT_EQ(old_triangles.at(corners), id);
            ++kept;
        }
        for (const auto& [ends, id] : edges_inside(mesh)) {
            if (!old_edges.contains(ends)) continue;
            EXPECT_EQ(old_edges.at(ends), id);
            ++kept;
        }
    });
    EXPECT_GT(kept, 50);
}

TEST(Transition, updates_the_adjacency_of_vertices_and_the_sides_of_edges) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        mesh.change_configuration(kOwner, to);
        const std::size_t leaves = std::max<std::size_t>(1, layout(to).triangle_count);
        EXPECT_EQ(listed_corners(mesh), 3 * leaves);
        for (const auto& [corners, id] : triangles_inside(mesh)) {
            const AdaptiveTriangle& t = mesh.triangle(id);
            EXPECT_EQ(t.regular, to == Configuration::C10);
            for (std::size_t k = 0; k < 3; ++k) {
                const AdaptiveEdge& edge = mesh.edge(t.edges[k]);
                if (edge.level == 0) continue;  // an external edge that is whole in this configuration
                EXPECT_EQ(edge.sides[edge.ends[0] == t.vertices[k] ? 0 : 1], id);
                EXPECT_EQ(edge.ends[edge.ends[0] == t.vertices[k] ? 1 : 0], t.vertices[(k + 1) % 3]);
            }
        }
    });
}

TEST(Transition, keeps_the_material_coordinates_of_the_corners) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        mesh.change_configuration(kOwner, to);
        float area = to == Configuration::C0 ? material_area(mesh.triangle(kOwner).u) : 0.0F;
        for (const auto& [corners, id] : triangles_inside(mesh)) area += material_area(mesh.triangle(id).u);
        EXPECT_FLOAT_EQ(area, 0.375F);
    });
}

TEST(Transition, that_goes_there_and_back_leaves_nothing_behind) {
    for_each_transition([](Configuration from, Configuration to) {
        AdaptiveMesh mesh = in_configuration(from);
        const auto triangles = triangles_inside(mesh);
        const std::size_t edge_count = mesh.edges().size();
        mesh.change_configuration(kOwner, to);
        mesh.change_configuration(kOwner, from);
        EXPECT_EQ(keys(triangles_inside(mesh)), keys(triangles));
        EXPECT_EQ(mesh.edges().size(), edge_count);
    });
}

constexpr VertexId V0{0}, V1{1}, V2{2}, V3{3};

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
    // The children of these edges are unsplit, but they border the same S7 triangle, whose children are not all leaves.
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
    EXPECT_FALSE(mesh.may_rejoin(shared));                     // its left side is S7 with a refined child
    EXPECT_TRUE(mesh.may_rejoin(edge_between(mesh, V1, V3)));  // borders only the right triangle
}

}  // namespace
}  // namespace selvedge::sim::test

namespace selvedge::sim {
namespace {

constexpr std::array<std::size_t, kConfigurations> kStateOf = {0, 1, 2, 3, 4, 4, 5, 5, 6, 6, 7};
constexpr std::array<SplitMask, kStates> kSplitOf = {0, 1, 2, 4, 3, 6, 5, 7};

std::vector<Configuration> all_configurations() {
    std::vector<Configuration> all;
    for (std::size_t i = 0; i < kConfigurations; ++i) all.push_back(static_cast<Configuration>(i));
    return all;
}

std::vector<std::array<LocalPoint, 3>> triangles_of(Configuration c) {
    std::vector<std::array<LocalPoint, 3>> triangles;
    for (std::size_t i = 0; i < layout(c).triangle_count; ++i) triangles.push_back(layout(c).triangles[i].points);
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

using Triangles = std::vector<std::array<LocalPoint, 3>>;

// Integer coordinates of the local points of a triangle, so that areas are exact.
std::array<int, 2> place(LocalPoint p) {
    constexpr std::array<std::array<int, 2>, 6> kPlaces = {{{0, 0}, {8, 0}, {0, 8}, {4, 0}, {4, 4}, {0, 4}}};
    return kPlaces[p];
}

int twice_area(const std::array<LocalPoint, 3>& points) {
    const auto a = place(points[0]), b = place(points[1]), c = place(points[2]);
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

TEST(Configuration, each_belongs_to_its_state) {
    for (const Configuration c : all_configurations()) {
        EXPECT_EQ(state_of(c), kStateOf[index_of(c)]);
        EXPECT_EQ(layout(c).split, kSplitOf[kStateOf[index_of(c)]]);
    }
}

TEST(Configuration, has_the_triangles_that_the_thesis_draws) {
    EXPECT_EQ(triangles_of(Configuration::C0), Triangles{});
    EXPECT_EQ(triangles_of(Configuration::C1), (Triangles{{0, 3, 2}, {1, 2, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C2), (Triangles{{0, 1, 4}, {0, 4, 2}}));
    EXPECT_EQ(triangles_of(Configuration::C3), (Triangles{{0, 1, 5}, {1, 2, 5}}));
    EXPECT_EQ(triangles_of(Configuration::C4), (Triangles{{0, 3, 2}, {1, 4, 3}, {2, 3, 4}}));
    EXPECT_EQ(triangles_of(Configuration::C5), (Triangles{{0, 3, 4}, {0, 4, 2}, {1, 4, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C6), (Triangles{{0, 1, 4}, {0, 4, 5}, {2, 5, 4}}));
    EXPECT_EQ(triangles_of(Configuration::C7), (Triangles{{0, 1, 5}, {1, 4, 5}, {2, 5, 4}}));
    EXPECT_EQ(triangles_of(Configuration::C8), (Triangles{{0, 3, 5}, {1, 2, 5}, {1, 5, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C9), (Triangles{{0, 3, 5}, {1, 2, 3}, {2, 5, 3}}));
    EXPECT_EQ(triangles_of(Configuration::C10), (Triangles{{0, 3, 5}, {1, 4, 3}, {2, 5, 4}, {3, 4, 5}}));
}

TEST(Configuration, fills_its_triangle_without_overlap) {
    for (const Configuration c : all_configurations()) {
        if (c == Configuration::C0) continue;
        int sum = 0;
        for (const auto& points : triangles_of(c)) {
            EXPECT_GT(twice_area(points), 0);
            sum += twice_area(points);
        }
        EXPECT_EQ(sum, 64);
    }
}

TEST(Configuration, uses_each_internal_edge_twice_and_each_piece_of_an_external_edge_once) {
    for (const Configuration c : all_configurations()) {
        std::array<int, kLocalEdges> uses{};
        for (std::size_t i = 0; i < layout(c).triangle_count; ++i) {
            for (const LocalEdge e : layout(c).triangles[i].edges) ++uses[e];
        }
        if (c == Configuration::C0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool is_split = (layout(c).split >> k & 1) != 0;
            EXPECT_EQ(uses[k], is_split ? 0 : 1);
            EXPECT_EQ(uses[3 + 2 * k], is_split ? 1 : 0);
            EXPECT_EQ(uses[4 + 2 * k], is_split ? 1 : 0);
            EXPECT_EQ(uses[kFirstInternalEdge + k], k < layout(c).edge_count ? 2 : 0);
        }
    }
}

TEST(Transition, keeps_exactly_what_both_configurations_share) {
    for (const Configuration from : all_configurations()) {
        for (const Configuration to : all_configurations()) {
            const Transition& plan = transition(from, to);
            const Triangles old_triangles = triangles_of(from), new_triangles = triangles_of(to);
            Triangles shared;
            std::set_intersection(old_triangles.begin(), old_triangles.end(), new_triangles.begin(),
                                  new_triangles.end(), std::back_inserter(shared));
            Triangles kept;
            for (std::size_t i = 0; i < layout(to).triangle_count; ++i) {
                if (plan.triangle_from[i] == kNoSlot) continue;
                EXPECT_EQ(layout(from).triangles[plan.triangle_from[i]].points, layout(to).triangles[i].points);
                EXPECT_FALSE(plan.drops_triangle[plan.triangle_from[i]]);
                kept.push_back(layout(to).triangles[i].points);
            }
            std::sort(kept.begin(), kept.end());
            EXPECT_EQ(kept, shared);
        }
    }
}

TEST(Transition, to_the_same_configuration_is_no_work) {
    for (const Configuration c : all_configurations()) EXPECT_EQ(transition(c, c).work, 0);
}

TEST(MinimalChange, takes_the_diagonal_that_is_already_there) {
    EXPECT_EQ(minimal_change(Configuration::C1, 0b011), Configuration::C4);
    EXPECT_EQ(minimal_change(Configuration::C2, 0b011), Configuration::C5);
    EXPECT_EQ(minimal_change(Configuration::C2, 0b110), Configuration::C6);
    EXPECT_EQ(minimal_change(Configuration::C3, 0b110), Configuration::C7);
    EXPECT_EQ(minimal_change(Configuration::C3, 0b101), Configuration::C8);
    EXPECT_EQ(minimal_change(Configuration::C1, 0b101), Configuration::C9);
}

TEST(MinimalChange, stays_where_it_is_and_conforms_wherever_it_goes) {
    for (const Configuration from : all_configurations()) {
        EXPECT_EQ(minimal_change(from, layout(from).split), from);
        for (SplitMask split = 0; split < 8; ++split) EXPECT_EQ(layout(minimal_change(from, split)).split, split);
    }
}

TEST(MinimalChange, takes_the_first_where_both_are_equal) {
    EXPECT_EQ(minimal_change(Configuration::C0, 0b011), Configuration::C4);
    EXPECT_EQ(minimal_change(Configuration::C10, 0b110), Configuration::C6);
}

}  // namespace

}  // namespace selvedge::sim
