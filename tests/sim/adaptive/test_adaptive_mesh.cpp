// The adaptive mesh: base mesh, seams and hinges, choice of diagonals, counts and memory of uniform refinement; and
// check(), which must find faults as far as operations of the mesh can create them.
#include <gtest/gtest.h>
#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/adaptive/check.h"
#include "sim/adaptive/criteria.h"
#include "sim/adaptive/panel_lines.h"
#include "sim/core/error.h"
#include "sim/mesh/sew.h"
#include "sim/mesh/square.h"
#include "tests/sim/adaptive/fixtures.h"
#include "tests/support/right_wrong.h"

namespace selvedge::sim::test {
namespace {

// The sum of the rest lengths of an edge's leaves, which must equal its own.
float length_of_leaves(const AdaptiveMesh& mesh, EdgeId e) {
    if (!mesh.is_split(e)) return mesh.rest_length(e);
    const std::array<EdgeId, 2>& children = mesh.edge(e).children;
    return length_of_leaves(mesh, children[0]) + length_of_leaves(mesh, children[1]);
}

TEST(Seam, with_little_ease_takes_the_mean_of_both_sides_at_every_level) {
    AdaptiveMesh mesh(front_and_back(2, 1.04));
    const EdgeId seam = edge_between(mesh, VertexId(0), VertexId(4));
    EXPECT_NEAR(mesh.rest_length(seam), 0.2 * 1.02, 1e-6);
    NoState state;
    set_uniform_level(mesh, state, 3);
    EXPECT_FLOAT_EQ(length_of_leaves(mesh, seam), mesh.rest_length(seam));
    EXPECT_TRUE(check(mesh).empty()) << check(mesh).front();
}

// Front and back of one quad each, sewn along one edge; each triangle's side at the border has its own line.
GarmentMesh with_lines(GarmentMesh mesh) {
    std::map<std::pair<int, int>, int> uses;
    const auto key = [](const GarmentTriangle& t, std::size_t k) {
        return std::pair(std::minmax(t.vertices[k], t.vertices[(k + 1) % 3]));
    };
    for (const GarmentTriangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[key(t, k)];
    int next = 0;
    for (GarmentTriangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = key(t, k);
            const bool is_seam = a == 0 && b == 4;
            if (uses[{a, b}] == 1 || is_seam) t.lines[k].edge = next++;
        }
    }
    return mesh;
}

TEST(Lines, are_those_of_the_base_edge_at_every_level_and_of_both_panels_at_a_seam) {
    const GarmentMesh base = with_lines(front_and_back(1, 1.0));
    AdaptiveMesh mesh(base);
    NoState state;
    set_uniform_level(mesh, state, 3);
    std::map<std::pair<int, int>, float> found;  // m, by panel and edge
    int seams = 0;
    for (const LeafEdge& leaf : mesh.leaf_edges()) {
        const auto lines = lines_of(mesh, leaf.edge);
        const EdgeId of = base_of(mesh, leaf.edge);
        EXPECT_TRUE(!of || of.value < mesh.base_edge_count());
        if (lines[0] && lines[1]) ++seams;
        for (const auto& line : lines)
            if (line) found[{line->panel, line->edge}] += leaf.rest_length;
    }
    EXPECT_EQ(seams, 8);
    std::size_t expected = 0;
    for (const GarmentTriangle& t : base.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (t.lines[k].is_none()) continue;
            ++expected;
            const double length = (t.u[(k + 1) % 3] - t.u[k]).norm();
            EXPECT_NEAR(double(found[std::pair(t.panel, t.lines[k].edge)]), length, 1e-5);
        }
    }
    EXPECT_EQ(found.size(), expected);
}

TEST(Lines, of_an_edge_that_an_elastic_draws_together_have_its_rest_length) {
    GarmentMesh base = with_lines(front_and_back(1, 1.0));
    GarmentTriangle& drawn = base.triangles[0];
    const auto k = static_cast<std::size_t>(
        std::ranges::find_if(drawn.lines, [](const SideLine& line) { return !line.is_none(); }) - drawn.lines.begin());
    drawn.lines[k].drawn_to = 0.5F;
    const AdaptiveMesh mesh(base);
    const EdgeId edge = mesh.triangle(TriangleId(0)).edges[k];
    EXPECT_NEAR(mesh.rest_length(edge), 0.5 * (drawn.u[(k + 1) % 3] - drawn.u[k]).norm(), 1e-6);
}

TEST(Seam, with_gathers_takes_the_shorter_side) {
    const AdaptiveMesh mesh(front_and_back(2, 1.3));
    EXPECT_NEAR(mesh.rest_length(edge_between(mesh, VertexId(0), VertexId(4))), 0.2, 1e-6);
}

TEST(Seam, keeps_both_material_coordinates_when_its_edge_splits) {
    AdaptiveMesh mesh(front_and_back(1, 1.3));
    const EdgeId seam = edge_between(mesh, VertexId(0), VertexId(4));
    NoState state;
    adapt(mesh, state, {}, ChosenEdges{{seam}});
    const VertexId centre = mesh.centre(seam);
    int front = 0, back = 0;
    for (const TriangleId id : mesh.triangles_at(centre)) {
        const AdaptiveTriangle& t = mesh.triangle(id);
        const Vec2f u = t.u[corner_at(t, centre)];
        EXPECT_LT((u - (t.panel == 0 ? Vec2f(0.0F, 0.1F) : Vec2f(7.3F, 5.13F))).norm(), 1e-6F);
        ++(t.panel == 0 ? front : back);
    }
    EXPECT_EQ(front, 2);
    EXPECT_EQ(back, 2);
}

TEST(Seam, gives_internal_edges_the_length_of_their_own_panel) {
    AdaptiveMesh mesh(front_and_back(1, 1.3), {.max_level = 1});
    NoState state;
    set_uniform_level(mesh, state, 1);
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) {
        const AdaptiveTriangle& owner = mesh.triangle(TriangleId(t));
        for (const EdgeId e : owner.internal_edges) {
            const AdaptiveTriangle& side = mesh.triangle(mesh.edge(e).sides[0]);
            const std::size_t k = index_of(side, e);
            EXPECT_FLOAT_EQ(mesh.rest_length(e), (side.u[(k + 1) % 3] - side.u[k]).norm());
        }
    }
}

