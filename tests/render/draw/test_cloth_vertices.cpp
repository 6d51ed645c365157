#include <gtest/gtest.h>

#include "render/draw/cloth_vertices.h"
#include "render/scene/colour.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::render {
namespace {

// Two triangles of two panels, sewn along the edge 1-2, with material coordinates of their own:
//   2---3
//   | \ |
//   0---1
sim::DrawMesh sewn_square() {
    sim::DrawMesh mesh;
    mesh.x = {{0, 0, 0}, {0.3F, 0, 0}, {0, 0.4F, 0}, {0.3F, 0.4F, 0}};
    mesh.normals.assign(4, Vec3f(0, 0, 1));
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    mesh.u = {{Vec2f(0, 0), Vec2f(0.3F, 0), Vec2f(0, 0.4F)}, {Vec2f(5.3F, 0), Vec2f(5.3F, 0.4F), Vec2f(5, 0.4F)}};
    mesh.panel = {0, 1};
    mesh.level = {2, 3};
    mesh.panel_grain_angles = {0, 1.57079633F};
    return mesh;
}

std::vector<ClothVertex> vertices_of(const sim::DrawMesh& mesh) {
    return make_cloth_vertices(mesh, mesh.normals, std::vector<AmbientVisibility>(mesh.x.size()));
}

TEST(ClothVertices, a_seam_is_marked_where_material_coordinates_jump_and_a_hem_where_cloth_ends) {
    const std::vector<ClothVertex> vertices = vertices_of(sewn_square());
    ASSERT_EQ(vertices.size(), 6U);
    const std::uint32_t opposite_first = 1;  // the edge opposite to corner 0 joins 1 and 2
    EXPECT_EQ(vertices[0].marks >> 8 & 7U, opposite_first);
    EXPECT_EQ(vertices[0].marks >> 11 & 7U, 7U & ~opposite_first);
    EXPECT_EQ(vertices[0].marks & 255U, 2U);
    EXPECT_EQ(vertices[3].marks & 255U, 3U);
}

TEST(ClothVertices, an_edge_within_one_panel_is_neither_seam_nor_hem) {
    sim::DrawMesh mesh = sewn_square();
    mesh.panel = {0, 0};
    mesh.u[1] = {Vec2f(0.3F, 0), Vec2f(0.3F, 0.4F), Vec2f(0, 0.4F)};
    EXPECT_EQ(vertices_of(mesh)[0].marks >> 8 & 7U, 0U);
}

TEST(ClothVertices, a_dart_is_a_seam_within_one_panel) {
    sim::DrawMesh mesh = sewn_square();
    mesh.panel = {0, 0};
    EXPECT_EQ(vertices_of(mesh)[0].marks >> 8 & 7U, 1U);
}

TEST(ClothVertices, a_turned_corner_has_the_normal_and_the_light_of_its_own_right_side) {
    sim::DrawMesh mesh = sewn_square();
    std::vector<AmbientVisibility> light(mesh.x.size(), {.front = 0.75F, .back = 0.25F});
    mesh.turned_corners = {0, 5};
    const std::vector<ClothVertex> vertices = make_cloth_vertices(mesh, mesh.normals, light);
    const std::vector<ClothVertex> plain = make_cloth_vertices(sewn_square(), mesh.normals, light);
    for (const std::size_t corner : {3U, 4U, 5U}) {
        const float sign = corner == 4 ? 1 : -1;
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(vertices[corner].normal[i], sign * plain[corner].normal[i]);
        EXPECT_EQ(vertices[corner].ambient_visibility[0], corner == 4 ? 0.75F : 0.25F);
        EXPECT_EQ(vertices[corner].ambient_visibility[1], corner == 4 ? 0.25F : 0.75F);
    }
    EXPECT_EQ(vertices[0].normal, plain[0].normal);
}

TEST(ClothVertices, the_sett_follows_the_grain_of_each_panel) {
    const std::vector<ClothVertex> vertices = vertices_of(sewn_square());
    // Straight grain: the warp runs along +y of the panel, the weft along +x.
    EXPECT_NEAR(vertices[2].place[0], 0, 1e-6F);
    EXPECT_NEAR(vertices[2].place[1], 0.4F, 1e-6F);
    // Grain turned by a quarter turn anticlockwise: the warp runs along -x, the weft along +y.
    EXPECT_NEAR(vertices[3].place[0], 0, 1e-6F);
    EXPECT_NEAR(vertices[3].place[1], -5.3F, 1e-6F);
}

TEST(ClothVertices, the_offset_of_a_panels_sett_comes_after_the_turn_to_its_grain) {
    sim::DrawMesh mesh = sewn_square();
    mesh.panel_sett_offsets = {{0.01F, 0.02F}, {-0.5F, 0.25F}};
    const std::vector<ClothVertex> vertices = vertices_of(mesh);
    EXPECT_NEAR(vertices[2].place[0], 0.01F, 1e-6F);
    EXPECT_NEAR(vertices[2].place[1], 0.42F, 1e-6F);
    EXPECT_NEAR(vertices[3].place[0], -0.5F, 1e-6F);
    EXPECT_NEAR(vertices[3].place[1], -5.05F, 1e-6F);
}

TEST(ClothVertices, heights_are_those_of_the_triangle_and_lie_on_their_own_corner) {
    const std::vector<ClothVertex> vertices = vertices_of(sewn_square());
    EXPECT_NEAR(vertices[0].heights[0], 0.3F * 0.4F / 0.5F, 1e-6F);
    EXPECT_NEAR(vertices[1].heights[1], 0.3F, 1e-6F);
    EXPECT_NEAR(vertices[2].heights[2], 0.4F, 1e-6F);
    EXPECT_EQ(vertices[0].heights[1], 0);
}

TEST(ClothVertices, a_mesh_with_nothing_but_triangles_will_do) {
    sim::DrawMesh mesh = sewn_square();
    mesh.u.clear();
    mesh.panel.clear();
    mesh.level.clear();
    mesh.panel_grain_angles.clear();
    EXPECT_EQ(vertices_of(mesh)[0].marks & 255U, 0U);
    EXPECT_EQ(vertices_of(mesh)[0].marks >> 8 & 7U, 0U);
}

TEST(SettSums, the_mean_over_any_stretch_is_that_of_its_threads) {
    const sim::Sett sett = sim::find_tartan("royal_stewart");
    const SettSums table = sum_warp(sett);
    const std::vector<sim::Rgb8> colours = thread_colours(sett);
    ASSERT_EQ(table.sums.size(), colours.size() + 1);
    for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{0, 424}, {3, 4}, {100, 190}, {420, 424}}) {
        Vec3f expected = Vec3f::Zero();
        for (std::size_t i = first; i < last; ++i) expected += to_linear(colours[i]);
        expected /= float(last - first);
        const Vec3f mean = table.mean + (table.sums[last] - table.sums[first]) / float(last - first);
        EXPECT_LT((mean - expected).norm(), 1e-5F) << first << ".." << last;
    }
}

