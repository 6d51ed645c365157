// DXF of pattern programs becomes drawings.
#include "sim/paper/dxf_drawing.h"

#include <set>

#include "sim/paper/drawing_file.h"
#include "sim/paper/dxf_text.h"
#include "sim/paper/fit_curve.h"
#include "sim/paper/polyline_outline.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

std::string groups(std::initializer_list<std::pair<int, const char*>> pairs) {
    std::string text;
    for (const auto& [code, value] : pairs) text += dxf_group(code, value);
    return text;
}

std::string polyline(const char* layer, std::initializer_list<Vec2d> points) {
    std::string text = groups({{0, "POLYLINE"}, {8, layer}, {66, "1"}, {70, "1"}});
    for (const Vec2d& p : points) {
        text += groups({{0, "VERTEX"}, {8, layer}}) + "10\n" + std::to_string(p.x()) + "\n20\n" +
                std::to_string(p.y()) + "\n";
    }
    return text + groups({{0, "SEQEND"}, {8, layer}});
}

// One piece, 300 x 400 mm, with a sewing line, a notch, a grain line and texts.
std::string one_piece() {
    return groups({{0, "SECTION"}, {2, "BLOCKS"}, {0, "BLOCK"}, {8, "1"}, {2, "FRONT"}}) +
           polyline("1", {{0, 0}, {300, 0}, {300, 400}, {0, 400}}) +
           polyline("14", {{10, 10}, {290, 10}, {290, 390}, {10, 390}}) +
           groups({{0, "POINT"},
                   {8, "82"},
                   {10, "290"},
                   {20, "200"},
                   {0, "LINE"},
                   {8, "7"},
                   {10, "150"},
                   {20, "50"},
                   {11, "150"},
                   {21, "350"},
                   {0, "TEXT"},
                   {8, "1"},
                   {1, "Piece Name: Vorderteil"},
                   {0, "TEXT"},
                   {8, "1"},
                   {1, "Quantity: 1,1"},
                   {0, "TEXT"},
                   {8, "1"},
                   {1, "Size: 40"},
                   {0, "ENDBLK"},
                   {0, "ENDSEC"},
                   {0, "SECTION"},
                   {2, "ENTITIES"},
                   {0, "INSERT"},
                   {2, "FRONT"},
                   {0, "TEXT"},
                   {1, "UNITS: METRIC"},
                   {0, "ENDSEC"},
                   {0, "EOF"}});
}

TEST(Dxf, reads_a_piece_with_its_lines_marks_and_texts) {
    const Drawing drawing = parse_drawing(one_piece(), "a.dxf");
    ASSERT_EQ(drawing.parts.size(), 1U);
    const DrawnPart& part = drawing.parts[0];
    EXPECT_EQ(part.name, "Vorderteil");
    EXPECT_EQ(part.size, "40");
    EXPECT_EQ(part.cut.pieces, 2);
    EXPECT_EQ(part.cut.are_mirrored, true);
    EXPECT_EQ(drawing.metres_per_unit, 0.001);
    ASSERT_EQ(part.paths.size(), 3U);
    EXPECT_EQ(part.paths[0].kind, LineKind::Cut);
    EXPECT_EQ(part.paths[1].kind, LineKind::Sew);
    EXPECT_EQ(part.paths[1].edges.size(), 4U);
    EXPECT_EQ(part.paths[2].kind, LineKind::Grain);
    ASSERT_EQ(part.marks.size(), 1U);
    EXPECT_EQ(part.marks[0].notch, NotchKind::V);
    EXPECT_FALSE(drawing.is_upright);
}

