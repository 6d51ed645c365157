// Drawings become panels.
#include "sim/paper/make_panels.h"

#include <cmath>
#include <map>

#include "sim/paper/cut_line.h"
#include "sim/paper/drawing_file.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"
#include "sim/proposals/seam_proposals.h"
#include "tests/sim/paper/drawings.h"
#include "tests/support/notes.h"

namespace selvedge::sim {
namespace {

DrawnPath rectangle(LineKind kind, const Vec2d& low, const Vec2d& high) {
    DrawnPath path{.kind = kind, .vertices = {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, .edges = {}};
    for (int i = 0; i < 4; ++i) path.edges.push_back({.start = i, .end = (i + 1) % 4});
    path.is_closed = true;
    return path;
}

Drawing one_part(DrawnPart part) {
    Drawing drawing;
    drawing.parts.push_back(std::move(part));
    drawing.metres_per_unit = 0.001;
    return drawing;
}

TEST(MakePanels, unfolds_a_half_that_is_cut_on_the_fold) {
    const PanelsOfDrawing made = make_panels(parse_drawing(half_front_json(), ""), "");
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    const Panel& front = made.pattern.panels[0];
    EXPECT_EQ(front.edges.size(), 10U);
    EXPECT_NEAR(outline_box(front).sizes().x(), 0.52, 1e-6);
    EXPECT_NEAR(front.grain_angle, 0, 1e-12);
    ASSERT_EQ(front.notches.size(), 2U);
    EXPECT_EQ(front.notches[0].count, 2);
    EXPECT_EQ(made.pattern.allowance, 0.01);
    EXPECT_FALSE(made.is_unit_guessed);
}

TEST(MakePanels, take_the_allowance_off_where_only_the_cut_line_is_drawn) {
    DrawnPart part{.name = "front", .paths = {rectangle(LineKind::Cut, {0, 0}, {300, 400})}};
    const PanelsOfDrawing made = make_panels(one_part(part), "", {.allowance = 0.01});
    const Eigen::AlignedBox2d box = outline_box(made.pattern.panels[0]);
    EXPECT_NEAR(box.sizes().x(), 0.28, 1e-9);
    EXPECT_NEAR(box.sizes().y(), 0.38, 1e-9);
    EXPECT_EQ(made.pattern.panels[0].allowance, 0.01);
    const PanelsOfDrawing whole = make_panels(one_part(part), "");
    EXPECT_NEAR(outline_box(whole.pattern.panels[0]).sizes().x(), 0.3, 1e-9);
    EXPECT_FALSE(whole.notes.empty());
}

DrawnPath open_line(LineKind kind, std::vector<Vec2d> vertices) {
    DrawnPath path{.kind = kind, .vertices = std::move(vertices), .edges = {}};
    for (int i = 0; i + 1 < static_cast<int>(path.vertices.size()); ++i)
        path.edges.push_back({.start = i, .end = i + 1});
    return path;
}

TEST(MakePanels, cut_a_dart_that_is_drawn_inside_into_the_outline) {
    const DrawnPath outline = rectangle(LineKind::Sew, {0, 0}, {300, 400});
    const Vec2d below(300, 180), tip(160, 200), above(300, 220);
    const std::vector<std::vector<DrawnPath>> drawings{
        {open_line(LineKind::Internal, {below, tip, above})},
        {open_line(LineKind::Help, {above, tip, below})},
        {open_line(LineKind::Internal, {below, tip}), open_line(LineKind::Internal, {tip, above})}};
    for (const std::vector<DrawnPath>& dart : drawings) {
        DrawnPart part{.name = "front", .paths = dart};
        part.paths.push_back(outline);
        const PanelsOfDrawing made = make_panels(one_part(part), "");
        const Panel& panel = made.pattern.panels[0];
        EXPECT_EQ(panel.edges.size(), 7U);
        EXPECT_TRUE(panel.internal_lines.empty());
        EXPECT_NEAR(outline_area(panel), 0.3 * 0.4 - 0.04 * 0.14 / 2, 1e-9);
        EXPECT_EQ(made.notes, std::vector<std::string>{"front: a dart is drawn inside the outline: cut into it"});
    }
}

TEST(MakePanels, leave_lines_that_are_no_dart) {
    const std::vector<std::vector<Vec2d>> lines{{{300, 180}, {160, 200}, {300, 260}},  // legs of two lengths
                                                {{300, 50}, {200, 200}, {300, 350}},   // too wide
                                                {{290, 180}, {160, 200}, {290, 220}},  // ends inside
                                                {{300, 190}, {285, 200}, {300, 210}},  // a notch
                                                {{300, 200}, {150, 398}, {0, 200}}};   // its mouth is the other side
    for (const std::vector<Vec2d>& line : lines) {
        const DrawnPart part{
            .name = "front",
            .paths = {rectangle(LineKind::Sew, {0, 0}, {300, 400}), open_line(LineKind::Internal, line)}};
        const PanelsOfDrawing made = make_panels(one_part(part), "");
        EXPECT_EQ(made.pattern.panels[0].edges.size(), 4U);
        EXPECT_EQ(made.pattern.panels[0].internal_lines.size(), 1U);
    }
}

TEST(MakePanels, guess_a_unit_from_the_size_and_say_so) {
    Drawing drawing = one_part({.name = "a", .paths = {rectangle(LineKind::Unknown, {0, 0}, {20, 28})}});
    drawing.metres_per_unit.reset();
    const PanelsOfDrawing made = make_panels(drawing, "");
    EXPECT_TRUE(made.is_unit_guessed);
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().y(), 0.28, 1e-9);  // cm
    const PanelsOfDrawing told = make_panels(drawing, "", {.metres_per_unit = 0.0254});
    EXPECT_NEAR(outline_box(told.pattern.panels[0]).sizes().y(), 28 * 0.0254, 1e-9);
    EXPECT_FALSE(told.is_unit_guessed);
}

TEST(MakePanels, make_curves_again_of_curves_that_were_drawn_as_lines) {
    DrawnPath path{.kind = LineKind::Sew, .vertices = {{-300, 0}, {300, 0}}, .edges = {}, .is_closed = true};
    constexpr int kFacets = 60;  // of a half circle
    for (int i = 1; i < kFacets; ++i) {
        const double angle = std::acos(-1) * i / kFacets;
        path.vertices.emplace_back(300 * std::cos(angle), 300 * std::sin(angle));
    }
    const int count = static_cast<int>(path.vertices.size());
    for (int i = 0; i < count; ++i) path.edges.push_back({.start = i, .end = (i + 1) % count});
    const PanelsOfDrawing made = make_panels(one_part({.name = "flap", .paths = {path}}), "");
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    const Panel& panel = made.pattern.panels[0];
    EXPECT_LE(panel.edges.size(), 6U);
    const double pi = std::acos(-1);
    EXPECT_NEAR(outline_area(panel), pi * 0.3 * 0.3 / 2, 2e-4);
    // A polygon of many real corners stays as it is.
    DrawnPath star{.kind = LineKind::Sew, .vertices = {}, .edges = {}, .is_closed = true};
    for (int i = 0; i < 40; ++i) {
        const double radius = i % 2 == 0 ? 300 : 200, angle = 2 * pi * i / 40;
        star.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        star.edges.push_back({.start = i, .end = (i + 1) % 40});
    }
    EXPECT_EQ(make_panels(one_part({.name = "star", .paths = {star}}), "").pattern.panels[0].edges.size(), 40U);
}

TEST(MakePanels, add_the_second_of_a_mirrored_pair) {
    DrawnPart part{.name = "pocket", .paths = {rectangle(LineKind::Sew, {0, 0}, {300, 400})}};
    part.paths[0].vertices[2] = {250, 420};
    part.cut = {.pieces = 2, .are_mirrored = true, .is_on_fold = {}, .material = {}};
    const PanelsOfDrawing made = make_panels(one_part(part), "");
    ASSERT_EQ(made.pattern.panels.size(), 2U);
    EXPECT_EQ(made.pattern.panels[1].mirror_of, "pocket");
    EXPECT_NEAR(outline_area(made.pattern.panels[0]), outline_area(made.pattern.panels[1]), 1e-12);
    part.cut.is_on_fold = true;  // without a fold edge: two pieces from folded cloth
    EXPECT_EQ(make_panels(one_part(part), "").pattern.panels.size(), 2U);
    part.paths.push_back(
        {.kind = LineKind::FoldEdge, .vertices = {{0, 50}, {0, 350}}, .edges = {{.start = 0, .end = 1}}});
    EXPECT_EQ(make_panels(one_part(part), "").pattern.panels.size(), 1U);
}

TEST(MakePanels, take_one_size_of_several) {
    Drawing drawing = one_part({.name = "front", .paths = {rectangle(LineKind::Sew, {0, 0}, {300, 400})}, .size = "S"});
    drawing.parts.push_back({.name = "front", .paths = {rectangle(LineKind::Sew, {0, 0}, {320, 420})}, .size = "M"});
    EXPECT_EQ(make_panels(drawing, "").pattern.size, "S");
    const PanelsOfDrawing medium = make_panels(drawing, "", {.size = "M"});
    ASSERT_EQ(medium.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_box(medium.pattern.panels[0]).sizes().x(), 0.32, 1e-9);
    EXPECT_THROW(make_panels(drawing, "", {.size = "XL"}), InputError);
}

TEST(MakePanels, refuse_an_outline_that_crosses_itself_and_name_the_place) {
    DrawnPart part{.name = "bow", .paths = {rectangle(LineKind::Sew, {0, 0}, {300, 400})}};
    std::swap(part.paths[0].vertices[2], part.paths[0].vertices[3]);
    part.paths[0].vertices[2].x() = 10;
    try {
        make_panels(one_part(part), "a.svg");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("a.svg: bow: the outline crosses or touches itself near ("),
                  std::string::npos)
            << error.what();
    }
}

TEST(MakePanels, tell_the_crossing_of_a_bow_whose_halves_cancel_out) {
    DrawnPart part{.name = "bow", .paths = {rectangle(LineKind::Sew, {0, 0}, {300, 400})}};
    std::swap(part.paths[0].vertices[2], part.paths[0].vertices[3]);
    EXPECT_EQ(problem_of("", [&](const std::string&) { return make_panels(one_part(part), "a.svg"); }),
              "a.svg: bow: the outline crosses or touches itself near (150, 200)");
}

TEST(MakePanels, tell_which_outline_is_open_and_how_far) {
    DrawnPath path = rectangle(LineKind::Sew, {0, 0}, {300, 400});
    path.is_closed = false;
    path.vertices.push_back({0, 3});
    path.edges.back().end = 4;
    path.place = "parts.front.paths.seam";
    Drawing drawing = one_part({.name = "front", .paths = {path}});
    EXPECT_EQ(problem_of("", [&](const std::string&) { return make_panels(drawing, "a.json"); }),
              "a.json: no closed outline: parts.front.paths.seam is open by 3 mm");
    drawing.parts.push_back({.name = "back", .paths = {rectangle(LineKind::Sew, {0, 0}, {300, 400})}});
    const std::vector<std::string> notes = make_panels(drawing, "a.json").notes;
    EXPECT_NE(std::ranges::find(notes, "front: no closed outline, left out: parts.front.paths.seam is open by 3 mm"),
              notes.end());
}

DrawnPath polygon(std::vector<Vec2d> corners) {
    DrawnPath path{.kind = LineKind::Sew, .vertices = std::move(corners), .edges = {}};
    const int count = static_cast<int>(path.vertices.size());
    for (int i = 0; i < count; ++i) path.edges.push_back({.start = i, .end = (i + 1) % count});
    path.is_closed = true;
    return path;
}

TEST(MakePanels, take_off_a_line_that_runs_forth_and_back) {
    const DrawnPath path = polygon({{0, 0}, {300, 0}, {300, 400}, {200, 400}, {340, 400}, {340, 400.001}, {0, 400}});
    const PanelsOfDrawing made = make_panels(one_part({.name = "front", .paths = {path}}), "");
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(std::abs(outline_area(made.pattern.panels[0])), 0.12, 1e-6);
    EXPECT_TRUE(has_note(made.notes, "forth and back"));
}

TEST(MakePanels, open_a_dart_that_is_closed_at_the_hem) {
    const DrawnPath path = polygon({{0, 0},
                                    {150, 0},
                                    {150, 5},
                                    {140, 100},
                                    {150, 250},
                                    {160, 100},
                                    {150, 5},
                                    {150, 0},
                                    {300, 0},
                                    {300, 400},
                                    {0, 400}});
    const PanelsOfDrawing made = make_panels(one_part({.name = "front", .paths = {path}}), "");
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_EQ(made.pattern.panels[0].edges.size(), 11U);
    EXPECT_TRUE(find_outline_crossings(made.pattern.panels[0]).empty());
    EXPECT_TRUE(has_note(made.notes, "moved apart"));
}

TEST(MakePanels, cut_off_a_small_loop) {
    const DrawnPath path =
        polygon({{0, 0}, {300, 0}, {300, 400}, {40, 400}, {-10, 385}, {-10, 415}, {20, 395}, {0, 380}});
    const PanelsOfDrawing made = make_panels(one_part({.name = "front", .paths = {path}}), "");
    ASSERT_FALSE(made.pattern.panels.empty());
    EXPECT_TRUE(find_outline_crossings(made.pattern.panels[0]).empty());
    // From (40, 400) the outline runs to where it crosses itself, and on to (0, 380).
    EXPECT_NEAR(std::abs(outline_area(made.pattern.panels[0])), 0.1196, 1e-4);
    EXPECT_TRUE(has_note(made.notes, "was cut off"));
}

TEST(MakePanels, join_lines_that_make_the_outline_together) {
    DrawnPath sides{.kind = LineKind::Internal, .vertices = {{0, 400}, {0, 0}, {300, 0}, {300, 400}}, .edges = {}};
    for (int i = 0; i < 3; ++i) sides.edges.push_back({.start = i, .end = i + 1});
    const DrawnPath top{
        .kind = LineKind::Internal, .vertices = {{0, 400.1}, {300, 400}}, .edges = {{.start = 0, .end = 1}}};
    const DrawnPath mark{
        .kind = LineKind::Internal, .vertices = {{50, 50}, {90, 50}}, .edges = {{.start = 0, .end = 1}}};
    const PanelsOfDrawing made = make_panels(one_part({.name = "front", .paths = {mark, top, sides}}), "");
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_EQ(made.pattern.panels[0].edges.size(), 4U);
    EXPECT_NEAR(std::abs(outline_area(made.pattern.panels[0])), 0.12, 1e-4);
    EXPECT_EQ(made.pattern.panels[0].internal_lines.size(), 1U) << "the mark";
    EXPECT_TRUE(has_note(made.notes, "joined"));
}

TEST(MakePanels, take_no_dart_that_is_drawn_as_two_lines_for_the_outline) {
    DrawnPath outline = rectangle(LineKind::Unknown, {0, 0}, {300, 400});
    DrawnPath left{.kind = LineKind::Internal, .vertices = {{150, 100}, {140, 200}, {150, 300}}, .edges = {}};
    for (int i = 0; i < 2; ++i) left.edges.push_back({.start = i, .end = i + 1});
    DrawnPath right = left;
    right.vertices[1].x() = 160;
    const PanelsOfDrawing made = make_panels(one_part({.name = "front", .paths = {outline, left, right}}), "");
    ASSERT_FALSE(made.pattern.panels.empty());
    EXPECT_NEAR(std::abs(outline_area(made.pattern.panels[0])), 0.12, 1e-9);
    EXPECT_EQ(made.pattern.panels[0].internal_lines.size(), 2U);
}

// The outline begins and ends with an overshoot of 5 mm.
TEST(MakePanels, cut_off_a_loop_where_the_outline_begins) {
    const DrawnPath path = polygon({{0, 0}, {200, 0}, {600, 0}, {600, 800}, {0.5, 800}, {0.5, -5}});
    const PanelsOfDrawing made = make_panels(one_part({.name = "front", .paths = {path}}), "");
    ASSERT_FALSE(made.pattern.panels.empty());
    EXPECT_TRUE(find_outline_crossings(made.pattern.panels[0]).empty());
    EXPECT_NEAR(std::abs(outline_area(made.pattern.panels[0])), 0.5995 * 0.8, 1e-5);
}

TEST(MakePanels, pair_what_lies_beside_the_middle_of_a_garment_cut_on_the_fold) {
    DrawnPart middle{.name = "panel1", .paths = {rectangle(LineKind::Sew, {0, 0}, {100, 400})}};
    middle.paths.push_back(
        {.kind = LineKind::FoldEdge, .vertices = {{0, 0}, {0, 400}}, .edges = {{.start = 0, .end = 1}}});
    const DrawnPart side{.name = "panel2", .paths = {polygon({{200, 0}, {300, 0}, {290, 390}, {200, 400}})}};
    Drawing drawing = one_part(middle);
    drawing.parts.push_back(side);
    EXPECT_EQ(make_panels(drawing, "").pattern.panels.size(), 3U);
    drawing.parts[0].paths.pop_back();
    EXPECT_EQ(make_panels(drawing, "").pattern.panels.size(), 2U);
}

// FreeSewing draws the fold of each part that has one, and says of some others, too, that they are cut on it.
TEST(MakePanels, pair_a_half_whose_fold_only_its_text_names_where_the_folds_of_others_are_drawn) {
    DrawnPart back{.name = "back", .paths = {rectangle(LineKind::Sew, {0, 0}, {250, 600})}};
    back.paths.push_back(open_line(LineKind::FoldEdge, {{0, 50}, {0, 550}}));
    DrawnPart front{.name = "front", .paths = {polygon({{0, 0}, {300, 0}, {300, 400}, {200, 600}, {80, 600}})}};
    front.cut = {.pieces = 1, .are_mirrored = {}, .is_on_fold = true, .material = {}};
    Drawing drawing = one_part(front);
    EXPECT_EQ(make_panels(drawing, "").pattern.panels.size(), 1U) << "unfolded, if no fold is drawn at all";
    drawing.parts.push_back(back);
    EXPECT_EQ(make_panels(drawing, "").pattern.panels.size(), 2U) << "other programs need not draw each fold";
    drawing.format = "FreeSewing SVG";
    const PanelsOfDrawing made = make_panels(drawing, "");
    ASSERT_EQ(made.pattern.panels.size(), 3U);
    EXPECT_EQ(made.pattern.panels[2].mirror_of, "front");
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.3, 1e-9);
    EXPECT_NE(
        std::ranges::find(made.notes,
                          "front: cut on the fold by its text, but its fold is not drawn, as those of other parts "
                          "are: not unfolded"),
        made.notes.end());
}

