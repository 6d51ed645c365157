#include "sim/exchange/panel_parts.h"

#include <gtest/gtest.h>

#include "tests/sim/exchange/two_panels.h"

namespace selvedge {
namespace {

TEST(PanelParts, part_a_garment_by_panel_and_double_the_vertices_of_its_seams) {
    const std::vector<PanelPart> parts = split_by_panel(two_panels());
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].name, "front");
    EXPECT_EQ(parts[1].name, "left sleeve");
    EXPECT_EQ(parts[1].grain_angle, 0.7853982F);
    for (const PanelPart& part : parts) {
        EXPECT_EQ(part.vertices.size(), 4U);
        EXPECT_EQ(part.triangles.size(), 2U);
    }
    EXPECT_EQ(parts[1].vertices, (std::vector<std::uint32_t>{1, 4, 5, 2}));
}

TEST(PanelParts, double_a_vertex_whose_corners_disagree_within_one_panel) {
    // A dart: both sides are of the same panel.
    PlainMesh mesh = two_panels();
    mesh.panel.clear();
    const std::vector<PanelPart> parts = split_by_panel(mesh);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].vertices.size(), 8U);
    for (std::size_t t = 0; t < 4; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = parts[0].triangles[t][k];
            EXPECT_EQ(parts[0].vertices[corner], mesh.triangles[t][k]);
            EXPECT_EQ(parts[0].u[corner], mesh.u[t][k]);
        }
}

TEST(PanelParts, leave_out_panels_without_triangles) {
    PlainMesh mesh = two_panels();
    for (std::uint16_t& panel : mesh.panel) panel = 1;
    const std::vector<PanelPart> parts = split_by_panel(mesh);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].name, "left sleeve");
}

}  // namespace
}  // namespace selvedge