TEST(Seam, lets_a_hinge_measure_across_it) {
    AdaptiveMesh mesh(tube(5, 2));
    NoState state;
    set_uniform_level(mesh, state, 1);
    // The panel is flat and 0.5 m wide. Unfolded, hinges at the seam have the same shapes as all others.
    std::size_t upright = 0;
    for (const Hinge& h : mesh.hinges()) {
        const bool is_diagonal = h.rest_length > 0.06F;
        if (is_diagonal) continue;
        EXPECT_NEAR(h.rest_length, 0.05, 1e-6);
        EXPECT_NEAR((h.left_at - h.right_at).norm(), 0.05 * std::sqrt(5.0), 1e-6);
        upright += std::abs(h.along[0].y()) > 0.9F ? 1 : 0;
    }
    EXPECT_EQ(upright, 10U * 4U);  // ten columns of four edges each, including the seam's
}

TEST(Seam, has_no_jump_in_position_and_no_hole) {
    const GarmentMesh base = tube(6, 3);
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    set_uniform_level(mesh, state, 2);
    std::size_t boundary = 0;
    for (const LeafEdge& e : mesh.leaf_edges()) boundary += !mesh.leaf_at(e.edge, 0) || !mesh.leaf_at(e.edge, 1);
    EXPECT_EQ(boundary, 2U * 6U * 4U);  // only the two rims
    EXPECT_TRUE(check(mesh).empty());
}

TEST(Boundary, edges_split_and_rejoin_with_one_side) {
    AdaptiveMesh mesh(two_triangles(), {.max_level = 2});
    NoState state;
    const EdgeId rim = edge_between(mesh, VertexId(0), VertexId(1));
    ASSERT_TRUE(!mesh.edge(rim).sides[0] || !mesh.edge(rim).sides[1]);
    EXPECT_EQ(adapt(mesh, state, {}, ChosenEdges{{rim}}).transitions, 1);
    EXPECT_TRUE(check(mesh).empty());
    EXPECT_EQ(mesh.leaf_triangles().size(), 3U);
    EXPECT_EQ(adapt(mesh, state, {}, ChosenEdges{}).rejoins, 1);
    EXPECT_EQ(mesh.leaf_triangles().size(), 2U);
}

void expect_refused(const GarmentMesh& base, const std::string& message) {
    try {
        const AdaptiveMesh mesh(base);
        FAIL() << "took it";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()), message);
    }
}

TEST(BaseMesh, refuses_an_edge_with_three_triangles) {
    GarmentMesh base = two_triangles();
    base.x.emplace_back(0.0, 0.0, 1.0);
    base.triangles.push_back(base.triangles[0]);
    base.triangles.back().vertices = {1, 2, 4};
    expect_refused(base, "edge 1-2: is shared by 3 triangles");
}

