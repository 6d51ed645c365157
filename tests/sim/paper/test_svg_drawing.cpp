// SVG of several programs becomes drawings.
#include "sim/paper/svg_drawing.h"

#include <numbers>

#include "sim/paper/svg_path.h"
#include "sim/pattern/outline.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

// The only path of an SVG with one element.
DrawnPath only_path(const std::string& element) {
    const Drawing drawing = read_svg(svg(element), "a.svg");
    EXPECT_EQ(drawing.parts.size(), 1U);
    EXPECT_EQ(drawing.parts[0].paths.size(), 1U);
    return drawing.parts[0].paths[0];
}

TEST(Svg, draws_every_command_of_a_path) {
    const DrawnPath path =
        only_path("<path id='a' d='M10,10h20V30l-5 5C20,40 15,40 12,35S8,25 10 22Q5 20 9,18T10,14z'/>");
    const std::vector<CurveKind> kinds{CurveKind::Line,  CurveKind::Line,      CurveKind::Line,      CurveKind::Cubic,
                                       CurveKind::Cubic, CurveKind::Quadratic, CurveKind::Quadratic, CurveKind::Line};
    ASSERT_EQ(path.edges.size(), kinds.size());
    for (std::size_t e = 0; e < kinds.size(); ++e) EXPECT_EQ(path.edges[e].kind, kinds[e]) << e;
    EXPECT_TRUE(path.is_closed);
    EXPECT_EQ(path.vertices[1], Vec2d(30, -10));                           // y is turned up
    EXPECT_LT((path.edges[4].control[0] - Vec2d(9, -30)).norm(), 1e-12);   // smooth: mirrored at (12, 35)
    EXPECT_LT((path.edges[6].control[0] - Vec2d(13, -16)).norm(), 1e-12);  // at (9, 18)
}

TEST(Svg, begins_a_smooth_curve_after_a_line_in_no_direction) {
    const DrawnPath path = only_path("<path d='M0,0L10,0S20,10 10,20z'/>");
    EXPECT_EQ(path.edges[1].control[0], Vec2d(10, 0));
}

TEST(Svg, keeps_circular_arcs_and_turns_elliptical_ones_into_cubics) {
    const DrawnPath round = only_path("<path d='M0,0A10,10 0 0 1 20,0L10,-30z'/>");
    ASSERT_EQ(round.edges[0].kind, CurveKind::Arc);
    Panel panel;
    panel.vertices = round.vertices;
    panel.edges = round.edges;
    const Vec2d top = outline_point(panel, panel.edges[0], 0.5);
    EXPECT_LT((top - Vec2d(10, 10)).norm(), 1e-9);  // clockwise on the page: over the top
    const DrawnPath vast = only_path("<path d='M0,0A1e200,1e190 0 0 1 20,5L10,-30z'/>");
    EXPECT_EQ(vast.edges[0].kind, CurveKind::Line);  // its centre is beyond what a double holds
    const DrawnPath oval = only_path("<ellipse cx='50' cy='60' rx='30' ry='20'/>");
    for (const OutlineEdge& edge : oval.edges) EXPECT_EQ(edge.kind, CurveKind::Cubic);
    Panel ellipse;
    ellipse.vertices = oval.vertices;
    ellipse.edges = oval.edges;
    for (const OutlineEdge& edge : ellipse.edges) {
        for (const double t : {0.2, 0.5, 0.9}) {
            const Vec2d p = outline_point(ellipse, edge, t) - Vec2d(50, -60);
            EXPECT_NEAR(std::hypot(p.x() / 30, p.y() / 20), 1, 1e-4);
        }
    }
    EXPECT_NEAR(std::abs(outline_area(ellipse)), std::numbers::pi * 600, 0.3 + 1e-4 * 2000);
}

TEST(Svg, follows_transforms_of_all_kinds_and_levels) {
    const DrawnPath path =
        only_path("<g transform='translate(10,20)'><rect width='4' height='2' transform='rotate(90) scale(2)'/></g>");
    EXPECT_LT((path.vertices[1] - Vec2d(10, -28)).norm(), 1e-9);
    const auto map = parse_transform("matrix(1,2,3,4,5,6) skewX(45)");
    ASSERT_TRUE(map);
    EXPECT_LT((*map * Vec2d(1, 1) - Vec2d(2 + 3 + 5, 4 + 4 + 6)).norm(), 1e-9);
    EXPECT_FALSE(parse_transform("rotate(1,2)"));
    EXPECT_FALSE(parse_transform("turn(3)"));
}

TEST(Svg, tells_its_unit_or_none) {
    const std::string rect = "<rect width='10' height='20'/>";
    EXPECT_NEAR(*read_svg(svg(rect), "").metres_per_unit, 0.001, 1e-12);
    EXPECT_FALSE(read_svg("<svg viewBox='0 0 9 9'>" + rect + "</svg>", "").metres_per_unit);
    EXPECT_NEAR(*read_svg("<svg width='2in' viewBox='0 0 4 9'>" + rect + "</svg>", "").metres_per_unit, 0.0127, 1e-12);
}

