// Drawings that nest, repeat or count beyond measure, and numbers that are none: they are refused with a line, or read
// as what they say.
#include <cmath>

#include <gtest/gtest.h>

#include "sim/paper/dxf_drawing.h"
#include "sim/paper/dxf_entities.h"
#include "sim/paper/dxf_text.h"
#include "sim/paper/grade_rules.h"
#include "sim/paper/svg_shapes.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

std::string svg_problem(const std::string& elements) {
    return problem_of(svg(elements), [](const std::string& text) { return read_svg_document(text, "a.svg"); });
}

std::size_t seen_shapes(const std::string& elements) {
    return read_svg_document(svg(elements), "a.svg").shapes.size();
}

const std::string kSquare = "<path class='a' d='M0,0H9V9H0Z'/>";

TEST(SvgStyles, follow_media_rules_in_each_other_to_a_depth) {
    const auto nested = [](int depth) {
        return "<style>" + repeated("@media screen{", depth) + ".a{display:none}" + repeated("}", depth) + "</style>" +
               kSquare;
    };
    EXPECT_EQ(seen_shapes(nested(10)), 0U);
    EXPECT_EQ(seen_shapes(nested(30000)), 1U);
}

TEST(SvgStyles, tell_of_rules_that_could_hide_and_are_left_out) {
    const auto notes = [](const std::string& css) {
        return read_svg_document(svg("<style>" + css + "</style>" + kSquare), "a.svg").notes;
    };
    EXPECT_TRUE(notes(".a:hover{fill:none}").empty());
    ASSERT_EQ(notes(".a:not(.b){display:none !important}").size(), 1U);
    ASSERT_EQ(notes(repeated(".b{fill:red}", 2000) + ".a{display:none}").size(), 1U);
    // What says nothing of what is drawn is no rule.
    EXPECT_EQ(notes(repeated(".b{font-size:1px}", 2000) + ".a{display:none}")[0], "1 hidden element left out");
}

TEST(SvgStyles, refuse_more_rules_than_they_can_compare_with_elements) {
    const std::string file = "<style>" + repeated("x .a{fill:red}", 2000) + "</style>" + repeated("<g>", 100) +
                             repeated(kSquare, 4000) + repeated("</g>", 100);
    EXPECT_EQ(svg_problem(file), "a.svg: its style sheets have too many rules for so many elements");
}

TEST(SvgStyles, let_a_child_draw_what_its_parent_does_not) {
    const auto shapes = [](const std::string& parent, const std::string& child) {
        return seen_shapes("<g fill='none' stroke='black' " + parent + "><path d='M0,0H9' " + child + "/></g>");
    };
    EXPECT_EQ(shapes("stroke-width='0'", ""), 0U);
    EXPECT_EQ(shapes("stroke-width='0'", "stroke-width='2'"), 1U);
    EXPECT_EQ(shapes("stroke-width='0'", "stroke-opacity='1'"), 0U);
    EXPECT_EQ(shapes("stroke-opacity='0'", "stroke-width='2'"), 0U);
}

TEST(SvgShapes, do_not_read_what_is_not_seen) {
    EXPECT_EQ(svg_problem("<path fill='none' d='M0,0 L no numbers'/>"), "nothing");
    EXPECT_NE(svg_problem("<path d='M0,0 L no numbers'/>"), "nothing");
}

TEST(SvgShapes, refuse_many_paths_deep_in_groups) {
    const std::string paths = "<path d='" + repeated("M0,0H1", 25000) + "' stroke='black'/>";
    EXPECT_EQ(svg_problem(repeated("<g>", 200) + paths + repeated("</g>", 200)),
              "a.svg: <path>: too many shapes lie too deep in groups");
}

// ---- DXF.

std::string code(int number, const std::string& value) {
    return std::to_string(number) + "\n" + value + "\n";
}

std::string place_of(const Vec2d& p) {
    return code(10, std::to_string(p.x())) + code(20, std::to_string(p.y()));
}

std::string ring_of(const std::vector<Vec2d>& points) {
    std::string text = code(0, "POLYLINE") + code(8, "1") + code(70, "1");
    for (const Vec2d& p : points) text += code(0, "VERTEX") + code(8, "1") + place_of(p);
    return text + code(0, "SEQEND");
}

std::string block_of(const std::string& name, const std::string& content, const std::string& base = "0") {
    return code(0, "BLOCK") + code(8, "1") + code(2, name) + code(10, base) + code(20, "0") + content +
           code(0, "ENDBLK");
}

std::string placed(const std::string& name, const std::string& more = "") {
    return code(0, "INSERT") + code(8, "1") + code(2, name) + place_of({0, 0}) + more;
}

std::string dxf_of(const std::string& blocks, const std::string& entities) {
    const std::string unit = code(0, "TEXT") + code(8, "1") + place_of({0, 0}) + code(1, "Units: METRIC");
    return code(0, "SECTION") + code(2, "BLOCKS") + blocks + code(0, "ENDSEC") + code(0, "SECTION") +
           code(2, "ENTITIES") + unit + entities + code(0, "ENDSEC") + code(0, "EOF");
}

std::string dxf_problem(const std::string& text) {
    return problem_of(text, [](const std::string& one) { return read_dxf(one, "a.dxf"); });
}

