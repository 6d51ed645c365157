#include <gtest/gtest.h>

#include "editor/viewport3d/cloth_outline.h"

namespace selvedge::editor {
namespace {

// Two squares of 1 m side by side, "left" and "right", sewn along their common edge; each has a vertex in its centre.
struct SewnSquares {
    sim::Pattern pattern;
    sim::PlainMesh mesh;
};

sim::Panel square_panel(const std::string& name) {
    sim::Panel panel;
    panel.name = name;
    panel.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

SewnSquares sewn_squares() {
    SewnSquares squares;
    squares.pattern.panels = {square_panel("right"), square_panel("left")};
    sim::PlainMesh& mesh = squares.mesh;
    mesh.panel_names = {"left", "right"};
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0.5F, 0.5F, 0}, {1.5F, 0.5F, 0}};
    const std::array<std::array<std::uint32_t, 5>, 2> corners{{{0, 1, 4, 5, 6}, {1, 2, 3, 4, 7}}};
    for (std::uint16_t p = 0; p < 2; ++p) {
        for (std::size_t i = 0; i < 4; ++i) {
            const std::array<std::uint32_t, 3> triangle{corners[p][i], corners[p][(i + 1) % 4], corners[p][4]};
            mesh.triangles.push_back(triangle);
            mesh.panel.push_back(p);
            std::array<Vec2f, 3> u;
            for (std::size_t c = 0; c < 3; ++c) u[c] = mesh.x[triangle[c]].head<2>() - Vec2f(float(p), 0);
            mesh.u.push_back(u);
        }
    }
    return squares;
}

TEST(ClothOutline, follows_each_panel_along_its_seams_too) {
    const SewnSquares squares = sewn_squares();
    const std::vector<ClothOutline> outlines = find_outlines(squares.mesh, squares.pattern);
    ASSERT_EQ(outlines.size(), 2U);
    EXPECT_EQ(outlines[0].vertices.size(), 4U);
    EXPECT_EQ(start_of(outlines[0], 0, squares.mesh.x), Vec3f(1, 0, 0));
    EXPECT_EQ(start_of(outlines[0], 2, squares.mesh.x), Vec3f(2, 1, 0));
    EXPECT_EQ(edge_path(outlines[0], 3, squares.mesh.x), (std::vector<Vec3f>{{1, 1, 0}, {1, 0, 0}})) << "the seam";
    EXPECT_EQ(edge_path(outlines[1], 1, squares.mesh.x), (std::vector<Vec3f>{{1, 0, 0}, {1, 1, 0}}))
        << "its other side";
    EXPECT_EQ(whole_path(outlines[1], squares.mesh.x).size(), 5U);
}

TEST(ClothOutline, a_seam_within_a_panel_is_part_of_its_outline) {
    // Both squares belong to the left panel, but at different material coordinates, as at the closing seam of a tube.
    SewnSquares squares = sewn_squares();
    squares.mesh.panel.assign(8, 0);
    for (std::size_t t = 4; t < 8; ++t) {
        for (Vec2f& u : squares.mesh.u[t]) u += Vec2f(5, 0);
    }
    const std::vector<ClothOutline> outlines = find_outlines(squares.mesh, squares.pattern);
    EXPECT_EQ(outlines[1].vertices.size(), 4U) << "not the six round both";
    EXPECT_TRUE(outlines[0].is_empty()) << "no triangle is of the panel on the right";
}

TEST(ClothOutline, a_panel_that_the_mesh_does_not_know_has_none) {
    SewnSquares squares = sewn_squares();
    squares.pattern.panels[0].name = "collar";
    const std::vector<ClothOutline> outlines = find_outlines(squares.mesh, squares.pattern);
    EXPECT_TRUE(outlines[0].is_empty());
    EXPECT_FALSE(outlines[1].is_empty());
}

TEST(ClothOutline, a_mesh_without_material_coordinates_has_none) {
    SewnSquares squares = sewn_squares();
    squares.mesh.u.clear();
    EXPECT_TRUE(find_outlines(squares.mesh, squares.pattern)[0].is_empty());
}

}  // namespace

}  // namespace selvedge::editor
