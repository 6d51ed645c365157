// What is not the shape of an edge, a line or a seam survives every edit of the shape.
#include <gtest/gtest.h>

#include "editor/geometry/linked_panels.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/seam_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/pattern/edge_shape.h"
#include "tests/editor/geometry/geometry_support.h"

namespace selvedge::editor {
namespace {

// A square whose edges all have an allowance with a corner and a label.
sim::Panel marked_square(const std::string& name) {
    sim::Panel panel = unit_square(name);
    for (sim::OutlineEdge& edge : panel.edges) {
        edge.label = "hem";
        edge.allowance = 0.02;
        edge.allowance_corner = sim::AllowanceCorner::Mirrored;
    }
    return panel;
}

sim::Pattern one_square() {
    sim::Pattern pattern;
    pattern.panels = {marked_square("square")};
    return pattern;
}

void expect_marked(const sim::OutlineEdge& edge) {
    EXPECT_EQ(edge.label, "hem");
    EXPECT_EQ(edge.allowance, 0.02);
    EXPECT_EQ(edge.allowance_corner, sim::AllowanceCorner::Mirrored);
}

void expect_marked(const sim::Panel& panel) {
    for (const sim::OutlineEdge& edge : panel.edges) expect_marked(edge);
}

sim::OutlineEdge arc_of_radius(double radius) {
    return {.kind = sim::CurveKind::Arc, .arc_radius = radius};
}

TEST(PropertiesOfEdges, are_kept_when_an_edge_is_bent_and_straightened) {
    sim::Pattern pattern = one_square();
    set_curve(pattern, {0, 1}, arc_of_radius(1));
    EXPECT_EQ(pattern.panels[0].edges[1].kind, sim::CurveKind::Arc);
    expect_marked(pattern.panels[0]);
    set_curve(pattern, {0, 1}, {});
    EXPECT_EQ(pattern.panels[0], one_square().panels[0]);
}

TEST(PropertiesOfEdges, are_kept_when_scaling_makes_an_arc_a_cubic) {
    sim::Pattern pattern = one_square();
    set_curve(pattern, {0, 1}, arc_of_radius(1));
    transform_panel(pattern, 0, Eigen::Affine2d(Eigen::Scaling(2.0, 1.0)));
    EXPECT_EQ(pattern.panels[0].edges[1].kind, sim::CurveKind::Cubic);
    expect_marked(pattern.panels[0]);
}

TEST(PropertiesOfEdges, are_those_of_the_first_edge_when_two_are_joined) {
    sim::Pattern pattern = one_square();
    set_curve(pattern, {0, 0}, arc_of_radius(1));
    const int straight = split_edge(pattern, {0, 2}, 0.4), curved = split_edge(pattern, {0, 0}, 0.5);
    expect_marked(pattern.panels[0]);
    remove_vertices(pattern, 0, {straight, curved});
    ASSERT_EQ(pattern.panels[0].edges.size(), 4U);
    expect_marked(pattern.panels[0]);
    remove_vertices(pattern, 0, {0});
    expect_marked(pattern.panels[0]);
}

TEST(PropertiesOfEdges, are_kept_when_a_sewing_slides_along_the_edge) {
    sim::Pattern pattern;
    pattern.panels = {marked_square("one"), marked_square("two"), marked_square("three")};
    sew_runs(pattern, {{0, 1}}, {{1, 3}, {2, 3}}, true);
    pattern.panels[0].edges[1].allowance = 0.03;
    slide_sewing(pattern, 0, SewingRun::First, 0.1);
    EXPECT_EQ(pattern.panels[0].edges[1].allowance, 0.03) << "the edge keeps its own";
    pattern.panels[0].edges[1].allowance = 0.02;
    for (const sim::Panel& panel : pattern.panels) expect_marked(panel);
}

TEST(PropertiesOfSeams, are_kept_when_a_sewing_is_reversed) {
    sim::Pattern pattern;
    pattern.panels = {unit_square("one"), unit_square("two"), unit_square("three")};
    sew_runs(pattern, {{0, 1}}, {{1, 3}, {2, 3}}, true);
    pattern.seams[0].name = "upper";
    pattern.seams[1].name = "lower";
    for (sim::Seam& seam : pattern.seams) seam.is_eased = true;
    const std::string sewing = pattern.seams[0].sewing;
    reverse_sewing(pattern, 0);
    ASSERT_EQ(pattern.seams.size(), 2U);
    EXPECT_NE(pattern.seams[0].name, pattern.seams[1].name);
    for (const sim::Seam& seam : pattern.seams) {
        EXPECT_TRUE(seam.name == "upper" || seam.name == "lower");
        EXPECT_TRUE(seam.is_eased);
        EXPECT_EQ(seam.sewing, sewing);
    }
    EXPECT_TRUE(can_be_saved(pattern));
}

TEST(PropertiesOfSeams, of_a_dart_are_copied_to_the_linked_panel_when_they_change) {
    sim::Pattern pattern;
    pattern.panels = {unit_square("left")};
    insert_dart(pattern, {0, 0}, 0.3, 0.1, 0.4);
    symmetric_copy(pattern, 0, true, {0, 0});
    ASSERT_EQ(pattern.seams.size(), 2U);
    pattern.seams[1].name = "dart of the copy";
    for (const std::size_t changed : {std::size_t(0), std::size_t(1)}) {
        const sim::Pattern before = pattern;
        pattern.seams[changed].is_eased = !pattern.seams[changed].is_eased;
        update_links(pattern, before);
        ASSERT_EQ(pattern.seams.size(), 2U);
        EXPECT_EQ(pattern.seams[0].is_eased, changed == 0);
        EXPECT_EQ(pattern.seams[1].is_eased, changed == 0);
        EXPECT_EQ(pattern.seams[1].name, "dart of the copy");
        EXPECT_EQ(pattern.seams[1].first, before.seams[1].first);
    }
}

TEST(PropertiesOfLines, are_kept_with_drill_points_when_a_panel_is_cut_and_merged) {
    sim::Pattern pattern = one_square();
    pattern.panels[0].internal_lines = {
        {.name = "fold", .points = {{0.2, 0.5}, {0.8, 0.5}}, .use = sim::LineUse::Fold}};
    pattern.panels[0].drill_points = {{0.1, 0.2}, {0.9, 0.2}, {0.9, 0.8}};
    const int other = cut_panel(pattern, 0, {{0.5, 0}, {0.5, 1}}, true);
    std::size_t holes = 0;
    for (const int p : {0, other}) {
        const sim::Panel& panel = pattern.panels[static_cast<std::size_t>(p)];
        ASSERT_EQ(panel.internal_lines.size(), 1U);
        EXPECT_EQ(panel.internal_lines[0].use, sim::LineUse::Fold);
        EXPECT_EQ(panel.internal_lines[0].name, "fold");
        const Eigen::AlignedBox2d box = outline_box(panel);
        for (const Vec2d& point : panel.drill_points) EXPECT_TRUE(box.contains(point)) << panel.name;
        holes += panel.drill_points.size();
    }
    EXPECT_EQ(holes, 3U);
    merge_panels(pattern, 0);
    ASSERT_EQ(pattern.panels.size(), 1U);
    EXPECT_EQ(pattern.panels[0].drill_points.size(), 3U);
    EXPECT_EQ(pattern.panels[0].internal_lines.size(), 2U);
}

}  // namespace
}  // namespace selvedge::editor
