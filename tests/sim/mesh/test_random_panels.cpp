// Hundreds of panels that nobody drew: whatever the outline, the mesh is sound and the outline is kept.
#include <gtest/gtest.h>

#include <random>

#include "sim/mesh/assemble.h"
#include "sim/mesh/check_mesh.h"
#include "sim/mesh/sample_outline.h"
#include "sim/mesh/triangulate.h"
#include "tests/sim/mesh/shapes.h"

namespace selvedge {
namespace {

// A star-shaped polygon with 3 to 14 corners, often with deep notches.
Panel random_panel(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const int corners = 3 + static_cast<int>(unit(random) * 12);
    const double size = 0.05 + 0.6 * unit(random);
    const double roughness = unit(random);
    std::vector<Vec2d> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * kPi * (i + 0.7 * unit(random)) / corners;
        const double radius = size * (1 - 0.85 * roughness * unit(random));
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return polygon("random", points);
}

TEST(RandomPanels, become_sound_meshes_that_keep_their_outline) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> segment_count(1, 9);
    for (int run = 0; run < 200; ++run) {
        const Panel panel = random_panel(random);
        std::vector<int> segments;
        for (std::size_t i = 0; i < panel.edges.size(); ++i) segments.push_back(segment_count(random));
        if (outline_area_of({panel.vertices, {}, {0, 1, 2}, {}}) <= 0 && panel.vertices.size() == 3) continue;
        const bool is_relaxed = run % 4 == 0;  // what comes before relaxing must hold too, and is quick
        const PanelMesh mesh = triangulate(panel, segments, {.relaxations = is_relaxed ? 12 : 0});
        const GarmentMesh garment = as_garment(mesh);
        const std::vector<std::string> faults = check_mesh(garment);
        ASSERT_TRUE(faults.empty()) << "run " << run << ": " << faults[0];
        EXPECT_NEAR(area_of(mesh), outline_area_of(mesh), 1e-10) << "run " << run;
        EXPECT_EQ(topology_of(garment).euler, 1) << "run " << run;
        int outline_count = 0;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            EXPECT_EQ(mesh.runs[i].first, outline_count);
            EXPECT_EQ(mesh.runs[i].segments, segments[i]);
            outline_count += segments[i];
        }
        EXPECT_EQ(static_cast<int>(mesh.outline.size()), outline_count);
    }
}

// Sewn to its own mirror image all round, a panel is a pillow: a closed surface. Small and notched ones try every way
// in which inner edges of both sides can fall on each other.
TEST(RandomPanels, sewn_to_their_mirror_image_are_closed_surfaces) {
    std::mt19937 random(2);
    for (int run = 0; run < 100; ++run) {
        Pattern pattern;
        const Panel front = random_panel(random);
        std::vector<Vec2d> mirrored;
        for (auto p = front.vertices.rbegin(); p != front.vertices.rend(); ++p) mirrored.emplace_back(-p->x(), p->y());
        pattern.panels = {front, polygon("mirrored", mirrored)};
        const auto corners = static_cast<int>(mirrored.size());
        for (int i = 0; i < corners; ++i) {
            pattern.seams.push_back({{0, i}, {1, (2 * corners - 2 - i) % corners}, true});
        }
        const GarmentMesh sewn = merge_seams(assemble(pattern, {.relaxations = run % 4 == 0 ? 12 : 0})).mesh;
        const std::vector<std::string> faults = check_mesh(sewn);
        ASSERT_TRUE(faults.empty()) << "run " << run << ": " << faults[0];
        const Topology topology = topology_of(sewn);
        EXPECT_EQ(topology.euler, 2) << "run " << run;
        EXPECT_EQ(topology.boundary_loops, 0) << "run " << run;
    }
}

}  // namespace
}  // namespace selvedge