TEST(MakePanels, unfold_a_half_collar_over_its_short_side_when_no_fold_is_drawn) {
    DrawnPart collar{.name = "collar", .paths = {polygon({{0, 0}, {210, 0}, {215, 70}, {0, 60}})}};
    collar.cut = {.pieces = 1, .are_mirrored = {}, .is_on_fold = true, .material = {}};
    const PanelsOfDrawing made = make_panels(one_part(collar), "");
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.43, 1e-9);
}

TEST(MakePanels, pair_a_half_on_the_fold_that_has_no_edge_long_enough_to_be_it) {
    DrawnPart front{.name = "front",
                    .paths = {polygon({{0, 0}, {250, 0}, {250, 200}, {230, 400}, {180, 600}, {80, 610}, {60, 400}})}};
    front.cut = {.pieces = 1, .are_mirrored = {}, .is_on_fold = true, .material = {}};
    const PanelsOfDrawing made = make_panels(one_part(front), "");
    ASSERT_EQ(made.pattern.panels.size(), 2U) << "a side below the armhole is no fold";
    EXPECT_EQ(made.pattern.panels[1].mirror_of, "front");
}

TEST(MakePanels, lay_the_ribs_of_ribbing_across_its_band_unless_its_grain_is_drawn) {
    DrawnPart band{.name = "waistband", .paths = {rectangle(LineKind::Sew, {0, 0}, {80, 800})}};
    const auto is_across = [&] {
        const Panel panel = make_panels(one_part(band), "").pattern.panels[0];
        const Vec2d size = outline_box(panel).sizes();
        const Vec2d grain(-std::sin(panel.grain_angle), std::cos(panel.grain_angle));
        return std::abs(size.x() < size.y() ? grain.x() : grain.y()) > 0.999;
    };
    EXPECT_FALSE(is_across()) << "woven cloth runs up the paper";
    band.cut.material = "ribbing";
    EXPECT_TRUE(is_across());
    band.paths[0] = rectangle(LineKind::Sew, {0, 0}, {800, 80});
    EXPECT_TRUE(is_across());
    band.paths.push_back(open_line(LineKind::Grain, {{100, 40}, {700, 40}}));
    EXPECT_FALSE(is_across());
}