// The panels whose right side is opposite to the orientation of the surface.
std::vector<int> turned_panels(const AdaptiveMesh& mesh) {
    std::set<int> panels;
    for (const LeafTriangle& t : mesh.leaf_triangles()) {
        if (t.turned) panels.insert(t.panel);
    }
    return {panels.begin(), panels.end()};
}

int count_right_wrong(const AdaptiveMesh& mesh) {
    int count = 0;
    for (const LeafEdge& e : mesh.leaf_edges()) count += mesh.edge(e.edge).right_wrong ? 1 : 0;
    return count;
}

int count_cuts(const AdaptiveMesh& mesh) {
    int count = 0;
    for (const LeafEdge& e : mesh.leaf_edges()) count += mesh.is_cut(e.edge) ? 1 : 0;
    return count;
}

TEST(RightWrong, both_sides_of_such_an_edge_have_it_in_its_direction) {
    GarmentMesh base = two_triangles();
    base.triangles[1].vertices = {1, 2, 3};
    std::swap(base.triangles[1].u[1], base.triangles[1].u[2]);
    for (Vec2d& u : base.triangles[1].u) u.x() *= -1;
    const AdaptiveMesh mesh(base);
    EXPECT_TRUE(check(mesh).empty());
    const EdgeId e = edge_between(mesh, VertexId(1), VertexId(2));
    EXPECT_TRUE(mesh.edge(e).right_wrong);
    EXPECT_EQ(mesh.edge(e).ends, (std::array{VertexId(1), VertexId(2)}));
    EXPECT_EQ(mesh.edge(e).sides, (std::array{TriangleId(0), TriangleId(1)}));
    // The hinge is that of two triangles that face the same way.
    const AdaptiveMesh plain(two_triangles());
    const Hinge &hinge = *mesh.hinge(e), &ordinary = *plain.hinge(edge_between(plain, VertexId(1), VertexId(2)));
    EXPECT_LT((hinge.left_at - ordinary.left_at).norm(), 1e-6F);
    EXPECT_LT((hinge.right_at - ordinary.right_at).norm(), 1e-6F);
}

TEST(RightWrong, turns_the_smaller_area_where_the_surface_can_be_oriented) {
    GarmentMesh base = front_and_back(2, 1.3);
    EXPECT_FALSE(AdaptiveMesh(base).has_right_wrong_edges());
    for (const int mirrored : {0, 1}) {
        GarmentMesh half = base;
        mirror_panel(half, mirrored);
        const AdaptiveMesh mesh(half);
        EXPECT_TRUE(check(mesh).empty());
        EXPECT_EQ(count_right_wrong(mesh), 4);  // two seams of two edges
        EXPECT_FALSE(mesh.has_cuts());
        EXPECT_EQ(turned_panels(mesh), std::vector<int>{0}) << "the back is larger";
    }
}

TEST(RightWrong, cuts_a_moebius_band_at_one_seam) {
    for (const int mirrored : {-1, 0, 1, 2}) {
        GarmentMesh base = moebius_band(3);
        mirror_panel(base, mirrored);
        const AdaptiveMesh mesh(base);
        EXPECT_TRUE(check(mesh).empty());
        EXPECT_TRUE(mesh.has_cuts());
        EXPECT_EQ(count_cuts(mesh), 2) << "one seam of two edges";
        const auto on_cut =
            std::ranges::count_if(mesh.leaf_vertices(), [&](VertexId v) { return mesh.vertex(v).on_cut; });
        EXPECT_EQ(on_cut, 3);
    }
}

