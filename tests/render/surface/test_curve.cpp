#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "render/surface/curve.h"
#include "sim/adaptive/check.h"
#include "sim/collide/collider.h"
#include "sim/core/error.h"
#include "sim/inspection/report.h"
#include "tests/sim/cloth/fixtures.h"
#include "tests/support/right_wrong.h"

namespace selvedge::render {
namespace {

// Puts the leaf vertices of a horizontal patch on a wave of this height, m.
void wave(sim::Cloth& cloth, float height) {
    for (const sim::VertexId v : cloth.mesh.leaf_vertices()) {
        Vec4f& x = cloth.x[v.value];
        x.y() = 2 + height * std::sin(20 * x.x() + 6 * x.z());
    }
}

sim::Cloth waving_patch(float height = 0.03F) {
    sim::Cloth cloth = sim::test::make_patch(sim::test::undamped());
    wave(cloth, height);
    return cloth;
}

sim::DrawMesh leaves_of(const sim::Cloth& cloth) {
    return sim::draw_mesh(cloth, {"patch"});
}

TEST(SurfaceOverCloth, is_the_curved_mesh_of_the_leaves) {
    sim::Cloth cloth = waving_patch();
    sim::test::refine(cloth, 1);
    wave(cloth, 0.03F);
    const sim::DrawMesh leaves = leaves_of(cloth);
    const sim::SphereCollider body{Vec3f(0, 1.9F, 0), 0.1F};
    CurveOptions near_body;
    near_body.move.body = &body;
    for (const CurveOptions& options : {CurveOptions{}, CurveOptions{.modifier = curve_modifier(SurfaceKind::Restore)},
                                        CurveOptions{.level = 2}, CurveOptions{.deepest_level = 1}, near_body}) {
        SurfaceOverCloth over;
        const sim::DrawMesh drawn = draw_mesh(over.curve(cloth, options), leaves);
        EXPECT_EQ(drawn, curved_mesh(leaves, {.curve = options}));
        EXPECT_GT(drawn.triangles.size(), leaves.triangles.size());
    }
}

TEST(SurfaceOverCloth, follows_the_cloth_from_frame_to_frame) {
    sim::Cloth cloth = waving_patch(0);
    SurfaceOverCloth over;
    over.curve(cloth, {.level = 2});
    for (const float height : {0.01F, 0.03F, -0.02F}) {
        wave(cloth, height);
        const sim::DrawMesh leaves = leaves_of(cloth);
        const CurvedSurface& surface = over.curve(cloth, {.level = 2});
        EXPECT_EQ(draw_mesh(surface, leaves), curved_mesh(leaves, {.curve = {.level = 2}}));
        EXPECT_TRUE(check(surface.mesh).empty());
    }
}

TEST(SurfaceOverCloth, refines_at_once_what_begins_to_bend) {
    sim::Cloth cloth = waving_patch(0);
    SurfaceOverCloth over;
    EXPECT_EQ(over.curve(cloth).mesh.leaf_triangles().size(), cloth.mesh.leaf_triangles().size());
    wave(cloth, 0.03F);
    const sim::DrawMesh leaves = leaves_of(cloth);
    EXPECT_EQ(draw_mesh(over.curve(cloth), leaves).triangles.size(), curved_mesh(leaves).triangles.size());
}

TEST(SurfaceOverCloth, that_glides_moves_new_vertices_out_gradually) {
    sim::Cloth cloth = waving_patch(0);
    SurfaceOverCloth over;
    CurveOptions gliding{.glides = true};
    gliding.move.max_step = 0.0005F;
    over.curve(cloth, gliding);
    wave(cloth, 0.03F);
    const CurvedSurface& surface = over.curve(cloth, gliding);
    const auto are_shown = [&](const auto& as) {
        const auto vertices = surface.mesh.leaf_vertices();
        return std::ranges::count_if(vertices, [&](sim::VertexId v) { return as(surface.shown[v.value]); });
    };
    const auto added = are_shown([](float shown) { return shown == 0; });
    EXPECT_GT(added, 0) << "at the middles of their edges";
    over.curve(cloth, gliding);
    EXPECT_GT(are_shown([](float shown) { return shown > 0 && shown < 1; }), added / 2);
    for (int frame = 0; frame < 200; ++frame) over.curve(cloth, gliding);
    EXPECT_EQ(are_shown([](float shown) { return shown < 1; }), 0);
    EXPECT_GT(surface.mesh.leaf_triangles().size(), cloth.mesh.leaf_triangles().size());
}

TEST(SurfaceOverCloth, is_made_anew_and_refined_at_once_when_the_leaves_change) {
    sim::Cloth cloth = waving_patch();
    SurfaceOverCloth over;
    EXPECT_EQ(over.curve(cloth, {.glides = true}).mesh.base_triangle_count(), 32U);
    sim::test::refine(cloth, 1);
    wave(cloth, 0.03F);
    const CurvedSurface& surface = over.curve(cloth, {.glides = true});
    EXPECT_EQ(surface.mesh.base_triangle_count(), 128U);
    EXPECT_EQ(draw_mesh(surface, leaves_of(cloth)), curved_mesh(leaves_of(cloth)));
}

TEST(SurfaceOverCloth, is_made_anew_for_another_cloth_after_as_many_adaptations) {
    const sim::Cloth first = waving_patch();
    sim::Cloth second = sim::test::make_patch(sim::test::undamped(), {.side = 0.5});  // the same indices
    wave(second, 0.03F);
    ASSERT_EQ(first.adaptations, second.adaptations);
    SurfaceOverCloth over;
    over.curve(first);
    EXPECT_EQ(draw_mesh(over.curve(second), leaves_of(second)), curved_mesh(leaves_of(second)));
}

TEST(SurfaceOverCloth, is_made_anew_for_other_curves) {
    const sim::Cloth cloth = waving_patch();
    SurfaceOverCloth over;
    over.curve(cloth, {.level = 2});
    const CurveOptions flat{.modifier = curve_modifier(SurfaceKind::Flat), .level = 1};
    EXPECT_EQ(draw_mesh(over.curve(cloth, flat), leaves_of(cloth)), curved_mesh(leaves_of(cloth), {.curve = flat}));
}

}  // namespace

namespace {

// Two panels that form a ridge and are sewn along it: material coordinates jump there.
sim::DrawMesh ridge() {
    sim::DrawMesh mesh;
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
    const sim::DrawMesh coarse = ridge();
    const sim::DrawMesh drawn = curved_mesh(coarse, {.curve = {.level = 2}});
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
    const sim::DrawMesh drawn = curved_mesh(ridge(), {.curve = {.level = 2}});
    EXPECT_EQ(drawn.x.size(), 9U * 5U);
    EXPECT_EQ(drawn.normals.size(), drawn.x.size());
}

// Directs the triangles of the second panel the other way round.
sim::DrawMesh with_second_panel_turned(sim::DrawMesh mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.panel[t] != 1) continue;
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        std::swap(mesh.u[t][1], mesh.u[t][2]);
        for (Vec2f& u : mesh.u[t]) u.x() *= -1;
    }
    return mesh;
}