TEST(MakePanels, turn_pieces_upright_that_lie_on_their_sides) {
    Drawing drawing = one_part({.name = "back", .paths = {rectangle(LineKind::Sew, {0, 0}, {600, 400})}});
    drawing.parts[0].paths[0].vertices = {{0, 100}, {600, 0}, {600, 400}, {0, 300}};  // narrow on the left: the top
    drawing.is_upright = false;
    const Panel back = make_panels(drawing, "").pattern.panels[0];
    const Eigen::AlignedBox2d box = outline_box(back);
    EXPECT_NEAR(box.sizes().y(), 0.6, 1e-9);
    double top = 0, hem = 0;
    for (const Vec2d& v : back.vertices) {
        if (v.y() > box.center().y()) top = std::max(top, std::abs(v.x() - box.center().x()));
        if (v.y() < box.center().y()) hem = std::max(hem, std::abs(v.x() - box.center().x()));
    }
    EXPECT_LT(top, hem);
}

TEST(MakePanels, measures_the_allowance_of_a_short_edge_square_to_it) {
    // A hem of 30 mm beside a side of 10 mm, and a short edge between them, nearer to the cut line of the side.
    const auto made =
        make_panels(parse_drawing(svg(R"(<path id="cut" class="cut" d="M 10 10 H 210 V 240 H 10 Z"/>)"
                                      R"(<path id="sew" class="sew" d="M 20 20 H 200 V 210 H 180 H 20 Z"/>)"),
                                  "hem.svg"),
                    "hem");
    const Panel& panel = made.pattern.panels.at(0);
    ASSERT_EQ(panel.edges.size(), 5U);
    ASSERT_TRUE(panel.allowance);
    EXPECT_NEAR(*panel.allowance, 0.01, 1e-6);
    int hems = 0;
    for (const OutlineEdge& edge : panel.edges) {
        const Vec2d middle = outline_point(panel, edge, 0.5);
        const bool is_hem = middle.y() < outline_box(panel).min().y() + 1e-6;
        EXPECT_NEAR(edge.allowance.value_or(0), is_hem ? 0.03 : 0, 1e-9) << middle.transpose();
        hems += is_hem ? 1 : 0;
    }
    EXPECT_EQ(hems, 2);
}