// Whatever edges of a few panels are sewn, in whatever direction.
TEST(RightWrong, panels_sewn_at_random_make_a_sound_mesh) {
    std::mt19937 random(11);
    int with_cuts = 0;
    for (int run = 0; run < 150; ++run) {
        Pattern pattern;
        std::vector<SeamSide> free;
        for (int p = 0; p < 3; ++p) {
            Panel& panel = pattern.panels.emplace_back();
            panel.name = "panel" + std::to_string(p);
            panel.vertices = {{0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.2}};
            panel.translation = {0.5 * p, 0, 0};
            for (int e = 0; e < 4; ++e) {
                panel.edges.push_back({.start = e, .end = (e + 1) % 4});
                free.push_back({p, e});
            }
        }
        std::shuffle(free.begin(), free.end(), random);
        const std::size_t seams = 1 + random() % 5;
        for (std::size_t i = 0; i < seams; ++i)
            pattern.seams.push_back(
                {.first = free[2 * i], .second = free[2 * i + 1], .is_reversed = random() % 2 == 0});
        GarmentMesh base = assemble(pattern, {.target_edge = 0.1});
        merge_seams(base);
        AdaptiveMesh mesh(base, {.max_level = 2});
        ASSERT_TRUE(check(mesh).empty()) << "run " << run << ": " << check(mesh).front();
        with_cuts += mesh.has_cuts() ? 1 : 0;
        NoState state;
        for (int i = 0; i < 4; ++i) {
            adapt(mesh, state, {}, RandomCriterion{random, 0.5, 0.4});
            ASSERT_TRUE(check(mesh).empty()) << "run " << run << ": " << check(mesh).front();
        }
    }
    EXPECT_GT(with_cuts, 10);
    EXPECT_LT(with_cuts, 140);
}

// Round a vertex, the walk crosses each edge between its triangles; round an inner one it comes back.
TEST(RightWrong, the_walk_round_a_vertex_tells_which_triangles_look_the_other_way) {
    GarmentMesh base = moebius_band(3);
    mirror_panel(base, 1);
    AdaptiveMesh mesh(base);
    NoState state;
    set_uniform_level(mesh, state, 1);
    for (const VertexId v : mesh.leaf_vertices()) {
        std::map<TriangleId, bool> is_turned;
        const AdaptiveMesh::TrianglesAt around = mesh.triangles_at(v);
        for (auto at = around.begin(); at != around.end(); ++at) is_turned[*at] = at.is_turned();
        for (const LeafEdge& e : mesh.leaf_edges()) {
            if (e.a != v && e.b != v) continue;
            const TriangleId first = mesh.leaf_at(e.edge, 0), second = mesh.leaf_at(e.edge, 1);
            if (!first || !second) continue;
            EXPECT_EQ(is_turned.at(first) != is_turned.at(second), mesh.edge(e.edge).right_wrong);
        }
    }
}

TEST(BaseMesh, keeps_the_indices_of_vertices_and_triangles_as_ids) {
    const GarmentMesh base = sim::make_square();
    const AdaptiveMesh mesh(base);
    for (std::uint32_t t = 0; t < base.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const AdaptiveTriangle& triangle = mesh.triangle(TriangleId(t));
            EXPECT_EQ(static_cast<int>(triangle.vertices[k].value), base.triangles[t].vertices[k]);
            EXPECT_EQ(triangle.u[k], base.triangles[t].u[k].cast<float>());
        }
    }
}

constexpr SplitMask kTwoSplits[] = {0b011, 0b110, 0b101};

TEST(AmbiguousSplit, gives_the_two_configurations_of_a_state_and_their_own_diagonals) {
    const AmbiguousSplit ways = ambiguous_split(0b011);
    EXPECT_EQ(ways.configurations, (std::array{Configuration::C4, Configuration::C5}));
    EXPECT_EQ(ways.diagonals[0], (InternalEdge{{2, 3}}));
    EXPECT_EQ(ways.diagonals[1], (InternalEdge{{0, 4}}));
    for (const SplitMask split : kTwoSplits) {
        for (const Configuration c : ambiguous_split(split).configurations) EXPECT_EQ(layout(c).split, split);
    }
    for (const unsigned split : {0b000U, 0b001U, 0b010U, 0b100U, 0b111U}) {
        EXPECT_FALSE(is_ambiguous(static_cast<SplitMask>(split)));
    }
}

struct ShortestAtRest {
    float cost(const Diagonal& d) const { return (d.u_b - d.u_a).squaredNorm(); }
};

struct Avoids {
    VertexId vertex;
    float cost(const Diagonal& d) const { return d.a == vertex || d.b == vertex ? 1.0F : 0.0F; }
};

class Choice : public testing::Test {
 protected:
    // E0 and E1 split: the diagonals run from V2 to M0 (C4) and from V0 to M1 (C5).
    template <class C>
    Configuration chosen(const C& choice) {
        const std::set<EdgeId> two = {mesh.triangle(kOwner).edges[0], mesh.triangle(kOwner).edges[1]};
        adapt_choosing(choice, mesh, state, {}, ChosenEdges{two});
        EXPECT_TRUE(check(mesh).empty());
        const Configuration result = mesh.triangle(kOwner).configuration;
        adapt(mesh, state, {}, ChosenEdges{});
        return result;
    }

