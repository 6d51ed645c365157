// Patterns as PDF: pages put together, scale, layers, texts; what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/paper/curve_pieces.h"
#include "sim/paper/drawing_file.h"
#include "sim/paper/make_panels.h"
#include "sim/paper/page_labels.h"
#include "sim/paper/pdf_drawing.h"
#include "sim/paper/pdf_pictures.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "tests/sim/paper/drawings.h"
#include "tests/sim/paper/pdf_text.h"
#include "tests/support/notes.h"

namespace selvedge::sim {
namespace {

Drawing read_text(const std::string& bytes) {
    return parse_drawing(bytes, "pattern.pdf");
}

// A front with slanted sides and a round neck: 460 x 620 mm.
std::vector<Vec2d> front_at(const Vec2d& corner) {
    std::vector<Vec2d> points{{20, 0}, {440, 0}, {460, 380}, {400, 590}, {320, 620}};
    for (int i = 1; i < 20; ++i) {
        const double angle = -M_PI * i / 20;
        points.emplace_back(230 + 90 * std::cos(angle), 620 + 80 * std::sin(angle));
    }
    points.emplace_back(140, 620);
    points.emplace_back(60, 590);
    points.emplace_back(0, 380);
    for (Vec2d& p : points) p += corner;
    return points;
}

double area_of_polygon(const std::vector<Vec2d>& points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) twice += cross2(points[i], points[(i + 1) % points.size()]);
    return std::abs(twice) / 2;
}

// Fronts come back with their area, within a thousandth, and their size, within 0.5 mm, and nothing else.
void expect_fronts(const std::string& bytes, std::size_t count) {
    const PanelsOfDrawing made = make_panels(read_text(bytes), "pattern.pdf");
    std::string notes;
    for (const std::string& note : made.notes) notes += note + "\n";
    ASSERT_EQ(made.pattern.panels.size(), count) << notes;
    for (const Panel& panel : made.pattern.panels) {
        const double area = area_of_polygon(front_at({0, 0})) * 1e-6;
        EXPECT_NEAR(outline_area(panel), area, 1e-3 * area);
        const Vec2d size = outline_box(panel).sizes();
        EXPECT_NEAR(std::min(size.x(), size.y()), 0.460, 5e-4);
        EXPECT_NEAR(std::max(size.x(), size.y()), 0.620, 5e-4);
        EXPECT_TRUE(panel.internal_lines.empty()) << "a mark or a frame is a line of it";
    }
}

std::vector<std::vector<Vec2d>> two_fronts() {
    return {front_at({30, 40}), front_at({520, 65})};
}

// ---- Pages.

TEST(PdfDrawing, has_outlines_at_true_size_with_their_curves) {
    const Drawing drawing =
        read_text(pdf_of(pdf_number(30) + pdf_number(50) + "m " + pdf_number(180) + pdf_number(50) + "l " +
                         pdf_number(180) + pdf_number(200) + pdf_number(90) + pdf_number(250) + pdf_number(30) +
                         pdf_number(250) + "c s\n" + pdf_words(80, 100, "Sleeve")));
    ASSERT_EQ(drawing.parts.size(), 1U);
    EXPECT_EQ(drawing.parts[0].name, "Sleeve");
    ASSERT_EQ(drawing.parts[0].paths.size(), 1U);
    const DrawnPath& path = drawing.parts[0].paths[0];
    ASSERT_EQ(path.edges.size(), 3U);
    EXPECT_EQ(path.edges[1].kind, CurveKind::Cubic);
    EXPECT_NEAR((path.vertices[1] - path.vertices[0]).norm() * *drawing.metres_per_unit, 0.150, 1e-6);
}

TEST(PdfDrawing, counts_the_user_unit_of_a_plotters_page) {
    const PdfTextFile file{
        .pages = {
            {.content = pdf_line({{5, 5}, {50, 5}, {40, 80}, {8, 80}}), .size = {60, 90}, .entries = "/UserUnit 10"}}};
    const Drawing drawing = read_text(file.bytes());
    ASSERT_EQ(drawing.parts.size(), 1U);
    const DrawnPath& path = drawing.parts[0].paths[0];
    EXPECT_NEAR((path.vertices[1] - path.vertices[0]).norm() * *drawing.metres_per_unit, 0.450, 1e-6);
}

TEST(PdfTiles, are_put_together_by_the_outlines_that_they_share) {
    expect_fronts(tiled(two_fronts(), {}).bytes(), 2);
    expect_fronts(tiled(two_fronts(), {.margin = 0, .has_frame = false, .has_crosses = false}).bytes(), 2);
    expect_fronts(tiled(two_fronts(), {.page = {297, 210}, .margin = 8, .overlap = 15}).bytes(), 2);
}

TEST(PdfTiles, that_end_at_their_frames_are_joined_across_them) {
    expect_fronts(tiled(two_fronts(), {.is_cut = true}).bytes(), 2);
    expect_fronts(
        tiled(two_fronts(), {.page = {210, 297}, .margin = 10, .is_cut = true, .is_by_columns = true}).bytes(), 2);
}

TEST(PdfTiles, that_end_at_borders_without_a_frame_are_joined_where_their_lines_end) {
    expect_fronts(tiled(two_fronts(), {.is_cut = true, .has_frame = false, .has_crosses = false}).bytes(), 2);
}

TEST(PdfTiles, that_share_a_strip_with_their_neighbours_are_laid_over_each_other) {
    const auto label = [](int column, int row) {
        return std::string(1, static_cast<char>('A' + row)) + std::to_string(column + 1);
    };
    expect_fronts(tiled(two_fronts(), {.overlap = 15, .is_cut = true, .label = label}).bytes(), 2);
    expect_fronts(tiled(two_fronts(), {.overlap = 7.5, .is_cut = true, .is_by_columns = true}).bytes(), 2);
}

TEST(PdfTiles, with_half_marks_at_their_frames_are_laid_by_their_lines_not_by_the_marks) {
    const auto triangles = [](int, int) {
        return pdf_line({{9, 142}, {15, 148}, {9, 154}}) + pdf_line({{201, 142}, {195, 148}, {201, 154}});
    };
    expect_fronts(tiled(two_fronts(), {.page = {210, 297},
                                       .margin = 9,
                                       .overlap = 12,
                                       .is_cut = true,
                                       .has_crosses = false,
                                       .contents = triangles})
                      .bytes(),
                  2);
}

TEST(PdfTiles, lie_where_their_labels_say_whatever_their_order_and_with_pages_left_out) {
    const auto label = [](int column, int row) {
        return "Row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1);
    };
    PdfTextFile file = tiled({front_at({400, 520})}, {.is_cut = true, .label = label});
    const std::size_t all = file.pages.size();
    const auto count_lines = [](const std::string& content) {
        std::size_t count = 0;
        for (std::size_t at = content.find(" l "); at != std::string::npos; at = content.find(" l ", at + 1)) ++count;
        return count;
    };
    constexpr std::size_t kOfCrosses = 8;
    std::erase_if(file.pages, [&](const PdfTextPage& page) { return count_lines(page.content) <= kOfCrosses; });
    EXPECT_LT(file.pages.size(), all);
    std::ranges::reverse(file.pages);
    expect_fronts(file.bytes(), 1);
}

TEST(PdfTiles, keep_a_hem_that_runs_level_across_two_pages) {
    const std::vector<Vec2d> wide{{20, 40}, {740, 40}, {600, 300}, {60, 330}};
    const PanelsOfDrawing made = make_panels(read_text(tiled({wide}, {.is_cut = true}).bytes()), "pattern.pdf");
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_area(made.pattern.panels[0]), area_of_polygon(wide) * 1e-6, 1e-5);
}