// ---- Cut lines.

Panel sample_panel() {
    Panel panel;
    panel.vertices = {{0, 0}, {0.4, 0}, {0.42, 0.5}, {0.3, 0.62}, {0.1, 0.6}, {-0.02, 0.3}};
    for (int i = 0; i < 6; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 6});
    panel.edges[0].kind = CurveKind::Quadratic;
    panel.edges[0].control[0] = {0.2, -0.03};
    panel.edges[2].kind = CurveKind::Cubic;
    panel.edges[2].control = {Vec2d(0.34, 0.5), Vec2d(0.31, 0.56)};
    panel.edges[4].kind = CurveKind::Arc;
    panel.edges[4].arc_radius = 0.5;
    return panel;
}

TEST(CutLine, is_everywhere_as_far_from_the_outline_as_the_allowance) {
    const Panel panel = sample_panel();
    const CutLine cut = cut_line(panel, {.pattern_allowance = 0.01});
    Panel ring;
    ring.vertices = cut.outline;
    for (std::size_t i = 0; i < cut.outline.size(); ++i) {
        ring.edges.push_back({.start = static_cast<int>(i), .end = static_cast<int>((i + 1) % cut.outline.size())});
    }
    EXPECT_GT(outline_area(ring), outline_area(panel));
    for (const OutlineEdge& edge : panel.edges) {
        for (const double t : {0.2, 0.5, 0.8}) {
            const Vec2d p = outline_point(panel, edge, t);
            double least = 1;
            for (const OutlineEdge& other : ring.edges) {
                const Vec2d a = ring.vertices[static_cast<std::size_t>(other.start)];
                const Vec2d d = ring.vertices[static_cast<std::size_t>(other.end)] - a;
                const double s = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
                least = std::min(least, (a + s * d - p).norm());
            }
            EXPECT_NEAR(least, 0.01, 5e-5);
        }
    }
}

