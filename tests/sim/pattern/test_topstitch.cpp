#include <gtest/gtest.h>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/pattern_file.h"
#include "sim/pattern/topstitch_check.h"
#include "tests/sim/pattern/sample.h"

namespace selvedge::sim {
namespace {

Topstitch double_row() {
    return {.distances = {0.006, 0.004},
            .rows = 2,
            .stitch_length = 0.0025,
            .thread = {.colour = "#102030", .thickness = 0.0005}};
}

PatternDocument stitched() {
    PatternDocument document = parse_pattern(sample_text(), "");
    document.pattern.panels[0].edges[2].topstitch = double_row();
    document.pattern.panels[1].internal_lines = {
        {.name = "pocket", .points = {{-0.1, 0.1}, {-0.2, 0.1}}, .topstitch = double_row()}};
    document.pattern.seams[1].topstitch = Topstitch{.distances = {-0.006, -0.006}};
    return document;
}

TEST(Topstitch, is_equal_after_writing_and_reading_a_file) {
    const PatternDocument document = stitched();
    const std::string text = write_pattern(document);
    const PatternDocument again = parse_pattern(text, "");
    EXPECT_EQ(again.pattern.panels[0].edges[2].topstitch, double_row());
    EXPECT_EQ(again.pattern.panels[1].internal_lines[0].topstitch, double_row());
    EXPECT_EQ(again.pattern.seams, document.pattern.seams);
    EXPECT_EQ(write_pattern(again), text);
    EXPECT_NE(text.find(R"("seams": [{"panel": "front", "edge": 3, "topstitch": {"distances": [-0.6, -0.6]}}])"),
              std::string::npos)
        << text;
    PatternDocument plain = again;
    plain.pattern = parse_pattern(sample_text(), "").pattern;
    EXPECT_EQ(write_pattern(plain).find("topstitch"), std::string::npos);
}

TEST(Topstitch, of_a_seam_follows_a_panel_that_is_renamed) {
    PatternDocument document = stitched();
    document = parse_pattern(write_pattern(document), "");
    rename_panel_in_file(document.json, "front", "middle");
    document.pattern.panels[0].name = "middle";
    EXPECT_EQ(parse_pattern(write_pattern(document), "").pattern.seams, document.pattern.seams);
}

TEST(Topstitch, out_of_range_is_refused_with_its_place) {
    const std::string text = write_pattern(stitched());
    EXPECT_EQ(
        faults_of(replaced(text, "\"rows\": 2", "\"rows\": 10")),
        (std::vector<std::string>{
            "f.json: pattern.panels.front.edges[2].selvedge.topstitch.rows: 10 is not a whole number from 1 to 9"}));
    EXPECT_EQ(
        faults_of(replaced(text, "#102030", "blue")),
        (std::vector<std::string>{"f.json: pattern.panels.front.edges[2].selvedge.topstitch.thread.colour: 'blue' is "
                                  "no colour: #RRGGBB is"}));
    EXPECT_EQ(
        faults_of(replaced(text, "[-0.6, -0.6]", "[60, 1]")),
        (std::vector<std::string>{"f.json: selvedge.seams[0].topstitch.distances: a row of stitches is at most 10 cm "
                                  "from its line or the row before"}));
}

TEST(Topstitch, stays_on_its_side_of_the_cloth_where_a_panel_is_mirrored) {
    Panel panel;
    panel.vertices = {{0, 0}, {0.4, 0}, {0.4, 0.3}};
    panel.edges = {{.start = 0, .end = 1, .topstitch = double_row()}, {.start = 1, .end = 2}, {.start = 2, .end = 0}};
    panel.internal_lines = {{.name = "", .points = {{0.1, 0.05}, {0.3, 0.05}}, .topstitch = double_row()}};
    const Eigen::Affine2d mirror(Eigen::Scaling(-1.0, 1.0));
    const Panel image = mapped_panel(panel, mirror);
    EXPECT_EQ(image.edges[0].topstitch, double_row()) << "inside is inside";
    EXPECT_EQ(image.internal_lines[0].topstitch->distances, Vec2d(-0.006, -0.004));
    EXPECT_EQ(mapped_panel(image, mirror), panel);
    EXPECT_EQ(reversed_edge(panel.edges[0]).topstitch->distances, Vec2d(-0.006, -0.004));
}

// A square of 20 cm, whose edge 0 runs along the x axis to the right: its left is above.
Panel stitched_square() {
    Panel panel;
    panel.name = "square";
    panel.vertices = {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}};
    for (int e = 0; e < 4; ++e) panel.edges.push_back({.start = e, .end = (e + 1) % 4});
    return panel;
}

TEST(TopstitchCheck, finds_rows_off_the_cloth_and_rows_on_each_other) {
    const Panel panel = stitched_square();
    OutlineEdge edge = panel.edges[0];
    const auto problem = [&](const Topstitch& rows) {
        edge.topstitch = rows;
        return topstitch_problem(panel, edge).value_or("");
    };
    EXPECT_EQ(problem({}), "");
    EXPECT_EQ(problem({.distances = {-0.006, 0.006}}), "row 1 of the stitches lies off the cloth");
    EXPECT_EQ(problem({.distances = {0.1, 0.06}, .rows = 3}), "row 3 of the stitches lies off the cloth");
    EXPECT_EQ(problem({.distances = {0.006, 0}, .rows = 2}), "the rows of stitches lie on each other");
    EXPECT_EQ(problem({.distances = {0.006, 0.0003}, .rows = 2}), "the rows of stitches lie on each other");
    EXPECT_EQ(problem({.distances = {0.006, 0}, .rows = 1}), "");
    InternalLine line{.name = "", .points = {{0.01, 0.1}, {0.01, 0.15}}};
    line.topstitch = Topstitch{.distances = {0.006, 0.006}};
    EXPECT_FALSE(topstitch_problem(panel, line));
    line.topstitch->distances.x() = 0.02;
    EXPECT_EQ(topstitch_problem(panel, line), "row 1 of the stitches lies off the cloth");
}

TEST(TopstitchCheck, of_a_seam_looks_at_the_panel_of_each_side) {
    Pattern pattern;
    pattern.panels = {stitched_square(), stitched_square()};
    pattern.panels[1].vertices[2].y() = pattern.panels[1].vertices[3].y() = 0.02;  // a strip
    Seam seam{{0, 0}, {1, 0}};
    seam.topstitch = Topstitch{.distances = {0.05, 0.006}};
    EXPECT_FALSE(topstitch_problem(pattern, seam));
    seam.topstitch->distances.x() = -0.05;
    EXPECT_EQ(topstitch_problem(pattern, seam), "row 1 of the stitches lies off the cloth");
}

}  // namespace
}  // namespace selvedge::sim
