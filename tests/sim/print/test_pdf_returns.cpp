// What is printed as PDF is read back: its layers, and the pattern put together from its pages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/paper/drawing_file.h"
#include "sim/paper/make_panels.h"
#include "sim/paper/pdf_pages.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"
#include "sim/print/pdf_canvas.h"
#include "sim/print/pdf_layers.h"
#include "sim/print/print_pdf.h"
#include "tests/sim/print/sample_pattern.h"

namespace selvedge::sim {
namespace {

std::vector<Vec2d> points_of_panel(const Panel& panel) {
    std::vector<Vec2d> points;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> line = outline_polyline(panel, edge, 2e-5);
        points.insert(points.end(), line.begin(), line.end() - 1);
    }
    const Vec2d corner = outline_box(panel).min();
    for (Vec2d& p : points) p -= corner;
    return points;
}

// The farthest that one outline lies from another where their boxes lie on each other, m.
double deviation(const Panel& a, const Panel& b) {
    const std::vector<Vec2d> one = points_of_panel(a), other = points_of_panel(b);
    double most = 0;
    for (const Vec2d& p : one) most = std::max(most, distance_to_outline(p, other));
    for (const Vec2d& p : other) most = std::max(most, distance_to_outline(p, one));
    return most;
}

void expect_same_shirt(const Pattern& original, const PrintOptions& options) {
    const PanelsOfDrawing made =
        make_panels(parse_drawing(print_pdf(original, options).bytes, "shirt.pdf"), "shirt.pdf");
    ASSERT_EQ(made.pattern.panels.size(), original.panels.size());
    for (const Panel& panel : made.pattern.panels) {
        const Panel* best = nullptr;
        for (const Panel& other : original.panels) {
            if (!best || deviation(panel, other) < deviation(panel, *best)) best = &other;
        }
        EXPECT_LT(deviation(panel, *best), 5e-4) << panel.name << " and " << best->name;
        EXPECT_NEAR(outline_area(panel), outline_area(*best), 1e-3 * outline_area(*best)) << panel.name;
    }
}

TEST(PrintedPdf, comes_back_from_its_pages_with_each_edge_within_half_a_millimetre) {
    Pattern shirt = load_pattern(source_folder() + "/patterns/tshirt.json").pattern;
    expect_same_shirt(shirt, {.paper = parse_page_size("a4")});
    for (Panel& panel : shirt.panels) {
        for (OutlineEdge& edge : panel.edges) edge.allowance = 0.01;
    }
    expect_same_shirt(shirt, {.paper = parse_page_size("letter")});
    expect_same_shirt(shirt, {.paper = parse_page_size("a0"), .is_one_page = true});
}

TEST(PrintedPdf, has_a_layer_for_each_kind_of_line_and_page_frames_in_none) {
    const PdfFile pdf =
        read_pdf_file(print_pdf(sample_pattern(), {.paper = parse_page_size("a4")}).bytes, "sample.pdf");
    std::vector<std::string> names;
    for (const PdfLayer& layer : pdf.layers) names.push_back(layer.name);
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"Cutting lines", "Drill points", "Fold lines", "Grain lines",
                                               "Internal lines", "Notches", "Sewing lines", "Texts"}));
    std::size_t without = 0, with = 0;
    for (const PdfShape& shape : pdf.pages.back().shapes) {
        EXPECT_LE(shape.layers.size(), 1U);
        (shape.layers.empty() ? without : with) += 1;
    }
    EXPECT_GT(with, 0U);
    EXPECT_GT(without, 0U) << "frames and marks of the pages";
}

TEST(PrintedPdf, brings_back_what_its_layers_say_of_lines) {
    const Pattern pattern = sample_pattern();
    const Drawing drawing =
        parse_drawing(print_pdf(pattern, {.paper = parse_page_size("a0"), .is_one_page = true}).bytes, "sample.pdf");
    const PanelsOfDrawing made = make_panels(drawing, "sample.pdf");
    const auto cap =
        std::ranges::find_if(made.pattern.panels, [](const Panel& panel) { return panel.name.starts_with("cap"); });
    ASSERT_NE(cap, made.pattern.panels.end());
    EXPECT_EQ(cap->drill_points.size(), pattern.panels[0].drill_points.size());
    EXPECT_NEAR(std::sin(cap->grain_angle - pattern.panels[0].grain_angle), 0, 1e-3);
    const auto folds = std::ranges::count(cap->internal_lines, LineUse::Fold, &InternalLine::use);
    EXPECT_EQ(folds, 1);
}

TEST(PrintedPdf, of_halves_is_unfolded_over_the_line_that_is_drawn_on_the_fold) {
    const Pattern vest = load_pattern(source_folder() + "/patterns/vest.json").pattern;
    const PrintOptions halves{.paper = parse_page_size("a0"), .is_one_page = true, .are_halved = true};
    const PanelsOfDrawing made = make_panels(parse_drawing(print_pdf(vest, halves).bytes, "vest.pdf"), "vest.pdf");
    ASSERT_EQ(made.pattern.panels.size(), vest.panels.size());
    for (const Panel& panel : made.pattern.panels) {
        const auto original = std::ranges::find(vest.panels, panel.name, &Panel::name);
        ASSERT_NE(original, vest.panels.end()) << panel.name;
        EXPECT_LT(deviation(panel, *original), 5e-4) << panel.name;
    }
}

TEST(PdfLayers, of_bytes_that_cairo_did_not_write_leave_them_as_they_are) {
    for (const std::string& bytes :
         {std::string(), std::string("%PDF-1.5\n"), std::string(300, 'x') + "startxref\n9\n"})
        EXPECT_EQ(with_layers(bytes, {"Notes"}, {{0}}), bytes);
    PdfCanvas canvas("none");
    canvas.begin_page({0.2, 0.2});
    canvas.draw_line({{0, 0}, {0.1, 0.1}}, false, {});
    const std::string plain = canvas.finish();
    EXPECT_EQ(plain.find("/OCProperties"), std::string::npos);
}

}  // namespace
}  // namespace selvedge::sim