TEST(CutLine, taken_off_again_gives_the_panel_back) {
    Panel panel = sample_panel();
    // Corners of the cut line go on straight beyond the curves, so that edges are divided there.
    const Panel inner = inset_panel(inset_panel(panel, -0.01), 0.01);
    EXPECT_NEAR(outline_area(inner), outline_area(panel), 5e-5);
    for (const OutlineEdge& edge : panel.edges) {
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            const Vec2d p = outline_point(panel, edge, t);
            double least = 1;
            for (const OutlineEdge& other : inner.edges) {
                for (int k = 0; k <= 2000; ++k)
                    least = std::min(least, (outline_point(inner, other, k / 2000.0) - p).norm());
            }
            EXPECT_LT(least, 2e-4) << t;
        }
    }
}

TEST(CutLine, carries_notches_out_square_to_the_outline) {
    Panel panel = sample_panel();
    panel.notches = {{.edge = 1, .t = 0.5, .kind = NotchKind::T, .count = 2}};
    panel.edges[1].allowance = 0.02;
    const CutLine cut = cut_line(panel, {.pattern_allowance = 0.01});
    ASSERT_EQ(cut.notches.size(), 1U);
    EXPECT_NEAR((cut.notches[0].on_cut - cut.notches[0].on_outline).norm(), 0.02, 1e-9);
    EXPECT_EQ(cut.notches[0].kind, NotchKind::T);
    EXPECT_EQ(cut.notches[0].count, 2);
}