TEST(PdfTiles, whose_covers_show_the_pieces_small_have_no_small_pieces) {
    PdfTextFile file = tiled(two_fronts(), {});
    std::string cover = pdf_rectangle(30, 30, 50.8, 50.8) + pdf_words(45, 55, "2 in");
    for (std::vector<Vec2d> points : two_fronts()) {
        for (Vec2d& p : points) p = p / 10 + Vec2d(40, 120);
        cover += pdf_line(points);
    }
    file.pages.insert(file.pages.begin(), {.content = cover, .size = {215.9, 279.4}});
    const Drawing drawing = read_text(file.bytes());
    EXPECT_EQ(drawing.parts.size(), 2U);
    EXPECT_TRUE(has_note(drawing.notes, "page 1: a cover or instructions, left out"));
    EXPECT_TRUE(has_note(drawing.notes, "the scale is proved by the test square"));
}

TEST(PdfTiles, that_fit_in_no_grid_are_told) {
    PdfTextFile file;
    for (const double x : {40.0, 90.0, 150.0})
        file.pages.push_back({.content = pdf_line({{0, x}, {100, x + 30}, {120, 297}}, false)});
    EXPECT_NE(problem_of(file.bytes(), read_text).find("Its pages could not be put together"), std::string::npos)
        << problem_of(file.bytes(), read_text);
}

