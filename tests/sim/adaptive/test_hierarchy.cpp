// How many elements there are, and what they cost.
#include <gtest/gtest.h>

#include "sim/adaptive/check.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"

namespace selvedge {
namespace {

struct Row {
    int quads;
    int level;
    std::size_t vertices, edges, triangles;
};

// The thesis' counts of the whole hierarchy under uniform refinement (SPEC 1.1).
constexpr Row kTable[] = {
    {4, 0, 25, 56, 32},         {4, 1, 81, 264, 160},         {4, 2, 289, 1064, 672},        {4, 3, 1089, 4200, 2720},
    {8, 3, 4225, 16560, 10880}, {16, 3, 16641, 65760, 43520}, {32, 3, 66049, 262080, 174080}};

TEST(Hierarchy, has_the_counts_of_the_thesis_under_uniform_refinement) {
    for (const Row& row : kTable) {
        AdaptiveMesh mesh(make_square({.columns = row.quads, .rows = row.quads}));
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
    AdaptiveMesh mesh(make_square({.columns = 5, .rows = 3}));
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
    EXPECT_LE(bytes.vertex, 28U);    // the thesis: 144
    EXPECT_LE(bytes.edge, 48U);      // 52
    EXPECT_LE(bytes.triangle, 92U);  // 120, corner coordinates not counted
}

TEST(Hierarchy, halves_rest_lengths_and_takes_internal_ones_from_the_material) {
    AdaptiveMesh mesh(make_square({.columns = 2, .rows = 2, .width = 0.8, .depth = 0.8}));
    NoState state;
    set_uniform_level(mesh, state, 2);
    for (const LeafEdge& e : mesh.leaf_edges()) {
        const bool is_diagonal = e.rest_length > 0.12F;
        EXPECT_NEAR(e.rest_length, is_diagonal ? 0.1 * std::sqrt(2.0) : 0.1, 1e-6);
    }
}

TEST(Hierarchy, shares_the_material_area_out_to_the_vertices) {
    AdaptiveMesh mesh(make_square({.columns = 3, .rows = 4, .width = 0.6, .depth = 0.5}));
    NoState state;
    for (int level = 0; level <= 3; ++level) {
        set_uniform_level(mesh, state, level);
        double sum = 0.0;
        for (const VertexId v : mesh.leaf_vertices()) sum += double(mesh.vertex_areas()[v.value]);
        EXPECT_NEAR(sum, 0.3, 1e-6);
    }
}

TEST(Hinges, unfold_a_flat_square_into_itself) {
    AdaptiveMesh mesh(make_square({.columns = 3, .rows = 3}), {.max_level = 1});
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
}  // namespace selvedge