TEST(Dxf, gives_pieces_of_one_name_names_that_differ) {
    std::string text = one_piece();
    const std::size_t from = text.find("0\nBLOCK\n"), to = text.find("0\nENDSEC\n");
    std::string second = text.substr(from, to - from);
    second.replace(second.find("FRONT"), 5, "OTHER");
    text.insert(to, second);
    text.insert(text.find("0\nINSERT\n"), groups({{0, "INSERT"}, {2, "OTHER"}}));
    const Drawing drawing = read_dxf(text, "a.dxf");
    ASSERT_EQ(drawing.parts.size(), 2U);
    EXPECT_NE(drawing.parts[0].name, drawing.parts[1].name);
    for (const DrawnPart& part : drawing.parts) EXPECT_TRUE(part.name.starts_with("Vorderteil")) << part.name;
}

TEST(Dxf, names_the_line_of_what_is_wrong) {
    const auto problem = [](const std::string& wrong) {
        return problem_of(wrong, [](const std::string& text) { return read_dxf(text, "a.dxf"); });
    };
    EXPECT_EQ(problem("0\nSECTION\nzwei\nBLOCKS\n"), "a.dxf: line 3: 'zwei' where a group code should be");
    EXPECT_EQ(problem("AutoCAD Binary DXF\r\n"), "a.dxf: a binary DXF: save it as text (ASCII)");
    EXPECT_EQ(problem("0\nSECTION\n2\nBLOCKS\n0\nENDSEC\n"), "a.dxf: no closed line: nothing that could be a panel");
    std::string open = one_piece();
    open.replace(open.find("70\n1\n"), 5, "70\n0\n");
    const Drawing sewn = read_dxf(open, "a.dxf");  // its sewing line is closed
    EXPECT_EQ(sewn.notes, std::vector<std::string>{
                              "line 11: the outline of 'FRONT' is open by 400 mm: only its sewing line is taken"});
}

// A polyline of a file without blocks.
std::string loose(std::initializer_list<Vec2d> points, bool is_closed) {
    std::string text = polyline("1", points);
    if (!is_closed) text.replace(text.find("70\n1\n"), 5, "70\n0\n");
    return text;
}

TEST(Dxf, tells_which_loose_line_is_open_and_how_far) {
    const std::string head = groups({{0, "SECTION"}, {2, "ENTITIES"}, {0, "TEXT"}, {1, "UNITS: METRIC"}});
    const std::string end = groups({{0, "ENDSEC"}, {0, "EOF"}});
    const std::string open = loose({{0, 0}, {300, 0}, {300, 400}, {0, 400}, {0, 2.5}}, false);
    EXPECT_EQ(problem_of(head + open + end, [](const std::string& text) { return read_dxf(text, "a.dxf"); }),
              "a.dxf: line 9: open by 2.5 mm, and no other line is closed: nothing that could be a panel");
    const Drawing drawing = read_dxf(head + loose({{500, 0}, {800, 0}, {800, 400}}, true) + open + end, "a.dxf");
    EXPECT_EQ(drawing.parts.size(), 1U);
    ASSERT_EQ(drawing.notes.size(), 2U);
    EXPECT_TRUE(drawing.notes[0].ends_with(": open by 2.5 mm, left out")) << drawing.notes[0];
    // A gap of 0.1 mm is closed, as in blocks.
    EXPECT_EQ(read_dxf(head + loose({{0, 0}, {300, 0}, {300, 400}, {0, 0.1}}, false) + end, "").parts.size(), 1U);
}

TEST(Dxf, reads_damaged_files_or_refuses_them) {
    const int refused =
        read_mutants(one_piece(), 3000, [](const std::string& mutant) { return read_dxf(mutant, "m"); });
    EXPECT_GT(refused, 100);
    EXPECT_LT(refused, 2900);
}

TEST(Dxf, is_told_from_other_text) {
    EXPECT_TRUE(looks_like_dxf("999\nmade by\n  0\r\nSECTION\r\n"));
    EXPECT_FALSE(looks_like_dxf("0\nHEADER\n"));
    EXPECT_EQ(dxf_string("Gr\xF6\xDF"
                         "e"),
              "Größe");
    EXPECT_EQ(dxf_string("Gr\xC3\xB6\\U+00DFe"), "Größe");
}