// A rectangle whose upper edge is divided in the middle, where it turns by a slight angle.
Panel divided_strip(double rise) {
    Panel strip;
    strip.vertices = {{0, 0}, {0.4, 0}, {0.4, 0.1}, {0.2, 0.1 + rise}, {0, 0.1}};
    for (int i = 0; i < 5; ++i) strip.edges.push_back({.start = i, .end = (i + 1) % 5});
    return strip;
}

TEST(CutLine, steps_from_one_allowance_to_the_next_where_edges_go_on_nearly_straight) {
    for (const double rise : {-2e-4, -1e-6, 0.0, 1e-6, 2e-4}) {
        for (const int wide : {2, 3}) {
            Panel strip = divided_strip(rise);
            strip.edges[static_cast<std::size_t>(wide)].allowance = 0.03;
            const CutLine cut = cut_line(strip, {.pattern_allowance = 0.01});
            double length = 0;
            for (std::size_t i = 0; i < cut.outline.size(); ++i)
                length += (cut.outline[(i + 1) % cut.outline.size()] - cut.outline[i]).norm();
            // 0.42 m wide, 0.12 and 0.14 m high.
            EXPECT_NEAR(length, 2 * (0.42 + 0.14), 1e-3) << rise << " wide " << wide;
        }
    }
}

