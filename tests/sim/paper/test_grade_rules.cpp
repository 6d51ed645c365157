// Grade rule tables, and the sizes of DXF pieces that they make.
#include "sim/paper/grade_rules.h"

#include <gtest/gtest.h>

#include "sim/paper/dxf_drawing.h"
#include "sim/paper/make_panels.h"
#include "sim/pattern/edge_shape.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

const std::string kTable =
    "ASTM/D13Proposal 1 Version: D 6673-04\r\nAUTHOR: A\r\nUNITS: METRIC\r\nGRADE RULE TABLE: T\r\n"
    "NUMBER OF SIZES: 3\r\nSIZE LIST: S M L\r\nSAMPLE SIZE: M\r\n"
    "RULE: DELTA 1\r\n  0.0, 0.0   0.0, 0.0   0.0, 0.0\r\n"
    "RULE: DELTA 2\r\n  -20.0, 0.0\r\n  0.0, -0.0  # the sample\r\n  +30.0, 10.0\r\nEND\r\n";

TEST(GradeRules, have_a_move_for_each_size) {
    const GradeRules rules = parse_grade_rules(kTable, "t.rul");
    EXPECT_EQ(rules.sizes, (std::vector<std::string>{"S", "M", "L"}));
    EXPECT_EQ(rules.sample_size, "M");
    ASSERT_EQ(rules.moves.size(), 2U);
    EXPECT_EQ(rules.moves.at(2)[2], Vec2d(30, 10));
    EXPECT_EQ(rules.metres_per_unit, 0.001);
}

TEST(GradeRules, name_the_line_of_what_is_wrong) {
    const auto problem = [](const std::string& text) {
        return problem_of(text, [](const std::string& one) { return parse_grade_rules(one, "t.rul"); });
    };
    EXPECT_EQ(problem("AUTHOR: A\n"), "t.rul: line 1: it lists no sizes");
    EXPECT_EQ(problem("SIZE LIST: S M\nSAMPLE SIZE: L\n"), "t.rul: line 2: the sample size 'L' is none of its sizes");
    EXPECT_EQ(problem("SIZE LIST: S M\nSAMPLE SIZE: M\nRULE: DELTA 1\n0 0\nEND\n"),
              "t.rul: line 5: rule 1 has 1 moves for 2 sizes");
    EXPECT_EQ(problem("SIZE LIST: S\nRULE: DELTA 1\n0 x\n"), "t.rul: line 3: 'x' is no move of a point");
}

TEST(GradeLine, moves_points_between_in_proportion_to_their_distance) {
    std::vector<Vec2d> line{{0, 0}, {1, 0}, {4, 0}};
    grade_line(line, {{0, Vec2d(0, 0)}, {2, Vec2d(0, 8)}}, false);
    EXPECT_EQ(line[1], Vec2d(1, 2));
    std::vector<Vec2d> ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}};  // from point 1 on, back to it
    grade_line(ring, {{1, Vec2d(3, 0)}}, true);
    EXPECT_EQ(ring[3], Vec2d(3, 1));
}

TEST(GradeRules, make_the_sizes_of_a_piece) {
    const std::vector<Vec2d> corners{{0, 0}, {400, 0}, {400, 300}, {400, 600}, {0, 600}};
    std::string text = dxf_group(0, "SECTION") + dxf_group(2, "BLOCKS") + dxf_group(0, "BLOCK") +
                       dxf_group(2, "FRONT") + dxf_group(0, "POLYLINE") + dxf_group(8, "1") + dxf_group(70, "1");
    const auto place = [](const Vec2d& p) {
        return dxf_group(10, std::to_string(p.x())) + dxf_group(20, std::to_string(p.y()));
    };
    for (const Vec2d& p : corners) text += dxf_group(0, "VERTEX") + dxf_group(8, "1") + place(p);
    text += dxf_group(0, "SEQEND");
    const std::vector<std::pair<Vec2d, std::string>> numbers{
        {corners[0], "# 1"}, {corners[1], "# 2"}, {corners[3], "#2"}, {corners[4], "# 1"}};
    for (const auto& [at, number] : numbers)
        text += dxf_group(0, "TEXT") + dxf_group(8, "2") + place(at) + dxf_group(1, number);
    text += dxf_group(0, "ENDBLK") + dxf_group(0, "ENDSEC") + dxf_group(0, "SECTION") + dxf_group(2, "ENTITIES") +
            dxf_group(0, "TEXT") + dxf_group(8, "1") + dxf_group(1, "Units: METRIC") + dxf_group(0, "ENDSEC");
    const GradeRules rules = parse_grade_rules(kTable, "t.rul");
    const Drawing drawing = read_dxf(text, "a.dxf", &rules);
    EXPECT_EQ(drawing.sample_size, "M");
    const auto width = [&](const std::string& size) -> Vec2d {
        const PanelsOfDrawing made = make_panels(drawing, "a.dxf", {.size = size});
        EXPECT_EQ(made.pattern.panels.size(), 1U);
        return outline_box(made.pattern.panels.at(0)).sizes();
    };
    EXPECT_NEAR(width("").x(), 0.4, 1e-9);
    EXPECT_NEAR(width("S").x(), 0.38, 1e-9);
    EXPECT_NEAR(width("L").x(), 0.43, 1e-9);
    // Without numbers at its points the table says nothing, and that is told.
    std::string bare = text;
    for (std::size_t at = bare.find('#'); at != std::string::npos; at = bare.find('#')) bare[at] = 'x';
    const Drawing drawn = read_dxf(bare, "a.dxf", &rules);
    EXPECT_EQ(drawn.parts.size(), 1U);
    ASSERT_FALSE(drawn.notes.empty());
    EXPECT_NE(drawn.notes[0].find("no point has the number of a rule"), std::string::npos);
}

}  // namespace
}  // namespace selvedge::sim