// ---- Scale.

TEST(PdfScale, is_that_of_a_labelled_test_square) {
    const struct {
        double side;
        const char* label;
    } squares[] = {{25.4, "1 inch"}, {50.8, "2in / 5.08cm"}, {20, "2 cm"}, {50, "Test square 5 cm"}, {100, "10 cm"}};
    for (const auto& [side, label] : squares) {
        SCOPED_TRACE(label);
        const double printed = 0.96 * side;
        const Drawing drawing =
            read_text(pdf_of(pdf_line({{20, 140}, {190, 150}, {170, 280}, {30, 270}}) +
                             pdf_rectangle(20, 20, printed, printed) + pdf_words(21, 20 + printed / 2, label, 6)));
        ASSERT_EQ(drawing.parts.size(), 1U);
        EXPECT_NEAR(*drawing.metres_per_unit, 0.001 / 0.96, 1e-6);
        EXPECT_TRUE(has_note(drawing.notes, "the scale is that of the test square, not of the pages"));
    }
}

TEST(PdfScale, without_a_test_square_is_told) {
    const Drawing drawing = read_text(pdf_of(pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}})));
    EXPECT_DOUBLE_EQ(*drawing.metres_per_unit, 0.001);
    EXPECT_TRUE(has_note(drawing.notes, "no test square"));
}

// ---- Layers.

// Three sizes of a skirt panel, each in a layer.
PdfTextFile layered(const std::string& off = "") {
    PdfTextFile file;
    file.objects = {"<< /Type /OCG /Name (Size S) >>", "<< /Type /OCG /Name (Size M) >>",
                    "<< /Type /OCG /Name (Notes) >>"};
    file.catalog = "/OCProperties << /OCGs [4 0 R 5 0 R 6 0 R] /D << /OFF [" + off + "] >> >>";
    const std::string content = "/OC /S BDC " + pdf_line({{20, 20}, {150, 20}, {130, 250}, {40, 250}}) +
                                "EMC /OC /M BDC " + pdf_line({{10, 15}, {170, 15}, {145, 260}, {30, 260}}) +
                                "EMC /OC /N BDC " + pdf_line({{60, 100}, {90, 100}, {90, 160}, {60, 160}}) + "EMC\n";
    file.pages = {{.content = content, .resources = "/Properties << /S 4 0 R /M 5 0 R /N 6 0 R >>"}};
    return file;
}

TEST(PdfLayers, that_are_sizes_are_taken_one_by_one) {
    const Drawing drawing = read_text(layered().bytes());
    const PanelsOfDrawing small = make_panels(drawing, "pattern.pdf", {.size = "S"});
    EXPECT_EQ(small.sizes, (std::vector<std::string>{"S", "M"}));
    ASSERT_EQ(small.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_box(small.pattern.panels[0]).sizes().x(), 0.130, 1e-4);
    const PanelsOfDrawing middle = make_panels(drawing, "pattern.pdf", {.size = "M"});
    EXPECT_NEAR(outline_box(middle.pattern.panels[0]).sizes().x(), 0.160, 1e-4);
}

TEST(PdfLayers, that_are_off_are_left_out_and_told_but_sizes_can_be_chosen) {
    const Drawing drawing = read_text(layered("4 0 R 6 0 R").bytes());
    EXPECT_TRUE(has_note(drawing.notes, "1 layer that the file hides, left out: Notes"));
    const PanelsOfDrawing shown = make_panels(drawing, "pattern.pdf");
    ASSERT_EQ(shown.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_box(shown.pattern.panels[0]).sizes().x(), 0.160, 1e-4) << "the size that is on";
    EXPECT_TRUE(shown.pattern.panels[0].internal_lines.empty());
    const PanelsOfDrawing small = make_panels(drawing, "pattern.pdf", {.size = "S"});
    EXPECT_NEAR(outline_box(small.pattern.panels[0]).sizes().x(), 0.130, 1e-4);
}