TEST(PolylineOutline, has_corners_where_it_turns_much_more_than_beside) {
    std::vector<Vec2d> circle;
    for (int i = 0; i < 24; ++i) circle.emplace_back(std::cos(i * 0.2618), std::sin(i * 0.2618));
    EXPECT_TRUE(find_corners(circle, true).empty());
    const std::vector<Vec2d> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_EQ(find_corners(square, true).size(), 4U);
    std::vector<Vec2d> armhole{{0, 0}, {0.3, 0}};  // a straight edge, then a quarter of a circle
    for (int i = 0; i <= 12; ++i)
        armhole.emplace_back(0.3 - 0.2 * std::sin(i * 0.1309), 0.4 - 0.2 * std::cos(i * 0.1309));
    EXPECT_EQ(find_corners(armhole, true).size(), 4U);
}

TEST(PolylineOutline, has_one_curve_for_a_run_of_many_points) {
    std::vector<Vec2d> points{{0, 0}, {0.3, 0}};
    for (int i = 0; i <= 30; ++i) points.emplace_back(0.3 - 0.05 * std::sin(i * 0.1047), 0.02 * i);
    points.emplace_back(0, 0.6);
    const DrawnPath path = outline_of_points(points, true, {.tolerance = 1e-4});
    EXPECT_LE(path.edges.size(), 6U);
    EXPECT_GE(path.edges.size(), 4U);
}

TEST(FitCurve, meets_its_points_within_the_tolerance_with_few_curves) {
    const CubicPoints truth{Vec2d(0, 0), Vec2d(0.1, 0.3), Vec2d(0.4, 0.3), Vec2d(0.5, 0)};
    std::vector<Vec2d> points;
    for (int i = 0; i <= 40; ++i) points.push_back(point_on(truth, i / 40.0));
    const std::vector<CubicPoints> one = fit_curve(points, {.tolerance = 1e-4});
    EXPECT_EQ(one.size(), 1U);
    for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
        std::vector<Vec2d> wave;
        for (int i = 0; i <= 200; ++i) wave.emplace_back(0.01 * i, 0.2 * std::sin(0.05 * i));
        const std::vector<CubicPoints> cubics = fit_curve(wave, {.tolerance = tolerance});
        EXPECT_LT(cubics.size(), 40U);
        double worst = 0;
        for (const Vec2d& p : wave) {
            double least = 1;
            for (const CubicPoints& cubic : cubics) {
                for (int k = 0; k <= 400; ++k) least = std::min(least, (point_on(cubic, k / 400.0) - p).norm());
            }
            worst = std::max(worst, least);
        }
        EXPECT_LT(worst, tolerance + 1e-3) << tolerance;  // samples of the curves are up to 1 mm apart
        EXPECT_EQ(cubics.front()[0], wave.front());
        EXPECT_EQ(cubics.back()[3], wave.back());
    }
    EXPECT_TRUE(fit_curve(std::vector<Vec2d>{{1, 1}, {1, 1}}).empty());
}

struct RealDxf {
    const char* name;
    std::size_t parts;
};
class DxfFile : public ::testing::TestWithParam<RealDxf> {};

TEST_P(DxfFile, has_all_its_pieces_under_names_that_differ) {
    const std::filesystem::path folder = real_patterns("dxf");
    if (folder.empty()) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.path().filename().string().starts_with(GetParam().name)) continue;
        const Drawing drawing = read_drawing(entry.path());
        EXPECT_EQ(drawing.parts.size(), GetParam().parts) << entry.path();
        std::set<std::string> names;
        for (const DrawnPart& part : drawing.parts) names.insert(part.name);
        EXPECT_EQ(names.size(), drawing.parts.size());
        ++files;
    }
    EXPECT_GE(files, 2);
}

INSTANTIATE_TEST_SUITE_P(, DxfFile,
                         ::testing::Values(RealDxf{"MaleShirt", 17}, RealDxf{"TShirt_test", 5},
                                           RealDxf{"Issue_937a", 1}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace selvedge::sim
