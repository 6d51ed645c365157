// Material coordinates that jump at a seam (SPEC 3.2), boundaries, and base meshes that are refused.
#include <gtest/gtest.h>

#include "sim/adaptive/check.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"
#include "sim/core/error.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

// The sum of a base edge's descendants, which must be its own length.
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
            const std::size_t k = place_of(side, e);
            EXPECT_FLOAT_EQ(mesh.rest_length(e), (side.u[(k + 1) % 3] - side.u[k]).norm());
        }
    }
}

TEST(Seam, lets_a_hinge_measure_across_it) {
    AdaptiveMesh mesh(tube(5, 2));
    NoState state;
    set_uniform_level(mesh, state, 1);
    // The panel is flat, 0.5 m round: unfolded, every hinge is one of the same quads, whether the seam runs through.
    std::size_t upright = 0;
    for (const Hinge& h : mesh.hinges()) {
        const bool is_diagonal = h.rest_length > 0.06F;
        if (is_diagonal) continue;
        EXPECT_NEAR(h.rest_length, 0.05, 1e-6);
        EXPECT_NEAR((h.left_at - h.right_at).norm(), 0.05 * std::sqrt(5.0), 1e-6);
        upright += std::abs(h.along[0].y()) > 0.9F ? 1 : 0;
    }
    EXPECT_EQ(upright, 10U * 4U);  // ten columns of edges, the seam's among them, of four edges each
}

TEST(Seam, has_no_jump_in_position_and_no_hole) {
    const GarmentMesh base = tube(6, 3);
    AdaptiveMesh mesh(base);
    PositionState state(base, mesh);
    set_uniform_level(mesh, state, 2);
    std::size_t boundary = 0;
    for (const LeafEdge& e : mesh.leaf_edges()) boundary += !mesh.leaf_at(e.edge, 0) || !mesh.leaf_at(e.edge, 1);
    EXPECT_EQ(boundary, 2U * 6U * 4U);  // the two rims alone
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

TEST(BaseMesh, refuses_triangles_that_face_opposite_ways) {
    GarmentMesh base = two_triangles();
    base.triangles[1].vertices = {3, 1, 2};
    expect_refused(base, "edge 1-2: its two triangles face opposite ways");
}

TEST(BaseMesh, keeps_the_indices_of_vertices_and_triangles_as_ids) {
    const GarmentMesh base = make_square();
    const AdaptiveMesh mesh(base);
    for (std::uint32_t t = 0; t < base.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const AdaptiveTriangle& triangle = mesh.triangle(TriangleId(t));
            EXPECT_EQ(static_cast<int>(triangle.vertices[k].value), base.triangles[t].vertices[k]);
            EXPECT_EQ(triangle.u[k], base.triangles[t].u[k].cast<float>());
        }
    }
}

}  // namespace
}  // namespace selvedge::test