// The size of the first path of each part, in units of the drawing.
std::vector<Vec2d> sizes_of(const Drawing& drawing) {
    std::vector<Vec2d> sizes;
    for (const DrawnPart& part : drawing.parts) {
        Eigen::AlignedBox2d box;
        for (const Vec2d& v : part.paths.at(0).vertices) box.extend(v);
        sizes.emplace_back(box.sizes());
    }
    return sizes;
}

const std::string kBox = ring_of({{0, 0}, {400, 0}, {400, 300}, {0, 300}});

std::string spline_of(const std::string& knot, const std::string& more = "") {
    return code(0, "SPLINE") + code(8, "1") + code(71, "2") + repeated(code(40, "-" + knot), 3) +
           repeated(code(40, knot), 3) + more + place_of({100, 0}) + place_of({100, 100}) + place_of({0, 100});
}

TEST(DxfSplines, refuse_knots_and_weights_that_give_no_points) {
    EXPECT_NE(dxf_problem(dxf_of("", kBox + spline_of("1e308"))).find("'-1e308' is no coordinate"), std::string::npos);
    EXPECT_NE(dxf_problem(dxf_of("", kBox + spline_of("1", repeated(code(41, "0"), 3)))).find("a weight"),
              std::string::npos);
}

TEST(DxfSplines, draw_circles_by_their_weights) {
    DxfPiece piece;
    const std::set<std::string> hidden;
    std::vector<std::string> notes;
    const std::string file = "a.dxf", text = spline_of("1", code(41, "1") + code(41, "0.70710678") + code(41, "1"));
    DxfEntity entity{.type = "SPLINE", .line = 1, .groups = parse_dxf(text, file)};
    DxfEntityReader(file, hidden, notes).read({entity}, 0, piece);
    ASSERT_EQ(piece.lines.size(), 1U);
    for (const Vec2d& p : piece.lines[0].points) EXPECT_NEAR(p.norm(), 100, 1e-5);
}

TEST(DxfBlocks, refuse_places_that_are_no_numbers_or_too_large) {
    const std::string outer = block_of("outer", kBox + placed("inner"));
    const std::string problem = "block 'outer': where it is placed, a point is not a number, or too large";
    EXPECT_NE(dxf_problem(dxf_of(outer + block_of("inner", kBox, "1e300"), placed("outer"))).find(problem),
              std::string::npos);
    const std::string large = code(41, "1e6") + code(42, "1e6");
    EXPECT_NE(dxf_problem(dxf_of(block_of("outer", kBox), placed("outer", large))).find(problem), std::string::npos);
}

TEST(DxfBlocks, refuse_more_vertices_than_they_can_place) {
    std::vector<Vec2d> many;
    for (int i = 0; i < 3000; ++i) many.emplace_back(300 * std::cos(0.002 * i), 300 * std::sin(0.002 * i));
    const std::string blocks =
        block_of("outer", kBox + repeated(placed("inner"), 700)) + block_of("inner", ring_of(many));
    EXPECT_NE(dxf_problem(dxf_of(blocks, placed("outer"))).find("more than 2 million vertices"), std::string::npos);
}

TEST(DxfBlocks, are_pieces_whatever_a_program_calls_them_where_they_are_placed) {
    for (const std::string name : {"*U3", "$a"}) {
        EXPECT_EQ(dxf_problem(dxf_of(block_of(name, kBox), placed(name))), "nothing") << name;
        EXPECT_NE(dxf_problem(dxf_of(block_of(name, kBox), "")), "nothing") << name;
    }
    for (const std::string name : {"*Model_Space", "$PAPER_SPACE"})
        EXPECT_NE(dxf_problem(dxf_of(block_of(name, kBox), placed(name))), "nothing") << name;
}

TEST(DxfBlocks, are_pieces_per_stretch) {
    const std::string entities = placed("a") + placed("a", code(50, "90")) +
                                 placed("a", code(41, "2") + code(42, "0.5")) +
                                 placed("a", code(41, "0.5") + code(42, "2"));
    const std::vector<Vec2d> sizes = sizes_of(read_dxf(dxf_of(block_of("a", kBox), entities), "a.dxf"));
    EXPECT_EQ(sizes, (std::vector<Vec2d>{{400, 300}, {800, 150}, {200, 600}}));
}

// ---- Grading.

std::string text_at(const Vec2d& p, const std::string& words) {
    return code(0, "TEXT") + code(8, "2") + place_of(p) + code(1, words);
}

// A block of 400 by 300 mm whose right side moves by 30 mm in size L.
Drawing graded(const std::string& more, const std::string& way) {
    const GradeRules rules = parse_grade_rules(
        "UNITS: METRIC\nSIZE LIST: M L\nSAMPLE SIZE: M\nRULE: 1\n0 0 0 0\nRULE: DELTA 2\n0 0 30 0\nEND\n", "t.rul");
    const std::string numbers =
        text_at({0, 0}, "# 1") + text_at({400, 0}, "# 2") + text_at({400, 300}, "# 2") + text_at({0, 300}, "# 1");
    return read_dxf(dxf_of(block_of("a", kBox + numbers + more), placed("a", way)), "a.dxf", &rules);
}

TEST(GradedPieces, move_their_points_as_the_block_is_turned_and_mirrored) {
    for (const std::string& way : {std::string(), code(41, "-1"), code(50, "180")}) {
        const std::vector<Vec2d> sizes = sizes_of(graded("", way));
        ASSERT_EQ(sizes.size(), 2U) << way;
        EXPECT_NEAR(sizes[1].x(), 430, 1e-9) << way;
    }
}

}  // namespace
}  // namespace selvedge::sim