// The normal of a drawn triangle, and that of a corner on the triangle's right side.
Vec3f facet_normal(const sim::DrawMesh& mesh, std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return (mesh.x[b] - mesh.x[a]).cross(mesh.x[c] - mesh.x[a]).normalized();
}
Vec3f corner_normal(const sim::DrawMesh& mesh, std::size_t t, std::size_t k) {
    const Vec3f& normal = mesh.normals[mesh.triangles[t][k]];
    return sim::is_turned(mesh, t, k) ? Vec3f(-normal) : normal;
}

TEST(CurvedMesh, over_a_seam_of_right_side_to_wrong_side_is_as_smooth_as_over_any_other) {
    for (const LightNormals which : {LightNormals::Recomputed, LightNormals::Interpolated}) {
        const CurvedMeshOptions options{.curve = {.level = 2}, .light_normals = which};
        const sim::DrawMesh plain = curved_mesh(ridge(), options);
        const sim::DrawMesh half = curved_mesh(with_second_panel_turned(ridge()), options);
        ASSERT_EQ(half.x.size(), plain.x.size()) << "no vertex is drawn twice";
        ASSERT_EQ(half.turned_corners.size(), half.triangles.size());
        const auto has_near = [&](const Vec3f& x) {
            return std::ranges::any_of(plain.x, [&](const Vec3f& y) { return (x - y).norm() < 1e-6F; });
        };
        for (const Vec3f& x : half.x) EXPECT_TRUE(has_near(x));
        for (std::size_t t = 0; t < half.triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(corner_normal(half, t, k).dot(facet_normal(half, t)), 0.5F);
        }
    }
}

