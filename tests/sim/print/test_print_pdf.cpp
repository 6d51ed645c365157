// Pages and PDF: every piece is on a page, sizes are read, layers are chosen, the same pattern gives the same bytes.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/core/error.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"
#include "sim/print/print_pdf.h"
#include "sim/print/svg_file.h"
#include "tests/sim/print/sample_pattern.h"
#include "tests/support/darted_panel.h"

namespace selvedge::sim {
namespace {

TEST(PaperPiece, label_and_grain_line_lie_in_the_panel) {
    for (const std::filesystem::path& file : shipped_patterns()) {
        const Pattern pattern = load_pattern(file).pattern;
        for (const PaperPiece& piece : paper_pieces(pattern)) {
            const Panel& panel = pattern.panels[static_cast<std::size_t>(piece.panel)];
            SCOPED_TRACE(file.filename().string() + " " + panel.name);
            EXPECT_TRUE(is_inside(piece.label.at, piece.sew));
            const auto grain = std::ranges::find(piece.lines, PaperLayer::Grain, &PaperLine::layer);
            ASSERT_NE(grain, piece.lines.end());
            for (const Vec2d& p : grain->points) EXPECT_TRUE(is_inside(p, piece.sew));
            const Vec2d along = (grain->points[1] - grain->points[0]).normalized();
            EXPECT_NEAR(along.x(), -std::sin(panel.grain_angle), 1e-9);
            EXPECT_NEAR(along.y(), std::cos(panel.grain_angle), 1e-9);
        }
    }
}

TEST(PaperPiece, names_the_file_of_a_fabric_without_its_folder) {
    Pattern pattern = load_pattern(source_folder() + "/patterns/skirt.json").pattern;
    pattern.fabric = "/fabrics/my_silk.json";
    pattern.panels[0].interlinings = {"/fabrics/canvas.json"};
    const PaperPiece piece = paper_pieces(pattern)[0];
    const auto has = [&](const std::string& end) {
        return std::ranges::any_of(piece.label.lines, [&](const std::string& line) { return line.ends_with(end); });
    };
    EXPECT_TRUE(has(" of my_silk"));
    EXPECT_TRUE(has("fuse with canvas"));
}

// The box of a label, m, with letters that are half as wide as high: narrower than they are.
Eigen::AlignedBox2d text_box(const PaperLabel& label) {
    std::size_t longest = 0;
    for (const std::string& line : label.lines) longest = std::max(longest, line.size());
    const Vec2d half(0.5 * label.height * static_cast<double>(longest) / 2,
                     label.height * static_cast<double>(label.lines.size()) / 2);
    const Vec2d turned(half.y(), half.x());
    return label.runs_up ? Eigen::AlignedBox2d(label.at - turned, label.at + turned)
                         : Eigen::AlignedBox2d(label.at - half, label.at + half);
}

TEST(PaperPiece, label_and_grain_line_keep_clear_of_lines_inside) {
    Pattern pattern = sample_pattern();
    Panel& strip = pattern.panels[1];
    strip.internal_lines = {{.name = "fold", .points = {{0, 0.03}, {0.5, 0.03}}, .use = LineUse::Fold},
                            {.name = "button", .points = {{0.25, 0}, {0.25, 0.06}}, .use = LineUse::Mark}};
    strip.drill_points = {{0.12, 0.015}, {0.38, 0.045}};
    strip.grain_angle = 0;
    for (const double width : {0.06, 0.05, 0.04}) {
        for (int v : {2, 3}) strip.vertices[static_cast<std::size_t>(v)].y() = width;
        const PaperPiece piece = paper_pieces(pattern)[1];
        const Eigen::AlignedBox2d box = text_box(piece.label);
        for (const PaperLine& line : piece.lines)
            EXPECT_FALSE(segment_meets_box(line.points[0], line.points[1], box))
                << width << " " << layer_name(line.layer);
        for (const Vec2d& at : piece.drill_points) EXPECT_FALSE(box.contains(at)) << width;
    }
}

TEST(PaperPiece, label_of_a_narrow_upright_strip_runs_up) {
    Pattern pattern = sample_pattern();
    Panel& strip = pattern.panels[1];
    strip.vertices = {{0, 0}, {0.06, 0}, {0.06, 0.5}, {0, 0.5}};
    strip.grain_angle = 0;
    strip.internal_lines = {{.name = "fold", .points = {{0.03, 0}, {0.03, 0.5}}, .use = LineUse::Fold}};
    const PaperPiece piece = paper_pieces(pattern)[1];
    EXPECT_TRUE(piece.label.runs_up);
    EXPECT_GE(piece.label.height, 0.0045);
    const Eigen::AlignedBox2d box = text_box(piece.label);
    EXPECT_TRUE(outline_box(strip).contains(box));
    EXPECT_FALSE(segment_meets_box({0.03, 0}, {0.03, 0.5}, box));
    EXPECT_FALSE(paper_pieces(pattern)[0].label.runs_up);
    const std::string svg = svg_of(pattern, paper_sheet(pattern, paper_pieces(pattern), 1.5));
    EXPECT_NE(svg.find("transform=\"rotate(-90 "), std::string::npos);
}

TEST(PaperPiece, labels_are_read_from_below_or_from_the_right_however_the_panel_is_turned) {
    constexpr double kQuarter = 1.5707963267948966;
    for (int k = -4; k <= 4; ++k) {
        EXPECT_NEAR(PaperLabel{}.angle(k * kQuarter), k % 2 == 0 ? 0 : kQuarter, 1e-9) << k;
        EXPECT_NEAR(PaperLabel{.runs_up = true}.angle(k * kQuarter), k % 2 == 0 ? kQuarter : 0, 1e-9) << k;
    }
}

TEST(PaperPiece, grain_line_does_not_run_along_the_outline) {
    // A collar stand: its lower edge bulges up to where the longest line along it would touch.
    Pattern pattern;
    Panel stand;
    stand.name = "stand";
    stand.vertices = {{0, 0}, {0.2, 0.017}, {0.4, 0}, {0.4, 0.05}, {0.2, 0.067}, {0, 0.05}};
    for (int e = 0; e < 6; ++e) stand.edges.push_back({.start = e, .end = (e + 1) % 6});
    stand.grain_angle = 1.5707963267948966;
    pattern.panels = {stand};
    const PaperPiece piece = paper_pieces(pattern).front();
    const auto grain = std::ranges::find(piece.lines, PaperLayer::Grain, &PaperLine::layer);
    ASSERT_NE(grain, piece.lines.end());
    for (int k = 0; k <= 20; ++k) {
        const Vec2d p = grain->points[0] + (grain->points[1] - grain->points[0]) * k / 20.0;
        EXPECT_GT(distance_to_outline(p, piece.sew), 0.0035) << k;
    }
}

TEST(PaperPiece, darts_have_notches_at_their_legs_a_fold_and_a_word_on_how_they_are_pressed) {
    Pattern pattern = darted_pattern();
    pattern.allowance = 0.01;
    const PaperPiece piece = paper_pieces(pattern).front();
    ASSERT_EQ(piece.leg_notches.size(), 4U);
    for (const NotchLine& notch : piece.leg_notches) EXPECT_LT(distance_to_outline(notch.on_cut, piece.cut), 1e-6);
    EXPECT_EQ(std::ranges::count_if(piece.lines, &PaperLine::is_dart_fold), 2);
    EXPECT_EQ(piece.label.lines.back(), "press level darts down, upright darts to the centre");
    pattern.seams.pop_back();
    EXPECT_EQ(paper_pieces(pattern).front().label.lines.back(), "press the dart to the centre");
    // Without an allowance it is cut along the sewing line, into the darts.
    pattern.allowance = 0;
    EXPECT_TRUE(paper_pieces(pattern).front().leg_notches.empty());
}

TEST(PaperPiece, halves_on_a_fold_have_the_darts_of_one_side) {
    Pattern pattern = darted_pattern();
    pattern.allowance = 0.01;
    pattern.panels[0] = unfolded(pattern.panels[0], 9);
    pattern.seams = {{{0, 1}, {0, 2}}, {{0, 5}, {0, 6}}, {{0, 11}, {0, 12}}, {{0, 15}, {0, 16}}};
    EXPECT_EQ(paper_pieces(pattern).front().leg_notches.size(), 8U);
    const PaperPiece half = paper_pieces(pattern, {.are_halved = true}).front();
    EXPECT_TRUE(half.is_on_fold);
    EXPECT_EQ(half.leg_notches.size(), 4U);
    EXPECT_EQ(std::ranges::count_if(half.lines, &PaperLine::is_dart_fold), 2);
}

TEST(PaperPiece, mirror_images_become_pairs_of_one_piece) {
    const Pattern tshirt = load_pattern(source_folder() + "/patterns/tshirt.json").pattern;
    const std::size_t images = static_cast<std::size_t>(
        std::ranges::count_if(tshirt.panels, [](const Panel& panel) { return !panel.mirror_of.empty(); }));
    const std::vector<PaperPiece> all = paper_pieces(tshirt);
    const std::vector<PaperPiece> once = paper_pieces(tshirt, {.draws_mirror_images = false});
    EXPECT_EQ(all.size(), tshirt.panels.size());
    EXPECT_EQ(once.size(), tshirt.panels.size() - images);
    int pieces = 0;
    for (const PaperPiece& piece : once) pieces += piece.cut_from_fabric;
    EXPECT_EQ(pieces, static_cast<int>(tshirt.panels.size()));
}

TEST(PaperPiece, symmetric_panels_become_halves_on_a_fold) {
    Pattern pattern = load_pattern(source_folder() + "/patterns/tshirt.json").pattern;
    pattern.allowance = 0.01;
    const std::vector<PaperPiece> whole = paper_pieces(pattern), halves = paper_pieces(pattern, {.are_halved = true});
    ASSERT_EQ(halves.size(), whole.size());
    const auto area_of = [](const std::vector<Vec2d>& line) {
        double doubled = 0;
        for (std::size_t i = 0; i < line.size(); ++i) doubled += cross2(line[i], line[(i + 1) % line.size()]);
        return doubled / 2;
    };
    int folded = 0;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const Panel& panel = pattern.panels[static_cast<std::size_t>(halves[i].panel)];
        EXPECT_EQ(halves[i].is_on_fold, panel.name == "front" || panel.name == "back") << panel.name;
        if (!halves[i].is_on_fold) continue;
        ++folded;
        EXPECT_NEAR(2 * std::abs(area_of(halves[i].cut)), std::abs(area_of(whole[i].cut)), 1e-5);
        EXPECT_NEAR(2 * halves[i].box().sizes().x(), whole[i].box().sizes().x(), 1e-3);
        EXPECT_TRUE(halves[i].label.lines[2].starts_with("cut 1 on fold")) << halves[i].label.lines[2];
        EXPECT_TRUE(std::ranges::any_of(halves[i].lines, [](const PaperLine& line) {
            return line.layer == PaperLayer::Fold && (line.points[0] - line.points[1]).norm() > 0.4;
        }));
    }
    EXPECT_EQ(folded, 2);
}

TEST(PaperPiece, cut_lines_keep_the_allowance_everywhere) {
    for (const std::filesystem::path& file : shipped_patterns()) {
        Pattern pattern = load_pattern(file).pattern;
        pattern.allowance = 0.01;
        for (const PaperPiece& piece : paper_pieces(pattern)) {
            SCOPED_TRACE(file.filename().string() + " " + pattern.panels[static_cast<std::size_t>(piece.panel)].name);
            for (const Vec2d& p : piece.cut) {
                EXPECT_GT(distance_to_outline(p, piece.sew), 0.01 - 1e-4);
                EXPECT_FALSE(is_inside(p, piece.sew));
            }
        }
    }
}

// The text that a call refuses, or "" if it does not.
std::string refusal(const std::string& paper) {
    try {
        parse_page_size(paper);
    } catch (const InputError& error) {
        return error.problem();
    }
    return "";
}

TEST(Pages, paper_is_read_by_name_and_by_size) {
    EXPECT_EQ(parse_page_size("A4").size, Vec2d(0.21, 0.297));
    EXPECT_EQ(parse_page_size("letter").size, Vec2d(0.2159, 0.2794));
    EXPECT_EQ(parse_page_size("300x412.5").size, Vec2d(0.3, 0.4125));
    for (const char* wrong : {"a9", "", "x", "300x", "x300", "10x300", "300x9000", "nanxnan", "300x300x300"})
        EXPECT_NE(refusal(wrong), "") << wrong;
}

TEST(Pages, neighbours_overlap_by_a_centimetre) {
    PaperSheet sheet;
    sheet.size = {0.5, 0.6};
    const PageGrid grid = grid_over(sheet, {0.21, 0.297});
    EXPECT_NEAR(grid.area(0, 0).max().x() - grid.area(1, 0).min().x(), 0.01, 1e-12);
    EXPECT_NEAR(grid.area(0, 1).max().y() - grid.area(0, 0).min().y(), 0.01, 1e-12);
    EXPECT_DOUBLE_EQ(grid.area(0, 0).max().y(), 0.6);
    EXPECT_GE(grid.area(grid.columns - 1, 0).max().x(), 0.5);
    EXPECT_LE(grid.area(0, grid.rows - 1).min().y(), 0);
}

TEST(Pages, every_point_of_a_cut_line_is_on_a_page_and_no_page_is_empty) {
    for (const std::filesystem::path& file : shipped_patterns()) {
        SCOPED_TRACE(file.filename().string());
        Pattern pattern = load_pattern(file).pattern;
        pattern.allowance = 0.01;
        const PagedSheet paged = lay_out_pages(pattern, paper_pieces(pattern), parse_page_size("a4"));
        std::vector<bool> is_used(paged.pages.size(), false);
        for (std::size_t i = 0; i < paged.sheet.pieces.size(); ++i) {
            std::vector<Vec2d> outline = paged.sheet.pieces[i].cut;
            for (Vec2d& p : outline) p = paged.sheet.places[i].at(p);
            for (const Vec2d& p : outline) {
                bool is_shown = false;
                for (std::size_t k = 0; k < paged.pages.size(); ++k) {
                    const auto area = paged.grid.area(paged.pages[k].column, paged.pages[k].row);
                    if (area.exteriorDistance(p) > 1e-9) continue;
                    is_shown = true;
                    is_used[k] = true;
                }
                EXPECT_TRUE(is_shown) << p.transpose();
            }
            for (std::size_t k = 0; k < paged.pages.size(); ++k) {
                const auto area = paged.grid.area(paged.pages[k].column, paged.pages[k].row);
                if (is_inside(area.center(), outline)) is_used[k] = true;
            }
        }
        // A long straight edge can cross a page's corner without a point of its own there.
        EXPECT_LE(std::ranges::count(is_used, false), static_cast<long>(paged.pages.size() / 3));
    }
}

TEST(Pages, labels_lie_on_one_page_each) {
    for (const std::filesystem::path& file : shipped_patterns()) {
        const Pattern pattern = load_pattern(file).pattern;
        const PagedSheet paged = lay_out_pages(pattern, paper_pieces(pattern), parse_page_size("a4"));
        for (std::size_t i = 0; i < paged.sheet.pieces.size(); ++i) {
            const PaperPiece& piece = paged.sheet.pieces[i];
            Eigen::AlignedBox2d box = label_box(piece.label);
            box.translate(paged.sheet.places[i].shift);
            EXPECT_TRUE(std::ranges::any_of(
                paged.pages,
                [&](const Page& page) { return paged.grid.own_area(page.column, page.row).contains(box); }))
                << file.filename().string() << " " << piece.label.lines[0];
            EXPECT_GE(piece.label.height, 0.004);
            for (const PaperLine& line : piece.lines) {
                for (std::size_t k = 0; k + 1 < line.points.size(); ++k)
                    EXPECT_FALSE(segment_meets_box(line.points[k], line.points[k + 1], label_box(piece.label)));
            }
        }
    }
}

TEST(PrintPdf, same_pattern_gives_the_same_bytes) {
    const PrintOptions options{.paper = parse_page_size("a4")};
    const PrintedPdf a = print_pdf(sample_pattern(), options), b = print_pdf(sample_pattern(), options);
    EXPECT_TRUE(a.bytes.starts_with("%PDF"));
    EXPECT_EQ(a.bytes, b.bytes);
    EXPECT_EQ(a.covers, 1);
    EXPECT_GE(a.pages, 4);
    EXPECT_EQ(a.bytes.find("CreationDate"), std::string::npos);
}

TEST(PrintPdf, each_layer_can_be_chosen_alone) {
    std::vector<std::string> files;
    for (int k = 0; k < kPaperLayers; ++k) {
        PrintOptions options{.paper = parse_page_size("a3"), .layers = {}};
        options.layers[static_cast<std::size_t>(k)] = true;
        files.push_back(print_pdf(sample_pattern(), options).bytes);
        const auto layer = static_cast<PaperLayer>(k);
        EXPECT_EQ(find_layer(layer_name(layer)), layer);
    }
    std::ranges::sort(files);
    EXPECT_EQ(std::unique(files.begin(), files.end()), files.end());
    EXPECT_FALSE(find_layer("cutting"));
}

TEST(PrintPdf, names_of_any_script_print) {
    Pattern pattern = sample_pattern();
    pattern.name = "Рубашка 襯衫 عربي \xFF\xFE";
    pattern.panels[0].name = std::string(3000, 'x');
    EXPECT_TRUE(print_pdf(pattern, {.paper = parse_page_size("a4")}).bytes.starts_with("%PDF"));
    EXPECT_TRUE(print_pdf(pattern, {.paper = parse_page_size("150x150")}).bytes.starts_with("%PDF"));
}

TEST(PrintPdf, one_page_and_layouts_are_of_true_size) {
    const Pattern pattern = sample_pattern();
    const PrintedPdf one = print_pdf(pattern, {.paper = parse_page_size("a0"), .is_one_page = true});
    EXPECT_EQ(one.pages, 1);
    const std::vector<PaperSheet> layouts = cutting_layouts(pattern, {.width = 1.0});
    const PrintedPdf marker = print_layouts(layouts, parse_page_size("a4"), true);
    // 1 m of fabric and 1.5 cm on both sides, in points.
    EXPECT_NE(marker.bytes.find("/MediaBox [ 0 0 2919.685"), std::string::npos);
    const PrintedPdf plan = print_layouts(layouts, parse_page_size("a4"), false);
    EXPECT_NE(plan.bytes.find("/MediaBox [ 0 0 595.27"), std::string::npos);
}

TEST(PrintPdf, of_more_pieces_than_it_has_room_for_is_refused_before_they_are_laid_out) {
    Pattern pattern = load_pattern(source_folder() + "/patterns/two_squares.json").pattern;
    pattern.panels.resize(2001, pattern.panels[0]);
    const auto problem = [](const auto& print) {
        try {
            print();
        } catch (const InputError& error) {
            return error.problem();
        }
        return std::string("none");
    };
    EXPECT_EQ(problem([&] { print_pdf(pattern, {.paper = parse_page_size("a4"), .is_one_page = true}); }),
              "2001 pieces: at most 2000 are drawn in a PDF");
    PaperSheet layout;
    layout.pieces.resize(2001);
    EXPECT_EQ(problem([&] { print_layouts({layout}, parse_page_size("a4"), true); }),
              "2001 pieces: at most 2000 are drawn in a PDF");
}

}  // namespace
}  // namespace selvedge::sim