TEST(Svg, uses_symbols_and_refuses_to_use_itself) {
    const std::string used =
        "<defs><rect id='r' width='10' height='20'/></defs><use xlink:href='#r' x='5'/><use href='#r' x='50'/>";
    EXPECT_EQ(read_svg(svg(used), "").parts.size(), 2U);
    EXPECT_THROW(read_svg(svg("<g id='a'><use href='#a'/><rect width='9' height='9'/></g>"), ""), InputError);
}

TEST(Svg, finds_sewing_lines_grain_and_notches_of_plain_drawings) {
    const Drawing drawing =
        read_svg(svg("<g id='front'><rect width='100' height='150'/><rect x='10' y='10' width='80' height='130'/>"
                     "<path id='grain' d='M50,20V120'/><path d='M90,70h-6'/><text x='30' y='60'>Cut 2 mirrored from "
                     "fabric</text></g>"
                     "<rect inkscape:label='Sleeve' x='200' width='50' height='60'/>"),
                 "");
    ASSERT_EQ(drawing.parts.size(), 2U);
    const DrawnPart& front = drawing.parts[0];
    EXPECT_EQ(front.name, "front");
    EXPECT_EQ(drawing.parts[1].name, "Sleeve");
    EXPECT_EQ(front.paths[0].kind, LineKind::Cut);
    EXPECT_EQ(front.paths[1].kind, LineKind::Sew);
    EXPECT_EQ(front.paths[2].kind, LineKind::Grain);
    ASSERT_EQ(front.marks.size(), 1U);
    EXPECT_EQ(front.cut.pieces, 2);
    EXPECT_EQ(front.cut.are_mirrored, true);
}

TEST(Svg, closes_gaps_of_a_tenth_of_a_millimetre_and_says_so) {
    const Drawing drawing = read_svg(svg("<path d='M0,0H50V50H0V0.1'/>"), "");
    EXPECT_TRUE(drawing.parts[0].paths[0].is_closed);
    ASSERT_EQ(drawing.notes.size(), 1U);
    EXPECT_THROW(read_svg(svg("<path d='M0,0H50V50H0V10'/>"), ""), InputError);  // open by 10 mm
}

TEST(Svg, says_what_is_wrong_and_where) {
    const auto problem = [](const std::string& wrong) {
        return problem_of(wrong, [](const std::string& text) { return read_svg(text, "a.svg"); });
    };
    EXPECT_EQ(problem(svg("<path id='hem' d='M0,0L5,x'/>")),
              "a.svg: <path> 'hem': the path data are wrong at character 5");
    EXPECT_NE(problem("<svg>\n<g>\n</svg>").find("a.svg: line 3: not XML"), std::string::npos);
    EXPECT_EQ(problem(svg("")), "a.svg: no closed path: nothing that could be a panel");
}

TEST(Svg, tells_which_outline_is_open_and_how_far) {
    const auto problem = [](const std::string& wrong) {
        return problem_of(wrong, [](const std::string& text) { return read_svg(text, "a.svg"); });
    };
    EXPECT_EQ(problem(svg("<path id='hem' d='M0,0H50'/><path id='back' d='M0,0H50V50H0V10'/>")),
              "a.svg: <path> 'back': open by 10 mm, and no other line is closed: nothing that could be a panel");
    EXPECT_EQ(problem(svg("<g>\n<path d='M0,0H50V50H0V1.25'/></g>")),
              "a.svg: <path> in line 4: open by 1.25 mm, and no other line is closed: nothing that could be a panel");
    EXPECT_EQ(problem("<svg xmlns='http://www.w3.org/2000/svg'><path d='M0,0H50V50H0V10'/></svg>"),
              "a.svg: <path> in line 1: open by 10 units, and no other line is closed: nothing that could be a panel");
    // Beside closed ones it is left out, and told.
    const Drawing drawing = read_svg(
        svg("<path id='front' d='M0,0H50V50H0Z'/><path id='back' d='M100,0H150V50H100V1.2'/><path d='M0,90H99'/>"), "");
    EXPECT_EQ(drawing.parts.size(), 1U);
    EXPECT_EQ(drawing.notes,
              (std::vector<std::string>{
                  "<path> 'back': open by 1.2 mm, left out",
                  "2 open lines in no part, left out: is an outline not closed? The longest is <path> in line 3"}));
}

TEST(Svg, reads_a_bow_whose_halves_cancel_out) {
    EXPECT_EQ(read_svg(svg("<path id='bow' d='M0,0L50,50H0L50,0Z'/>"), "").parts.size(), 1U);
    EXPECT_THROW(read_svg(svg("<path d='M0,0L50,50L20,20Z'/>"), ""), InputError);  // only forth and back
}

TEST(Svg, reads_damaged_files_or_refuses_them) {
    const std::string text =
        svg("<g transform='rotate(3) scale(1.1)'><path id='a' d='M10,10h20V30l-5 5C20,40 15,40 12,35A5,5 0 0 1 9,9z'/>"
            "<use href='#a' x='60'/><rect x='120' width='30' height='20' rx='3'/></g>");
    const int refused = read_mutants(text, 3000, [](const std::string& mutant) { return read_svg(mutant, "m"); });
    EXPECT_GT(refused, 100);
    EXPECT_LT(refused, 2900);
}

}  // namespace
}  // namespace selvedge::sim