TEST(CurvedMesh, of_a_moebius_band_is_closed_and_lit_on_the_right_side_of_each_triangle) {
    const sim::GarmentMesh band = sim::test::moebius_band(3);
    sim::DrawMesh coarse;
    for (const Vec3d& x : band.x) coarse.x.emplace_back(x.cast<float>());
    for (const sim::GarmentTriangle& t : band.triangles) {
        auto& triangle = coarse.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) triangle[k] = static_cast<std::uint32_t>(t.vertices[k]);
        coarse.u.push_back({t.u[0].cast<float>(), t.u[1].cast<float>(), t.u[2].cast<float>()});
        coarse.panel.push_back(static_cast<std::uint16_t>(t.panel));
    }
    coarse.panel_names = band.panel_names;
    const sim::DrawMesh drawn = curved_mesh(coarse, {.curve = {.level = 2}});
    for (std::size_t t = 0; t < drawn.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(corner_normal(drawn, t, k).dot(facet_normal(drawn, t)), 0.5F);
    }
    // Each vertex on the cut is drawn once per side, at one place: two quads of four edges each.
    std::size_t twice = 0;
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
        for (std::size_t k = i + 1; k < drawn.x.size(); ++k) twice += (drawn.x[i] - drawn.x[k]).norm() < 1e-7F ? 1 : 0;
    }
    EXPECT_EQ(twice, 9U);
    EXPECT_LT(curved_mesh(coarse).triangles.size(), drawn.triangles.size() * 4) << "settles";
}

TEST(CurvedMesh, at_level_0_is_the_coarse_mesh) {
    const sim::DrawMesh coarse = ridge();
    const sim::DrawMesh drawn = curved_mesh(coarse, {.curve = {.level = 0}});
    EXPECT_EQ(drawn.triangles.size(), coarse.triangles.size());
    for (std::size_t t = 0; t < drawn.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(drawn.x[drawn.triangles[t][k]], coarse.x[coarse.triangles[t][k]]);
    }
}

TEST(CurvedMesh, interpolated_normals_differ_from_those_of_its_triangles) {
    const sim::DrawMesh recomputed = curved_mesh(ridge(), {.curve = {.level = 2}});
    const sim::DrawMesh interpolated =
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
    sim::DrawMesh coarse = ridge();
    coarse.u.clear();
    coarse.panel.clear();
    const sim::DrawMesh drawn =
        curved_mesh(coarse, {.curve = {.modifier = curve_modifier(SurfaceKind::Restore), .level = 1}});
    EXPECT_TRUE(drawn.u.empty());
    EXPECT_TRUE(drawn.panel.empty());
    EXPECT_EQ(drawn.triangles.size(), 16U);
    for (const Vec3f& x : drawn.x) EXPECT_TRUE(x.allFinite());
}

TEST(CurvedMesh, of_a_crease_has_each_vertex_once_for_each_side) {
    const sim::DrawMesh smooth = curved_mesh(ridge(), {.curve = {.level = 2}});
    for (const LightNormals which : {LightNormals::Recomputed, LightNormals::Interpolated}) {
        const sim::DrawMesh sharp =
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
    const sim::DrawMesh all = curved_mesh(ridge());
    const sim::DrawMesh seen = curved_mesh(ridge(), {.curve = {.view = sim::ViewPoint{.eye = Vec3f(0, -5, 0)}}});
    EXPECT_GT(all.triangles.size(), 16U);
    EXPECT_LT(seen.triangles.size(), all.triangles.size());
}

TEST(CurvedMesh, refuses_an_edge_with_three_triangles_and_too_many_triangles) {
    sim::DrawMesh three = ridge();
    three.triangles.push_back({1, 2, 4});
    three.u.push_back(three.u[0]);
    three.panel.push_back(0);
    three.level.push_back(0);
    EXPECT_THROW(curved_mesh(three), sim::InputError);

    sim::DrawMesh many = ridge();
    many.triangles.resize(6000, many.triangles[0]);
    EXPECT_THROW(curved_mesh(many, {.curve = {.level = kMaxSurfaceLevel}}), sim::InputError);
}

}  // namespace

}  // namespace selvedge::render