TEST(PdfDrawing, names_a_pair_without_the_side_of_the_one_that_is_drawn) {
    const PanelsOfDrawing made = make_panels(
        read_text(pdf_of(pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}}) + pdf_words(80, 150, "left_sleeve") +
                         pdf_words(80, 140, "cut 2 \\(1 pair, mirrored\\)"))),
        "pattern.pdf");
    ASSERT_EQ(made.pattern.panels.size(), 2U);
    EXPECT_EQ(made.pattern.panels[0].name, "sleeve");
    EXPECT_EQ(made.pattern.panels[1].name, "sleeve_mirrored");
    EXPECT_EQ(made.pattern.panels[1].mirror_of, "sleeve");
}

// ---- Pages to be traced.

// White with a black rectangle from the fifth to the 16th of 20 columns and the third to the 24th of 28 rows.
PdfTextFile file_with_scan() {
    std::string pixels(std::size_t{20} * 28, '\xFF');
    for (std::size_t y = 2; y < 24; ++y)
        std::fill_n(pixels.begin() + static_cast<std::ptrdiff_t>(20 * y + 4), 12, '\0');
    return {.pages = {},
            .objects = {"<< /Type /XObject /Subtype /Image /Width 20 /Height 28 /ColorSpace /DeviceGray "
                        "/BitsPerComponent 8 /Length 560 >>\nstream\n" +
                        pixels + "\nendstream"}};
}

// A page of A4 with that picture, of 200 x 280 mm, 5 mm from its lower left corner: the rectangle is 120 x 220 mm.
PdfTextPage scan_page(const std::string& more = "", double width = 200) {
    return {.content = "q " + pdf_number(width) + "0 0 " + pdf_number(280) + pdf_number(5) + pdf_number(5) +
                       "cm /I Do Q\n" + more,
            .resources = "/XObject << /I 4 0 R >>"};
}

const char* const kOutline = "56.7 113.4 m 538.6 141.7 l 481.9 793.7 l 85 765.4 l s\n";

// Of what is dark in a picture, m, from its upper left corner.
Eigen::AlignedBox2d dark_box(const DrawnPicture& picture) {
    Eigen::AlignedBox2d box;
    for (int y = 0; y < picture.height_px; ++y) {
        for (int x = 0; x < picture.width_px; ++x) {
            if (picture.rgb[3 * static_cast<std::size_t>(y * picture.width_px + x)] >= 128) continue;
            box.extend(picture.pixel_size * Vec2d(x, y)).extend(picture.pixel_size * Vec2d(x + 1, y + 1));
        }
    }
    return box;
}

void expect_dark(const DrawnPicture& picture, const Vec2d& from, const Vec2d& to) {
    const Eigen::AlignedBox2d box = dark_box(picture);
    EXPECT_LT((1000 * box.min() - from).cwiseAbs().maxCoeff(), 0.5) << 1000 * box.min().transpose();
    EXPECT_LT((1000 * box.max() - to).cwiseAbs().maxCoeff(), 0.5) << 1000 * box.max().transpose();
}

std::vector<std::size_t> numbers_of_pictures(const Drawing& drawing) {
    std::vector<std::size_t> numbers;
    for (const DrawnPicture& picture : drawing.pictures) numbers.push_back(picture.number);
    return numbers;
}

TEST(PdfScans, alone_come_as_pictures_of_true_size_and_make_no_panel) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page(), scan_page()};
    const Drawing drawing = read_text(file.bytes());
    EXPECT_TRUE(drawing.parts.empty());
    ASSERT_EQ(drawing.pictures.size(), 2U);
    EXPECT_LT((drawing.pictures[1].size - Vec2d(0.210, 0.297)).norm(), 1e-6);
    expect_dark(drawing.pictures[1], {45, 32}, {165, 252});
    EXPECT_TRUE(has_note(drawing.notes, "pages 1 and 2: only a scan, 21.0 x 29.7 cm"));
    const PanelsOfDrawing made = make_panels(drawing, "pattern.pdf");
    EXPECT_TRUE(made.pattern.panels.empty());
    EXPECT_EQ(made.notes, drawing.notes);
}

