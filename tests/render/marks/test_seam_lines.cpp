#include <gtest/gtest.h>
#include <cmath>

#include "render/marks/seam_lines.h"

namespace selvedge::render {
namespace {

constexpr std::uint32_t kCells = 8;

// A tube of two panels, each covering half of the circumference: two seams, and hems at the top and bottom.
sim::PlainMesh tube() {
    sim::PlainMesh mesh;
    for (std::uint32_t j = 0; j <= kCells; ++j) {
        for (std::uint32_t i = 0; i < 2 * kCells; ++i) {
            const float turn = 3.14159265F * float(i) / float(kCells);
            mesh.x.emplace_back(0.2F * std::cos(turn), 0.1F * float(j), 0.2F * std::sin(turn));
        }
    }
    const auto at = [](std::uint32_t i, std::uint32_t j) { return j * 2 * kCells + i % (2 * kCells); };
    for (std::uint32_t j = 0; j < kCells; ++j) {
        for (std::uint32_t i = 0; i < 2 * kCells; ++i) {
            const auto u = [](std::uint32_t a, std::uint32_t b) { return Vec2f(0.1F * float(a), 0.1F * float(b)); };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            mesh.u.push_back({u(i, j), u(i + 1, j), u(i + 1, j + 1)});
            mesh.u.push_back({u(i, j), u(i + 1, j + 1), u(i, j + 1)});
            const std::uint16_t panel = i < kCells ? 0 : 1;
            mesh.panel.insert(mesh.panel.end(), {panel, panel});
        }
    }
    return mesh;
}

TEST(SeamLines, a_tube_of_two_panels_has_two_seams_of_its_height_and_two_hems_of_each) {
    const SeamLines lines = find_seam_lines(tube());
    ASSERT_EQ(lines.seams.size(), 2U);
    for (const SeamLine& seam : lines.seams) {
        EXPECT_EQ(seam.panels, (std::array<std::uint16_t, 2>{0, 1}));
        ASSERT_EQ(seam.paths.size(), 1U);
        EXPECT_EQ(seam.paths[0].size(), kCells + 1);
        EXPECT_NEAR(seam.length, 0.8, 1e-6);
    }
    EXPECT_EQ(lines.hems.size(), 4U) << "above and below, of either panel";
}

TEST(SeamLines, paths_run_from_edge_to_edge_without_a_gap) {
    const sim::PlainMesh mesh = tube();
    const SeamLines lines = find_seam_lines(mesh);
    ASSERT_FALSE(lines.seams.empty());
    for (const SeamLine& seam : lines.seams) {
        ASSERT_FALSE(seam.paths.empty());
        for (std::size_t i = 1; i < seam.paths[0].size(); ++i) {
            const float step = (mesh.x[seam.paths[0][i]] - mesh.x[seam.paths[0][i - 1]]).norm();
            EXPECT_NEAR(step, 0.1F, 1e-6F);
        }
    }
}

TEST(SeamLines, one_panel_sewn_to_a_tube_has_one_seam_with_itself_and_closed_hems) {
    sim::PlainMesh mesh = tube();
    mesh.panel.assign(mesh.panel.size(), 0);
    const SeamLines lines = find_seam_lines(mesh);
    ASSERT_EQ(lines.seams.size(), 1U);
    EXPECT_EQ(lines.seams[0].panels, (std::array<std::uint16_t, 2>{0, 0}));
    ASSERT_EQ(lines.hems.size(), 2U);
    for (const SeamLine& hem : lines.hems) {
        ASSERT_EQ(hem.paths.size(), 1U);
        EXPECT_EQ(hem.paths[0].front(), hem.paths[0].back()) << "closed";
        EXPECT_EQ(hem.paths[0].size(), 2 * kCells + 1);
    }
}

TEST(SeamLines, every_marked_edge_is_on_exactly_one_path_where_lines_fork) {
    sim::PlainMesh mesh = tube();
    for (std::size_t t = 0; t < mesh.panel.size(); ++t) mesh.panel[t] = static_cast<std::uint16_t>(t / 2 % 2);
    std::size_t edges = 0;
    for (const SeamLine& seam : find_seam_lines(mesh).seams) {
        for (const VertexPath& path : seam.paths) edges += path.size() - 1;
    }
    EXPECT_EQ(edges, 2U * kCells * kCells) << "between any two columns of cells";
}

}  // namespace

}  // namespace selvedge::render
