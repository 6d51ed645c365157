// DXF as programs write it that draw outlines in pieces, place blocks, hide layers, and grade sizes.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/paper/dxf_drawing.h"
#include "sim/paper/make_panels.h"
#include "sim/pattern/edge_shape.h"
#include "tests/sim/paper/drawings.h"
#include "tests/support/notes.h"

namespace selvedge::sim {
namespace {

std::string at(int code, const Vec2d& p) {
    return dxf_group(code, std::to_string(p.x())) + dxf_group(code + 10, std::to_string(p.y()));
}

std::string stroke_on(const std::string& layer, const Vec2d& a, const Vec2d& b) {
    return dxf_group(0, "LINE") + dxf_group(8, layer) + at(10, a) + at(11, b);
}

std::string chain_on(const std::string& layer, const std::vector<Vec2d>& points, bool is_closed = false) {
    std::string text = dxf_group(0, "POLYLINE") + dxf_group(8, layer) + dxf_group(70, is_closed ? "1" : "0");
    for (const Vec2d& p : points) text += dxf_group(0, "VERTEX") + dxf_group(8, layer) + at(10, p);
    return text + dxf_group(0, "SEQEND");
}

std::string label(const std::string& words, const Vec2d& p = {0, 0}) {
    return dxf_group(0, "TEXT") + dxf_group(8, "1") + at(10, p) + dxf_group(1, words);
}

std::string section(const std::string& name, const std::string& content) {
    return dxf_group(0, "SECTION") + dxf_group(2, name) + content + dxf_group(0, "ENDSEC");
}

std::string block(const std::string& name, const std::string& content) {
    return dxf_group(0, "BLOCK") + dxf_group(8, "0") + dxf_group(2, name) + at(10, {0, 0}) + content +
           dxf_group(0, "ENDBLK");
}

std::string insert(const std::string& name, const std::string& more = "") {
    return dxf_group(0, "INSERT") + dxf_group(8, "1") + dxf_group(2, name) + at(10, {500, 0}) + more;
}

const std::string kMetric = label("Units: METRIC");

std::string file_of(const std::string& blocks, const std::string& entities, const std::string& tables = "") {
    return (tables.empty() ? "" : section("TABLES", tables)) + section("BLOCKS", blocks) +
           section("ENTITIES", entities) + dxf_group(0, "EOF");
}

PanelsOfDrawing dxf_panels(const std::string& content, const MakePanelsOptions& options = {}) {
    return make_panels(read_dxf(content, "a.dxf"), "a.dxf", options);
}

Vec2d size_of_first(const PanelsOfDrawing& made) {
    return outline_box(made.pattern.panels.at(0), 1e-5).sizes();
}

// A trapezoid 520 wide below, 344 above and 560 high, on one layer, each edge in a direction of its own.
std::string in_pieces(const std::string& layer, double inset = 0) {
    const double b = 260 - inset, t = 172 - inset, low = inset, high = 560 - inset;
    return chain_on(layer, {{-b, low}, {b, low}}) + chain_on(layer, {{t, high}, {b, low}}) +
           chain_on(layer, {{t, high}, {0, high - 100}, {-t, high}}) + stroke_on(layer, {-t, high}, {-b, low});
}

TEST(ForeignDxf, joins_outlines_that_are_drawn_in_pieces) {
    const PanelsOfDrawing made = dxf_panels(
        file_of(block("FRONT", in_pieces("1") + in_pieces("14", 10) + chain_on("1", {{-260, 0}, {260, 0}})), kMetric));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    const Panel& panel = made.pattern.panels[0];
    EXPECT_NEAR(size_of_first(made).x(), 0.5, 1e-6);
    EXPECT_NEAR(panel.allowance.value_or(0), 0.01, 1e-3);
    EXPECT_EQ(panel.edges.size(), 5U);  // the upper polyline has a corner of its own
    EXPECT_TRUE(has_note(made.notes, "2 outlines drawn in pieces"));
}

TEST(ForeignDxf, reads_the_other_blocks_where_one_is_open) {
    const std::string open = block("OPEN", chain_on("1", {{0, 0}, {300, 0}, {300, 400}, {0, 400}}));
    const PanelsOfDrawing made = dxf_panels(file_of(open + block("FRONT", in_pieces("1")), kMetric));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_EQ(made.pattern.panels[0].name, "FRONT");
    EXPECT_TRUE(has_note(made.notes, "the outline of 'OPEN' is open by 400 mm, left out"));
    EXPECT_EQ(problem_of(file_of(open, kMetric), [](const std::string& content) { return read_dxf(content, "a.dxf"); }),
              "a.dxf: line 15: the outline of 'OPEN' is open by 400 mm");
}

TEST(ForeignDxf, leads_a_sewing_line_along_the_fold_on_which_it_ends) {
    const std::string half = chain_on("1", {{-10, -10}, {260, -10}, {260, 570}, {-10, 570}, {-10, -10}}, false) +
                             chain_on("14", {{-10, 0}, {250, 0}}) + chain_on("14", {{250, 0}, {250, 560}, {-10, 560}}) +
                             stroke_on("6", {-10, -10}, {-10, 570});
    const PanelsOfDrawing made = dxf_panels(file_of(block("HALF", half), kMetric));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(size_of_first(made).x(), 0.52, 1e-6);  // unfolded
    EXPECT_NEAR(size_of_first(made).y(), 0.56, 1e-6);
}

TEST(ForeignDxf, leads_sewing_lines_that_cross_at_the_corners_from_crossing_to_crossing) {
    for (const double over : {4.0, 10.0, 14.0}) {  // mm beyond the corners; the boundary lies at 10
        const auto far = [&](const Vec2d& a, const Vec2d& b) {
            const Vec2d along = (b - a).normalized() * over;
            return chain_on("14", {a - along, b + along});
        };
        const std::string piece = chain_on("1", {{-10, -10}, {510, -10}, {510, 570}, {-10, 570}, {-10, -10}}) +
                                  far({0, 0}, {500, 0}) + far({500, 560}, {500, 0}) + far({500, 560}, {0, 560}) +
                                  far({0, 0}, {0, 560});
        const PanelsOfDrawing made = dxf_panels(file_of(block("FRONT", piece), kMetric));
        ASSERT_EQ(made.pattern.panels.size(), 1U) << over;
        EXPECT_NEAR(size_of_first(made).x(), 0.5, 1e-6) << over;
        EXPECT_NEAR(size_of_first(made).y(), 0.56, 1e-6) << over;
    }
}

TEST(ForeignDxf, takes_no_block_that_frames_the_page_for_a_piece) {
    const std::string border = chain_on("0", {{-300, -50}, {900, -50}, {900, 700}, {-300, 700}, {-300, -50}}) +
                               chain_on("0", {{700, -50}, {900, -50}, {900, 50}, {700, 50}, {700, -50}});
    const std::string strip = chain_on("1", {{0, 0}, {400, 0}, {400, 60}, {0, 60}, {0, 0}});
    const std::string apart = chain_on("1", {{0, 600}, {400, 600}, {400, 660}, {0, 660}, {0, 600}});
    const auto placed_at_0 = [](const std::string& name) {
        return dxf_group(0, "INSERT") + dxf_group(8, "1") + dxf_group(2, name) + at(10, {0, 0});
    };
    const PanelsOfDrawing made =
        dxf_panels(file_of(block("FRONT", in_pieces("1")) + block("BORDER", border) + block("BAND", apart),
                           kMetric + placed_at_0("FRONT") + placed_at_0("BORDER") + placed_at_0("BAND")));
    ASSERT_EQ(made.pattern.panels.size(), 2U);
    EXPECT_TRUE(has_note(made.notes, "block 'BORDER': a page frame, left out"));
    // Pieces that lie upon each other are none the less pieces.
    const std::string wide =
        block("WIDE", chain_on("1", {{-500, -500}, {900, -500}, {900, 900}, {-500, 900}, {-500, -500}}));
    const PanelsOfDrawing stacked =
        dxf_panels(file_of(block("FRONT", in_pieces("1")) + wide + block("BAND", strip),
                           kMetric + placed_at_0("FRONT") + placed_at_0("WIDE") + placed_at_0("BAND")));
    EXPECT_EQ(stacked.pattern.panels.size(), 3U);
}

TEST(ForeignDxf, reads_names_in_the_code_page_of_its_header) {
    const std::string header = section("HEADER", dxf_group(9, "$DWGCODEPAGE") + dxf_group(3, "ANSI_1251"));
    const std::string piece = block("\xCF\xE5\xF0\xE5\xE4", in_pieces("1"));
    EXPECT_EQ(dxf_panels(header + file_of(piece, kMetric)).pattern.panels.at(0).name, "\u041F\u0435\u0440\u0435\u0434");
    EXPECT_EQ(dxf_panels(file_of(piece, kMetric)).pattern.panels.at(0).name, "\u00CF\u00E5\u00F0\u00E5\u00E4");
}

TEST(ForeignDxf, closes_a_boundary_that_ends_at_the_fold_along_it) {
    const std::string half = chain_on("1", {{0, 0}, {260, 0}, {260, 560}, {0, 560}}) + stroke_on("6", {0, 560}, {0, 0});
    const PanelsOfDrawing made = dxf_panels(file_of(block("HALF", half), kMetric));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(size_of_first(made).x(), 0.52, 1e-6);  // unfolded
}

TEST(ForeignDxf, unfolds_what_is_said_to_be_cut_on_the_fold_beside_its_number) {
    const std::string half = chain_on("1", {{0, 0}, {260, 0}, {172, 560}, {0, 560}, {0, 0}});
    const std::string texts = label("Quantity: 1", {100, 100}) + label("Annotation: CUT 1 ON FOLD", {100, 120});
    const PanelsOfDrawing made = dxf_panels(file_of(block("HALF", half + texts), kMetric));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(size_of_first(made).x(), 0.52, 1e-6);
}

TEST(ForeignDxf, names_a_loose_part_by_the_line_of_its_text_that_is_a_name) {
    const auto words = [](const std::string& text) {
        return dxf_group(0, "MTEXT") + dxf_group(8, "0") + at(10, {200, 100}) + dxf_group(1, text);
    };
    const std::string part = chain_on("0", {{0, 0}, {400, 0}, {400, 500}, {0, 500}, {0, 0}});
    const PanelsOfDrawing made = dxf_panels(file_of("", part + words("{\\fArial|b1|i0;\\C1;Apron}\\PCut 1")));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_EQ(made.pattern.panels[0].name, "Apron");
}

TEST(ForeignDxf, makes_pieces_of_loose_lines_arcs_and_splines) {
    const auto fit = [](const std::vector<Vec2d>& points) {
        std::string all = dxf_group(0, "SPLINE") + dxf_group(8, "0") + dxf_group(70, "8") + dxf_group(71, "3") +
                          dxf_group(74, std::to_string(points.size()));
        for (const Vec2d& p : points) all += at(11, p);
        return all;
    };
    // A half circle of 400 above, a wave below: a parabola of fit points through (0, 0), (200, -50), (400, 0).
    const std::string arc = dxf_group(0, "ARC") + dxf_group(8, "0") + at(10, {200, 300}) + dxf_group(40, "200") +
                            dxf_group(50, "0") + dxf_group(51, "180");
    const std::string loose = arc + stroke_on("0", {0, 300}, {0, 0}) + stroke_on("0", {400, 0}, {400, 300}) +
                              fit({{0, 0}, {100, -37.5}, {200, -50}, {300, -37.5}, {400, 0}}) +
                              label("Apron", {200, 100});
    const PanelsOfDrawing made = dxf_panels(file_of("", loose));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_EQ(made.pattern.panels[0].name, "Apron");
    EXPECT_NEAR(size_of_first(made).x(), 0.4, 5e-4);
    EXPECT_NEAR(size_of_first(made).y(), 0.55, 5e-4);
}

TEST(ForeignDxf, divides_loose_pieces_that_share_an_edge) {
    const std::string loose = stroke_on("0", {0, 0}, {300, 0}) + stroke_on("0", {300, 0}, {300, 500}) +
                              stroke_on("0", {300, 500}, {0, 500}) + stroke_on("0", {0, 500}, {0, 0}) +
                              stroke_on("0", {300, 0}, {620, 0}) + stroke_on("0", {620, 0}, {620, 500}) +
                              stroke_on("0", {620, 500}, {300, 500});
    const PanelsOfDrawing made = dxf_panels(file_of("", loose));
    EXPECT_EQ(made.pattern.panels.size(), 2U);
}

TEST(ForeignDxf, places_blocks_as_the_drawing_does) {
    const std::string front = block("FRONT", in_pieces("1"));
    EXPECT_NEAR(size_of_first(dxf_panels(file_of(front, kMetric + insert("FRONT")))).x(), 0.52, 1e-6);
    const PanelsOfDrawing large =
        dxf_panels(file_of(front, kMetric + insert("FRONT", dxf_group(41, "2") + dxf_group(42, "2"))));
    EXPECT_NEAR(size_of_first(large).x(), 1.04, 1e-6);
    EXPECT_TRUE(has_note(large.notes, "a scale of their own (1): applied"));
    const Drawing turned = read_dxf(file_of(front, kMetric + insert("FRONT", dxf_group(50, "90"))), "");
    Eigen::AlignedBox2d box;
    for (const Vec2d& v : turned.parts.at(0).paths.at(0).vertices) box.extend(v);
    EXPECT_NEAR(box.sizes().x(), 560, 1e-6);
    // As drawn and mirrored: two pieces. Twice as drawn: one.
    const std::string mirrored = insert("FRONT") + insert("FRONT", dxf_group(41, "-1"));
    EXPECT_EQ(read_dxf(file_of(front, kMetric + mirrored), "").parts.size(), 2U);
    EXPECT_EQ(read_dxf(file_of(front, kMetric + insert("FRONT") + insert("FRONT")), "").parts.size(), 1U);
    // A layout of blocks; one that is drawn within another; one that is not placed at all.
    const std::string layout = block("LAYOUT", insert("FRONT")) + front + block("TITLE", in_pieces("1"));
    const Drawing laid = read_dxf(file_of(layout, kMetric + insert("LAYOUT")), "");
    ASSERT_EQ(laid.parts.size(), 1U);
    EXPECT_EQ(laid.parts[0].name, "FRONT");
    EXPECT_TRUE(has_note(laid.notes, "block 'TITLE' is not placed in the drawing, left out"));
    EXPECT_FALSE(has_note(laid.notes, "'LAYOUT'"));
    EXPECT_THROW(read_dxf(file_of(block("A", insert("B")) + block("B", insert("A")), insert("A")), ""), InputError);
}

TEST(ForeignDxf, leaves_out_what_is_hidden) {
    const auto layer = [](const std::string& name, const std::string& flags, const std::string& colour) {
        return dxf_group(0, "LAYER") + dxf_group(2, name) + dxf_group(70, flags) + dxf_group(62, colour);
    };
    const std::string tables = layer("OLD", "1", "7") + layer("OFF", "0", "-7") + layer("0", "0", "7");
    const std::string shown = chain_on("0", {{0, 0}, {300, 0}, {320, 500}, {0, 500}}, true);
    const std::string hidden = chain_on("OLD", {{400, 0}, {700, 0}, {700, 600}, {400, 500}}, true) +
                               chain_on("OFF", {{800, 0}, {900, 0}, {950, 600}, {800, 500}}, true);
    const PanelsOfDrawing made = dxf_panels(file_of("", hidden + shown, tables));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(size_of_first(made).x(), 0.32, 1e-6);
    EXPECT_TRUE(has_note(made.notes, "2 hidden elements left out"));
    const std::string problem =
        problem_of(file_of("", hidden, tables), [](const std::string& content) { return read_dxf(content, "a.dxf"); });
    EXPECT_NE(problem.find("2 elements are hidden"), std::string::npos) << problem;
}

TEST(ForeignDxf, takes_metric_for_centimetres_where_millimetres_fit_nobody) {
    const auto small = [](double scale) {
        return chain_on("1", {{0, 0}, {50 * scale, 0}, {50 * scale, 66 * scale}, {0, 66 * scale}}, true);
    };
    const PanelsOfDrawing made = dxf_panels(file_of(block("FRONT", small(1)), kMetric));
    EXPECT_NEAR(size_of_first(made).x(), 0.5, 1e-6);
    EXPECT_TRUE(has_note(made.notes, "taken as cm"));
    EXPECT_NEAR(size_of_first(dxf_panels(file_of(block("FRONT", small(10)), kMetric))).x(), 0.5, 1e-6);
}

TEST(ForeignDxf, takes_the_sample_size_of_several) {
    const auto piece = [](const std::string& size, double width, const std::string& more = "") {
        return block("FRONT_" + size, label("Piece Name: FRONT") + label("Size Name: " + size) + more +
                                          chain_on("1", {{0, 0}, {width, 0}, {width, 500}, {0, 500}}, true));
    };
    const std::string three = piece("S", 400) + piece("M", 420) + piece("L", 440);
    const PanelsOfDrawing named = dxf_panels(file_of(three, kMetric + label("Sample Size: L")));
    EXPECT_EQ(named.sizes, (std::vector<std::string>{"S", "M", "L"}));
    EXPECT_NEAR(size_of_first(named).x(), 0.44, 1e-6);
    EXPECT_NEAR(size_of_first(dxf_panels(file_of(three, kMetric))).x(), 0.42, 1e-6);
    EXPECT_NEAR(size_of_first(dxf_panels(file_of(three, kMetric), {.size = "S"})).x(), 0.4, 1e-6);
    // Without its name: how often a piece is cut stands beside the sample size only.
    const std::string told = piece("S", 400, label("Quantity: 1")) + piece("M", 420) + piece("L", 440);
    EXPECT_NEAR(size_of_first(dxf_panels(file_of(told, kMetric))).x(), 0.4, 1e-6);
}

TEST(ForeignDxf, names_a_piece_by_its_category_where_its_name_says_nothing) {
    const std::string piece = block("X12", label("Piece Name: X12") + label("CATEGORY: BACK") + in_pieces("1"));
    EXPECT_EQ(dxf_panels(file_of(piece, kMetric)).pattern.panels.at(0).name, "X12 BACK");
}

TEST(ForeignDxf, keeps_straight_edges_that_run_smoothly_into_curves) {
    // A pocket of 200 x 200 with corners of radius 20, each a quarter of a circle of six chords.
    std::vector<Vec2d> pocket;
    const std::array<Vec2d, 4> middles{Vec2d(180, 20), Vec2d(180, 180), Vec2d(20, 180), Vec2d(20, 20)};
    for (std::size_t c = 0; c < middles.size(); ++c) {
        for (int i = 0; i <= 6; ++i) {
            const double angle = (-90 + 90 * static_cast<double>(c) + 15 * i) * kDegree;
            pocket.push_back(middles[c] + 20 * Vec2d(std::cos(angle), std::sin(angle)));
        }
    }
    const Vec2d size = size_of_first(dxf_panels(file_of(block("POCKET", chain_on("1", pocket, true)), kMetric)));
    EXPECT_NEAR(size.x(), 0.2, 1e-4);
    EXPECT_NEAR(size.y(), 0.2, 1e-4);
    // A side that is straight from the hem to the hip, and curved from there to the waist.
    std::vector<Vec2d> skirt{{0, 0}, {240, 0}, {240, 400}};
    for (int i = 1; i <= 12; ++i)
        skirt.emplace_back(240 - 40 * (1 - std::cos(i * kDegree * 7.5)), 400 + 200 * std::sin(i * kDegree * 7.5));
    skirt.emplace_back(0, 600);
    EXPECT_NEAR(size_of_first(dxf_panels(file_of(block("SIDE", chain_on("1", skirt, true)), kMetric))).x(), 0.24, 1e-4);
}

TEST(ForeignDxf, joins_lines_that_are_shorter_than_the_gap) {
    std::string loose;
    constexpr int kCount = 1500;  // of 1 mm and less, round a circle of 200 mm
    const auto at_angle = [](int i) {
        const double angle = 360.0 * i / kCount * kDegree;
        return Vec2d(200 * std::cos(angle), 200 * std::sin(angle));
    };
    for (int i = 0; i < kCount; ++i) loose += stroke_on("0", at_angle(i), at_angle((i + 1) % kCount));
    const PanelsOfDrawing made = dxf_panels(file_of("", kMetric + loose));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(size_of_first(made).x(), 0.4, 1e-4);
}

TEST(ForeignDxf, refuses_a_file_that_was_cut_off) {
    const std::string whole = file_of(block("FRONT", in_pieces("1")), kMetric);
    const std::string part = whole.substr(0, whole.find("ENTITIES") + 9);
    EXPECT_NE(problem_of(part, [](const std::string& content) { return read_dxf(content, "a.dxf"); })
                  .find("the file ends within its section ENTITIES: it was cut off"),
              std::string::npos);
}

TEST(ForeignDxf, sees_flat_objects_from_below_and_no_sheets) {
    const std::string below = dxf_group(230, "-1");
    const auto square = [](const std::string& more) {
        std::string text =
            dxf_group(0, "LWPOLYLINE") + dxf_group(8, "0") + dxf_group(90, "4") + dxf_group(70, "1") + more;
        for (const Vec2d& p : {Vec2d(0, 0), Vec2d(300, 0), Vec2d(300, 500), Vec2d(0, 400)}) text += at(10, p);
        return text;
    };
    // Beside each other, not upon each other, once the flat one is turned over.
    const std::string drawing = square("") + square(below) + square(dxf_group(67, "1"));
    EXPECT_EQ(read_dxf(file_of("", kMetric + drawing), "").parts.size(), 2U);
    const std::string lines = stroke_on("0", {0, 0}, {300, 0}) + below + stroke_on("0", {300, 0}, {300, 400}) +
                              stroke_on("0", {300, 400}, {0, 0});
    EXPECT_EQ(read_dxf(file_of("", kMetric + lines), "").parts.size(), 1U);
}

TEST(ForeignDxf, reads_damaged_files_or_refuses_them) {
    const std::string whole =
        file_of(block("FRONT", in_pieces("1") + in_pieces("14", 10) + label("Size: M")) + block("A", insert("FRONT")),
                kMetric + insert("A", dxf_group(41, "2")) + stroke_on("0", {900, 0}, {990, 0}) +
                    stroke_on("0", {990, 0}, {900, 90}) + stroke_on("0", {900, 90}, {900, 0}),
                dxf_group(0, "LAYER") + dxf_group(2, "OLD") + dxf_group(70, "1"));
    const int refused = read_mutants(whole, 3000, [](const std::string& mutant) { return read_dxf(mutant, "m"); });
    EXPECT_GT(refused, 100);
    EXPECT_LT(refused, 2900);
}

}  // namespace
}  // namespace selvedge::sim