TEST(PdfScans, on_turned_pages_and_in_a_unit_of_their_own_have_true_size) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page()};
    file.pages[0].entries = "/Rotate 90 /UserUnit 2";
    const Drawing drawing = read_text(file.bytes());
    ASSERT_EQ(drawing.pictures.size(), 1U);
    EXPECT_LT((drawing.pictures[0].size - Vec2d(0.594, 0.420)).norm(), 1e-6);
    expect_dark(drawing.pictures[0], {90, 90}, {530, 330});
}

TEST(PdfScans, beside_lines_are_pictures_and_photos_on_covers_are_left_out) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page(), scan_page("", 80), {.content = kOutline}};
    const Drawing drawing = read_text(file.bytes());
    EXPECT_EQ(drawing.parts.size(), 1U);
    EXPECT_EQ(numbers_of_pictures(drawing), std::vector<std::size_t>{1});
    EXPECT_TRUE(has_note(drawing.notes, "page 1: only a scan"));
    EXPECT_TRUE(has_note(drawing.notes, "page 2: a picture on a cover or among instructions, left out"));
    EXPECT_EQ(make_panels(drawing, "pattern.pdf").pattern.panels.size(), 1U);
}

TEST(PdfScans, within_frames_and_beside_pages_of_other_lines_are_pictures) {
    PdfTextFile file = file_with_scan();
    const std::string sides = pdf_line({{10, 10}, {200, 10}}, false) + pdf_line({{10, 10}, {10, 287}}, false);
    file.pages = {scan_page(sides),
                  scan_page(pdf_rectangle(5, 5, 200, 287)),
                  {.content = pdf_rectangle(10, 10, 190, 277)},
                  {.content = pdf_rectangle(10, 10, 190, 277)}};
    const Drawing drawing = read_text(file.bytes());
    EXPECT_EQ(numbers_of_pictures(drawing), (std::vector<std::size_t>{1, 2}));
    EXPECT_TRUE(has_note(drawing.notes, "beside its scans: ")) << testing::PrintToString(drawing.notes);
}

TEST(PdfScans, beside_an_outline_that_cannot_be_read_do_not_hide_its_fault) {
    PdfTextFile file = file_with_scan();
    const PdfTextPage open{.content = pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}}, false)};
    for (const double width : {80, 200}) {  // of a photo on a cover, and a scan
        file.pages = {scan_page("", width), open};
        EXPECT_EQ(problem_of(file.bytes(), read_text),
                  "pattern.pdf: page 2, path 1: open by 230 mm, and no other line is closed: nothing that could be a "
                  "panel");
    }
}

TEST(PdfScans, have_the_scale_of_the_test_square_beside_them) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page(),
                  {.content = pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}}) + pdf_rectangle(60, 100, 45, 45) +
                              pdf_words(65, 120, "test square 5 x 5 cm")}};
    const Drawing drawing = read_text(file.bytes());
    EXPECT_NEAR(*drawing.metres_per_unit, 0.001 * 50 / 45, 1e-6);
    ASSERT_EQ(drawing.pictures.size(), 1U);
    EXPECT_LT((drawing.pictures[0].size - Vec2d(0.210, 0.297) * 50 / 45).norm(), 1e-5);
    expect_dark(drawing.pictures[0], Vec2d(45, 32) * 50 / 45, Vec2d(165, 252) * 50 / 45);
    EXPECT_TRUE(has_note(drawing.notes, "page 1: only a scan, 23.3 x 33.0 cm"));
}

TEST(PdfScans, that_cannot_be_drawn_are_left_out_beside_panels_and_refused_alone) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page(), {.content = kOutline}};
    const auto fail = [](std::vector<DrawnPicture>&) { throw InputError("pattern.pdf", "", "it takes too long"); };
    const Drawing drawing = drawing_of_pdf(read_pdf_file(file.bytes(), "pattern.pdf"), "pattern.pdf", fail);
    EXPECT_EQ(drawing.parts.size(), 1U);
    EXPECT_TRUE(drawing.pictures.empty());
    EXPECT_TRUE(has_note(drawing.notes, "page 1: only a scan, left out: it takes too long"));
    EXPECT_FALSE(has_note(drawing.notes, "under the sheet"));
    file.pages.pop_back();
    EXPECT_THROW(drawing_of_pdf(read_pdf_file(file.bytes(), "pattern.pdf"), "pattern.pdf", fail), InputError);
}