TEST(SettSums, begin_and_end_at_nothing_so_that_they_repeat_with_the_sett) {
    const SettSums table = sum_warp(sim::find_tartan("buchanan"));
    EXPECT_EQ(table.sums.front(), Vec3f(0, 0, 0));
    EXPECT_EQ(table.sums.back(), Vec3f(0, 0, 0));
}

TEST(SettSums, a_weft_of_its_own_has_its_own_table_and_else_the_warps) {
    sim::Sett sett = sim::find_tartan("buchanan");
    EXPECT_EQ(sum_weft(sett).sums, sum_warp(sett).sums);
    sett.weft_stripes = sim::parse_threadcount("K/3 W5 R/2").stripes;
    EXPECT_EQ(sum_weft(sett).threads(), 15) << "both halves: 3 5 2 5";
    EXPECT_EQ(sum_warp(sett).sums, sum_warp(sim::find_tartan("buchanan")).sums);
}

TEST(Colour, srgb_bytes_become_linear_light) {
    EXPECT_DOUBLE_EQ(to_linear(std::uint8_t{0}), 0);
    EXPECT_DOUBLE_EQ(to_linear(std::uint8_t{255}), 1);
    EXPECT_NEAR(to_linear(std::uint8_t{188}), 0.5029, 1e-3);
}

}  // namespace

}  // namespace selvedge::render