    GarmentMesh base = one_triangle();  // (0, 0) (1, 0) (0.25, 0.75)
    AdaptiveMesh mesh{base};
    PositionState state{base, mesh};
};

TEST_F(Choice, by_default_is_the_least_work) {
    EXPECT_EQ(chosen(MinimalChange{}), Configuration::C4);
}

TEST_F(Choice, takes_the_diagonal_of_lower_cost) {
    EXPECT_EQ(chosen(ShortestAtRest{}), Configuration::C5);  // 0.7289 against 0.7906 m
    EXPECT_EQ(chosen(Avoids{VertexId(2)}), Configuration::C5);
    EXPECT_EQ(chosen(Avoids{VertexId(0)}), Configuration::C4);
}

TEST_F(Choice, of_equal_cost_is_the_least_work) {
    EXPECT_EQ(chosen(Avoids{VertexId(1)}), Configuration::C4);
}

TEST_F(Choice, leaves_a_triangle_as_it_is_when_its_edges_do_not_change) {
    const std::set<EdgeId> two = {mesh.triangle(kOwner).edges[0], mesh.triangle(kOwner).edges[1]};
    adapt(mesh, state, {}, ChosenEdges{two});
    ASSERT_EQ(mesh.triangle(kOwner).configuration, Configuration::C4);
    adapt_choosing(ShortestAtRest{}, mesh, state, {}, ChosenEdges{two});
    EXPECT_EQ(mesh.triangle(kOwner).configuration, Configuration::C4);
}

TEST(Choices, keep_a_mesh_sound_in_random_adaptations) {
    const GarmentMesh base = sim::make_square();
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    std::mt19937 random(9);
    for (int i = 0; i < 40; ++i) {
        const RandomCriterion criterion{random, 0.5, 0.5};
        adapt_choosing(ShortestAtRest{}, mesh, state, {}, criterion);
        ASSERT_TRUE(check(mesh).empty()) << check(mesh).front();
    }
}

bool names(const std::vector<std::string>& problems, const std::string& problem) {
    return std::find(problems.begin(), problems.end(), problem) != problems.end();
}

TEST(Check, finds_nothing_in_a_fresh_mesh) {
    EXPECT_TRUE(check(AdaptiveMesh(tube(5, 3))).empty());
}

TEST(Check, names_the_triangles_of_a_pass_that_is_not_over) {
    AdaptiveMesh mesh(two_triangles());
    mesh.split(edge_between(mesh, VertexId(1), VertexId(2)));
    const std::vector<std::string> problems = check(mesh);
    EXPECT_TRUE(names(problems, "triangle 0: retriangulate() was not called"));
    EXPECT_TRUE(names(problems, "triangle 1: does not conform to its edges"));
    EXPECT_TRUE(names(problems, "triangle 0: a T-junction lies on its edge"));
    EXPECT_TRUE(names(problems, "vertices: the leaf list is not what a traversal finds"));
}

TEST(Check, names_a_triangle_that_was_left_whole_beside_a_split_edge) {
    AdaptiveMesh mesh(two_triangles(), {.max_level = 1});
    NoState state;
    set_uniform_level(mesh, state, 1);
    mesh.change_configuration(TriangleId(1), Configuration::C0);
    const std::vector<std::string> problems = check(mesh);
    EXPECT_TRUE(names(problems, "triangle 1: does not conform to its edges"));
    const EdgeId shared = edge_between(mesh, VertexId(1), VertexId(2));
    EXPECT_TRUE(names(problems, "edge " + std::to_string(shared.value) + ": a hole opens along a child"));
    EXPECT_TRUE(names(problems, "triangles: the leaf list is not what a traversal finds"));
}

TEST(Check, names_lists_that_are_out_of_date) {
    AdaptiveMesh mesh(two_triangles());
    mesh.split(EdgeId(0));
    mesh.retriangulate(0);
    EXPECT_TRUE(names(check(mesh), "edges: the leaf list is not what a traversal finds"));
    mesh.refresh_lists();
    EXPECT_TRUE(check(mesh).empty());
}

}  // namespace
}  // namespace selvedge::sim::test