TEST(PdfScans, with_a_large_line_on_them_are_read_as_lines) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page(kOutline)};
    const Drawing drawing = read_text(file.bytes());
    EXPECT_EQ(drawing.parts.size(), 1U);
    EXPECT_TRUE(drawing.pictures.empty());
}

TEST(PdfScans, of_more_pages_than_underlays_are_cut_off_and_told) {
    PdfFile pdf;
    pdf.pages.resize(70, {.size = {10, 10}, .pictures = {{0, 0}, {10, 10}}});
    const Drawing drawing = drawing_of_pdf(pdf, "pattern.pdf");
    EXPECT_EQ(drawing.pictures.size(), kMostUnderlays);
    EXPECT_TRUE(has_note(drawing.notes, "pages 65 to 70: left out: at most 64 scans"));
}

TEST(PdfPictures, of_large_or_many_pages_have_larger_pixels_and_true_size) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page(), scan_page()};
    std::vector<DrawnPicture> pages{{.number = 1, .size = {0.210, 0.297}}, {.number = 2, .size = {0.210, 0.297}}};
    draw_pages(file.bytes(), "pattern.pdf", pages, {.pixels = 3e6});
    std::size_t pixels = 0;
    for (const DrawnPicture& page : pages) pixels += page.rgb.size() / 3;
    EXPECT_NEAR(static_cast<double>(pixels), 3e6, 1e4);
    expect_dark(pages[1], {45, 32}, {165, 252});
    draw_pages(file.bytes(), "pattern.pdf", pages, {.side_px = 600});
    EXPECT_LE(pages[0].height_px, 600);
    expect_dark(pages[0], {45, 32}, {165, 252});
}

TEST(PdfPictures, damaged_anywhere_give_pictures_or_one_line) {
    PdfTextFile file = file_with_scan();
    file.pages = {scan_page("BT /F1 20 Tf 90 90 Td (SKIRT) Tj ET\n")};
    EXPECT_GT(read_mutants(file.bytes(), 60, read_text), 5);
}

// ---- What is refused.

TEST(PdfDrawing, that_cannot_be_read_is_refused_on_one_line_that_says_why) {
    const std::string sound = pdf_of(pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}}));
    EXPECT_EQ(problem_of("%PDF-1.4\n", read_text), "pattern.pdf: a broken PDF: its structure cannot be read");
    EXPECT_EQ(problem_of(PdfTextFile{}.bytes(), read_text), "pattern.pdf: it has no pages");
    EXPECT_EQ(problem_of(pdf_of(""), read_text), "pattern.pdf: no line on its page: no pattern");
    EXPECT_EQ(problem_of(pdf_of(pdf_words(50, 50, "A letter")), read_text),
              "pattern.pdf: no line on its page: no pattern");
    PdfTextFile locked{.pages = {{.content = "0 0 m 9 9 l S"}}};
    locked.objects = {"<< /Filter /Standard /V 1 /R 2 /P -4 /O <" + std::string(64, '5') + "> /U <" +
                      std::string(64, '7') + "> >>"};
    locked.trailer = "/Encrypt 4 0 R /ID [<" + std::string(32, '1') + "> <" + std::string(32, '1') + ">]";
    EXPECT_EQ(problem_of(locked.bytes(), read_text),
              "pattern.pdf: it is encrypted, and opens with a password only: save it without");
    PdfTextFile many;
    many.pages.resize(501, {.content = "0 0 m 9 9 l S"});
    EXPECT_EQ(problem_of(many.bytes(), read_text), "pattern.pdf: 501 pages: at most 500 are read");
    EXPECT_EQ(problem_of(sound, read_text), "nothing");
}

TEST(PdfDrawing, of_more_points_than_a_pattern_has_is_refused_with_the_page) {
    const std::string sound = pdf_of(pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}}));
    const auto read_few = [](const std::string& bytes) { read_pdf_file(bytes, "pattern.pdf", {.points = 3}); };
    EXPECT_EQ(problem_of(sound, read_few), "pattern.pdf: page 1: more than 2 million points");
}