TEST(CutLine, ends_notches_near_corners_on_the_cut_line) {
    Panel panel = sample_panel();
    panel.vertices.insert(panel.vertices.begin() + 1, {0.2, 0.2});  // a hollow corner in the hem
    panel.edges.clear();
    for (int i = 0; i < 7; ++i) {
        panel.edges.push_back({.start = i, .end = (i + 1) % 7});
        for (const double t : {0.0, 0.005, 0.02, 0.5, 0.98, 0.995, 1.0}) panel.notches.push_back({.edge = i, .t = t});
    }
    panel.edges[3].allowance = 0.03;
    const CutLine cut = cut_line(panel, {.pattern_allowance = 0.01});
    for (std::size_t i = 0; i < cut.notches.size(); ++i) {
        EXPECT_LT(distance_to_outline(cut.notches[i].on_cut, cut.outline), 1e-4)
            << "edge " << panel.notches[i].edge << " at " << panel.notches[i].t;
    }
}

TEST(CutLine, taken_off_leaves_the_edges_all_that_is_not_their_shape) {
    Panel panel = sample_panel();
    for (OutlineEdge& edge : panel.edges) {
        edge.label = "hem";
        edge.allowance = 0.02;
        edge.allowance_corner = AllowanceCorner::Squared;
    }
    for (const OutlineEdge& edge : inset_panel(panel, 0.01).edges) {
        EXPECT_EQ(edge.label, "hem");
        EXPECT_EQ(edge.allowance, 0.02);
        EXPECT_EQ(edge.allowance_corner, AllowanceCorner::Squared);
    }
}

TEST(CutLine, refuses_an_allowance_that_leaves_nothing) {
    Panel strip;
    strip.name = "strip";
    strip.vertices = {{0, 0}, {0.3, 0}, {0.3, 0.01}, {0, 0.01}};
    for (int i = 0; i < 4; ++i) strip.edges.push_back({.start = i, .end = (i + 1) % 4});
    EXPECT_THROW(inset_panel(strip, 0.02), InputError);
}

// ---- Seams of FreeSewing's drafts, against what a tailor sews.