namespace selvedge::sim {
namespace {

struct Row {
    int quads;
    int level;
    std::size_t vertices, edges, triangles;
};

// Element counts of the whole hierarchy under uniform refinement (thesis table 3.11).
constexpr Row kTable[] = {
    {4, 0, 25, 56, 32},         {4, 1, 81, 264, 160},         {4, 2, 289, 1064, 672},        {4, 3, 1089, 4200, 2720},
    {8, 3, 4225, 16560, 10880}, {16, 3, 16641, 65760, 43520}, {32, 3, 66049, 262080, 174080}};

TEST(Hierarchy, has_the_counts_of_the_thesis_under_uniform_refinement) {
    for (const Row& row : kTable) {
        AdaptiveMesh mesh(sim::make_square({.columns = row.quads, .rows = row.quads}));
        NoState state;
        set_uniform_level(mesh, state, row.level);
        EXPECT_EQ(mesh.vertices().size(), row.vertices);
        EXPECT_EQ(mesh.edges().size(), row.edges);
        EXPECT_EQ(mesh.triangles().size(), row.triangles);
        EXPECT_EQ(mesh.leaf_vertices().size(), row.vertices);
        EXPECT_EQ(mesh.leaf_triangles().size(), static_cast<std::size_t>(2 * row.quads * row.quads) << 2 * row.level);
    }
}

TEST(Hierarchy, is_sound_at_every_uniform_level_and_comes_back) {
    AdaptiveMesh mesh(sim::make_square({.columns = 5, .rows = 3}));
    NoState state;
    for (const int level : {0, 1, 2, 3, 2, 1, 0, 3, 0}) {
        set_uniform_level(mesh, state, level);
        EXPECT_TRUE(check(mesh).empty()) << check(mesh).front();
        for (const LeafTriangle& t : mesh.leaf_triangles()) EXPECT_EQ(t.level, level);
    }
    EXPECT_EQ(mesh.vertices().size(), 24U);
    EXPECT_EQ(mesh.triangles().size(), 30U);
}

TEST(Hierarchy, costs_fewer_bytes_per_element_than_the_thesis) {
    constexpr AdaptiveMesh::BytesPerElement bytes = AdaptiveMesh::bytes_per_element();
    EXPECT_LE(bytes.vertex, 28U);    // thesis: 144
    EXPECT_LE(bytes.edge, 48U);      // 52
    EXPECT_LE(bytes.triangle, 92U);  // 120, corner coordinates not counted
}

TEST(Hierarchy, halves_rest_lengths_and_takes_internal_ones_from_the_material) {
    AdaptiveMesh mesh(sim::make_square({.columns = 2, .rows = 2, .width = 0.8, .depth = 0.8}));
    NoState state;
    set_uniform_level(mesh, state, 2);
    for (const LeafEdge& e : mesh.leaf_edges()) {
        const bool is_diagonal = e.rest_length > 0.12F;
        EXPECT_NEAR(e.rest_length, is_diagonal ? 0.1 * std::sqrt(2.0) : 0.1, 1e-6);
    }
}

TEST(Hierarchy, shares_the_material_area_out_to_the_vertices) {
    AdaptiveMesh mesh(sim::make_square({.columns = 3, .rows = 4, .width = 0.6, .depth = 0.5}));
    NoState state;
    for (int level = 0; level <= 3; ++level) {
        set_uniform_level(mesh, state, level);
        double sum = 0.0;
        for (const VertexId v : mesh.leaf_vertices()) sum += double(mesh.vertex_areas()[v.value]);
        EXPECT_NEAR(sum, 0.3, 1e-6);
    }
}

TEST(Hinges, unfold_a_flat_square_into_itself) {
    AdaptiveMesh mesh(sim::make_square({.columns = 3, .rows = 3}), {.max_level = 1});
    NoState state;
    set_uniform_level(mesh, state, 1);
    const auto u = [&](VertexId v) {
        for (const LeafTriangle& t : mesh.leaf_triangles()) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (t.v[k] == v) return t.u[k];
            }
        }
        return Vec2f(0.0F, 0.0F);
    };
    ASSERT_FALSE(mesh.hinges().empty());
    for (const Hinge& h : mesh.hinges()) {
        const Vec2f x = (u(h.b) - u(h.a)).normalized(), y(-x.y(), x.x()), middle = 0.5F * (u(h.a) + u(h.b));
        EXPECT_LT((middle + h.left_at.x() * x + h.left_at.y() * y - u(h.left)).norm(), 1e-6F);
        EXPECT_LT((middle + h.right_at.x() * x + h.right_at.y() * y - u(h.right)).norm(), 1e-6F);
        EXPECT_GT(h.left_at.y(), 0.0F);
        EXPECT_LT(h.right_at.y(), 0.0F);
        EXPECT_LT((h.along[0] - x).norm() + (h.along[1] - x).norm(), 1e-5F);
    }
}

}  // namespace

}  // namespace selvedge::sim