TEST(PdfDrawing, damaged_anywhere_gives_finite_numbers_or_one_line) {
    PdfTextFile file = layered();
    file.pages.push_back({.content = pdf_line({{20, 40}, {190, 50}, {170, 280}, {30, 270}}, false)});
    EXPECT_GT(read_mutants(file.bytes(), 150, read_text), 10);
}

TEST(PdfAnswer, comes_back_as_it_went_and_is_refused_when_cut_or_out_of_range) {
    PdfAnswer answer;
    answer.file.title = "shirt";
    answer.file.layers = {{"S", 1}};
    PdfPage page{.size = {210, 297}};
    page.shapes = {{.points = {{0, 0}, {1, 0}, {1, 1}, {2, 2}, {3, 3}}, .is_curve = {0, 1}, .layers = {0}}};
    page.texts = {{.ends = {{1, 1}, {2, 1}}, .height = 3, .text = "front", .layers = {0}}};
    page.pictures = {{0, 0}, {9, 9}};
    answer.file.pages = {page};
    const std::string bytes = bytes_of_pdf_answer(answer);
    const std::optional<PdfAnswer> back = pdf_answer_of(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(bytes_of_pdf_answer(*back), bytes);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(pdf_answer_of(std::string_view(bytes).substr(0, length))) << length;
    answer.file.pages[0].texts[0].layers = {1};
    EXPECT_FALSE(pdf_answer_of(bytes_of_pdf_answer(answer)));
    answer.file.pages[0].texts[0].layers = {0};
    answer.file.pages[0].shapes[0].points[2].x() = 1e9;
    EXPECT_FALSE(pdf_answer_of(bytes_of_pdf_answer(answer)));
}

// ---- Labels of pages, and curves that are cut.

TEST(PageLabels, are_read_in_the_ways_in_which_programs_write_them) {
    const auto labels = [](const std::vector<std::string>& words) {
        std::vector<std::vector<PdfText>> texts;
        for (const std::string& text : words) texts.push_back({{.height = 5, .text = text}});
        std::vector<const std::vector<PdfText>*> pages;
        for (const auto& list : texts) pages.push_back(&list);
        return page_labels(pages);
    };
    using Pairs = std::vector<std::pair<int, int>>;
    EXPECT_EQ(labels({"A1", "B1", "A2"}), (Pairs{{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_EQ(labels({"A1   page 1 of 2   tshirt", "B1   page 2 of 2   tshirt"}), (Pairs{{0, 0}, {1, 0}}));
    EXPECT_EQ(labels({"Row 1, column 2", "Row 2, column 2"}), (Pairs{{1, 0}, {1, 1}}));
    EXPECT_EQ(labels({"1-1", "1-2", "2-1"}), (Pairs{{0, 0}, {0, 1}, {1, 0}}));
    EXPECT_TRUE(labels({"1/2", "2/2"}).empty()) << "it counts the pages";
    EXPECT_TRUE(labels({"A1", "A1"}).empty());
    EXPECT_TRUE(labels({"A1", "front"}).empty());
    EXPECT_TRUE(is_page_text("page 3 of 12"));
    EXPECT_FALSE(is_page_text("cut 2 of lining"));
    EXPECT_FALSE(is_page_text("front"));
}

TEST(CurvePieces, that_were_cut_become_one_curve_again) {
    DrawnPath path;
    path.vertices = {{0, 0}, {100, 50}};
    OutlineEdge edge;
    edge.start = 0;
    edge.end = 1;
    edge.kind = CurveKind::Cubic;
    edge.control = {Vec2d(30, 60), Vec2d(70, -20)};
    path.edges = {edge};
    const CutRuns left = cut_to_box(path, {Vec2d(-10, -100), Vec2d(40, 100)});
    const CutRuns right = cut_to_box(path, {Vec2d(40, -100), Vec2d(110, 100)});
    ASSERT_EQ(left.runs.size(), 1U);
    ASSERT_EQ(right.runs.size(), 1U);
    std::vector<CurvePiece> run = left.runs[0];
    append_pieces(run, right.runs[0]);
    ASSERT_EQ(run.size(), 1U);
    EXPECT_LT((run[0].p[1] - edge.control[0]).norm(), 1e-6);
    EXPECT_LT((run[0].p[2] - edge.control[1]).norm(), 1e-6);
}

}  // namespace
}  // namespace selvedge::sim
