#include "render/surface/curved_mesh.h"

#include <gtest/gtest.h>

#include "sim/collide/collider.h"
#include "sim/core/error.h"

namespace selvedge::render {
namespace {

// Two panels that form a ridge and are sewn along it: material coordinates jump there.
sim::PlainMesh ridge() {
    sim::PlainMesh mesh;
    mesh.x = {{-1, 0, 0}, {0, 0.5F, 0}, {0, 0.5F, -1}, {-1, 0, -1}, {1, 0, 0}, {1, 0, -1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    const Vec2f a(0, 0), b(1.118F, 0), c(1.118F, 1), d(0, 1), shift(5, 0);
    mesh.u = {{a, b, c}, {a, c, d}, {a + shift, b + shift, c + shift}, {a + shift, c + shift, d + shift}};
    mesh.panel = {0, 0, 1, 1};
    mesh.level = {1, 0, 0, 0};
    mesh.panel_names = {"left", "right"};
    mesh.panel_grain_angles = {0, 0.5F};
    mesh.panel_sett_offsets = {Vec2f(0.01F, 0), Vec2f(0, 0.02F)};
    return mesh;
}

float area_of(const std::vector<std::array<Vec2f, 3>>& u) {
    float area = 0;
    for (const auto& [a, b, c] : u) area += 0.5F * ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
    return area;
}

TEST(CurvedMesh, carries_panels_names_grain_and_material_over_and_counts_levels_on) {
    const sim::PlainMesh coarse = ridge();
    const sim::PlainMesh drawn = curved_mesh(coarse, {.curve = {.level = 2}});
    ASSERT_EQ(drawn.triangles.size(), 4U * 16U);
    EXPECT_EQ(drawn.panel_names, coarse.panel_names);
    EXPECT_EQ(drawn.panel_grain_angles, coarse.panel_grain_angles);
    EXPECT_EQ(drawn.panel_sett_offsets, coarse.panel_sett_offsets);
    EXPECT_NEAR(area_of(drawn.u), area_of(coarse.u), 1e-5F);
    for (std::size_t t = 0; t < drawn.triangles.size(); ++t) {
        EXPECT_EQ(drawn.panel[t], t < 32 ? 0 : 1);
        EXPECT_EQ(drawn.level[t], t < 16 ? 3 : 2);
        for (const Vec2f& u : drawn.u[t]) EXPECT_EQ(u.x() > 3, drawn.panel[t] == 1);
    }
}

TEST(CurvedMesh, shares_the_vertices_of_a_seam) {
    const sim::PlainMesh drawn = curved_mesh(ridge(), {.curve = {.level = 2}});
    EXPECT_EQ(drawn.x.size(), 9U * 5U);
    EXPECT_EQ(drawn.normals.size(), drawn.x.size());
}

TEST(CurvedMesh, at_level_0_is_the_coarse_mesh) {
    const sim::PlainMesh coarse = ridge();
    const sim::PlainMesh drawn = curved_mesh(coarse, {.curve = {.level = 0}});
    EXPECT_EQ(drawn.triangles.size(), coarse.triangles.size());
    for (std::size_t t = 0; t < drawn.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(drawn.x[drawn.triangles[t][k]], coarse.x[coarse.triangles[t][k]]);
    }
}

TEST(CurvedMesh, interpolated_normals_differ_from_those_of_its_triangles) {
    const sim::PlainMesh recomputed = curved_mesh(ridge(), {.curve = {.level = 2}});
    const sim::PlainMesh interpolated =
        curved_mesh(ridge(), {.curve = {.level = 2}, .light_normals = LightNormals::Interpolated});
    EXPECT_EQ(recomputed.x, interpolated.x);
    float most = 0;
    for (std::size_t i = 0; i < recomputed.x.size(); ++i) {
        EXPECT_NEAR(interpolated.normals[i].norm(), 1, 1e-5F);
        most = std::max(most, (recomputed.normals[i] - interpolated.normals[i]).norm());
    }
    EXPECT_GT(most, 0.05F);
}

TEST(CurvedMesh, of_a_mesh_without_material_coordinates_has_none) {
    sim::PlainMesh coarse = ridge();
    coarse.u.clear();
    coarse.panel.clear();
    const sim::PlainMesh drawn = curved_mesh(coarse, {.curve = {.kind = SurfaceKind::Restore, .level = 1}});
    EXPECT_TRUE(drawn.u.empty());
    EXPECT_TRUE(drawn.panel.empty());
    EXPECT_EQ(drawn.triangles.size(), 16U);
    for (const Vec3f& x : drawn.x) EXPECT_TRUE(x.allFinite());
}

TEST(CurvedMesh, of_a_crease_has_each_vertex_once_for_each_side) {
    const sim::PlainMesh smooth = curved_mesh(ridge(), {.curve = {.level = 2}});
    for (const LightNormals which : {LightNormals::Recomputed, LightNormals::Interpolated}) {
        const sim::PlainMesh sharp =
            curved_mesh(ridge(), {.curve = {.level = 2}, .light_normals = which, .creases = {{1, 2}}});
        ASSERT_EQ(sharp.x.size(), smooth.x.size() + 5);
        EXPECT_EQ(sharp.triangles.size(), smooth.triangles.size());
        for (std::size_t t = 0; t < sharp.triangles.size(); ++t) {
            const auto& [a, b, c] = sharp.triangles[t];
            const Vec3f normal = (sharp.x[b] - sharp.x[a]).cross(sharp.x[c] - sharp.x[a]).normalized();
            for (const std::uint32_t v : {a, b, c}) EXPECT_GT(sharp.normals[v].dot(normal), 0.9999F);
        }
    }
}

TEST(CurvedMesh, adaptive_is_coarser_where_it_is_turned_away) {
    const sim::PlainMesh all = curved_mesh(ridge());
    const sim::PlainMesh seen = curved_mesh(ridge(), {.curve = {.view = sim::ViewPoint{.eye = Vec3f(0, -5, 0)}}});
    EXPECT_GT(all.triangles.size(), 16U);
    EXPECT_LT(seen.triangles.size(), all.triangles.size());
}

TEST(CurvedMesh, refuses_an_edge_with_three_triangles_and_too_many_triangles) {
    sim::PlainMesh three = ridge();
    three.triangles.push_back({1, 2, 4});
    three.u.push_back(three.u[0]);
    three.panel.push_back(0);
    three.level.push_back(0);
    EXPECT_THROW(curved_mesh(three), sim::InputError);

    sim::PlainMesh many = ridge();
    many.triangles.resize(6000, many.triangles[0]);
    EXPECT_THROW(curved_mesh(many, {.curve = {.level = kMaxSurfaceLevel}}), sim::InputError);
}

}  // namespace
}  // namespace selvedge::render