// Edges are those of the panels as imported: "front.1" is the second edge of the front.
struct Draft {
    const char* name;
    std::vector<std::pair<const char*, const char*>> truth;  // pairs of edges that are sewn to each other
};

// The seams were found by hand, from the drafts' instructions. A sleeve's cap is sewn to both armholes; each edge of it
// is listed with each edge of the armhole that it meets over more than 6 mm.
const std::vector<Draft>& drafts() {
    static const std::vector<Draft> all{
        {"teagan",
         {{"front.1", "back.10"},
          {"front.10", "back.1"},
          {"front.4", "back.7"},
          {"front.7", "back.4"},
          {"sleeve.1", "sleeve.7"},
          {"sleeve_mirrored.1", "sleeve_mirrored.7"},
          // The right side of the front is the wearer's left. The single notch of the sleeve is at its front.
          {"front.2", "sleeve_mirrored.6"},
          {"front.3", "sleeve_mirrored.5"},
          {"front.3", "sleeve_mirrored.4"},
          {"back.8", "sleeve_mirrored.4"},
          {"back.8", "sleeve_mirrored.3"},
          {"back.9", "sleeve_mirrored.2"},
          {"back.2", "sleeve.6"},
          {"back.3", "sleeve.5"},
          {"back.3", "sleeve.4"},
          {"front.8", "sleeve.4"},
          {"front.8", "sleeve.3"},
          {"front.9", "sleeve.2"}}},
        {"aaron",
         {{"front.3", "back.6"},
          {"front.6", "back.3"},
          {"front.1", "back.8"},
          {"front.8", "back.1"},
          {"armBinding.1", "armBinding.3"},
          {"armBinding_mirrored.1", "armBinding_mirrored.3"},
          {"neckBinding.1", "neckBinding.3"},
          {"front.7", "armBinding.0"},
          {"back.2", "armBinding.0"},
          {"back.7", "armBinding_mirrored.0"},
          {"front.2", "armBinding_mirrored.0"},
          {"front.0", "neckBinding.0"},
          {"front.9", "neckBinding.0"},
          {"back.0", "neckBinding.0"},
          {"back.9", "neckBinding.0"}}},
        {"sandy",
         {{"skirt.2", "skirt.7"},
          {"waistband.1", "skirt.3"},
          {"waistband.1", "skirt.4"},
          {"waistband.1", "skirt.5"},
          {"waistband.1", "skirt.6"}}}};
    return all;
}

std::string name_of(const Pattern& pattern, const EdgeSpan& span) {
    return pattern.panels[static_cast<std::size_t>(span.panel)].name + "." + std::to_string(span.edge);
}

TEST(SeamProposals, of_freesewings_drafts_are_right_and_complete) {
    const std::filesystem::path folder = real_patterns("freesewing");
    if (folder.empty()) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    double right = 0, accepted = 0, found = 0, all = 0;  // weighed by the length of cloth that is sewn, m
    for (const Draft& draft : drafts()) {
        const auto made = make_panels(read_drawing(folder / (std::string(draft.name) + ".svg")), draft.name);
        std::map<std::pair<std::string, std::string>, bool> truth;
        for (const auto& [a, b] : draft.truth) truth[std::minmax(std::string(a), std::string(b))] = false;
        for (const SeamProposal& proposal : propose_seams(made.pattern, {.hints = made.hints})) {
            if (proposal.confidence < 0.5) continue;
            for (const auto& [a, b] : proposal.parts) {
                const Panel& panel = made.pattern.panels[static_cast<std::size_t>(a.panel)];
                const double length =
                    (a.to - a.from) * outline_length(panel, panel.edges[static_cast<std::size_t>(a.edge)]);
                const auto known = truth.find(std::minmax(name_of(made.pattern, a), name_of(made.pattern, b)));
                accepted += length;
                if (known == truth.end()) continue;
                right += length;
                known->second = true;
            }
        }
        for (const auto& [pair, is_found] : truth) {
            all += 1;
            found += is_found ? 1 : 0;
            if (!is_found) std::printf("%s: missed %s to %s\n", draft.name, pair.first.c_str(), pair.second.c_str());
        }
    }
    EXPECT_GE(right, 0.97 * accepted) << right << " of " << accepted << " m";
    EXPECT_GE(found, 0.9 * all) << found << " of " << all;
}

}  // namespace
}  // namespace selvedge::sim
