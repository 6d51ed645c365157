// FreeSewing's drafts, as data and as SVG.
#include "sim/paper/freesewing_json.h"

#include <algorithm>
#include <limits>

#include "sim/core/json.h"
#include "sim/paper/drawing_file.h"
#include "sim/paper/freesewing_lines.h"
#include "tests/sim/paper/drawings.h"

namespace selvedge::sim {
namespace {

TEST(Freesewing, tells_sewing_cut_and_fold_lines_apart) {
    const Drawing drawing = parse_drawing(half_front_json(), "");
    ASSERT_EQ(drawing.parts.size(), 1U);
    const DrawnPart& front = drawing.parts[0];
    EXPECT_EQ(front.name, "front");
    ASSERT_EQ(front.paths.size(), 3U);
    EXPECT_EQ(front.paths[0].kind, LineKind::Sew);
    EXPECT_EQ(front.paths[0].edges.size(), 6U);
    EXPECT_EQ(front.paths[1].kind, LineKind::Cut);  // an open piece of it
    EXPECT_EQ(front.paths[2].kind, LineKind::FoldEdge);
    EXPECT_EQ(front.paths[0].vertices[1], Vec2d(250, -600));
    ASSERT_EQ(front.marks.size(), 1U);
    EXPECT_EQ(front.marks[0].count, 2);
    EXPECT_EQ(drawing.allowance, 0.01);
    ASSERT_EQ(drawing.measurements.size(), 1U);  // slopes are no lengths
    EXPECT_EQ(drawing.measurements[0], (Measurement{"chest", 0.925}));
}

TEST(Freesewing, says_which_key_is_wrong) {
    try {
        parse_drawing(R"({"parts": {"a": {"paths": {"seam": {"ops": [{"type": "jump"}]}}}}})", "a.json");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "a.json: parts.a.paths.seam.ops[0]: 'jump' is none of move, line, curve, close");
    }
}

TEST(Freesewing, is_read_damaged_or_refused) {
    const int refused =
        read_mutants(half_front_json(), 3000, [](const std::string& mutant) { return parse_drawing(mutant, "m"); });
    EXPECT_GT(refused, 100);
}

// What half_front_json() holds, as FreeSewing draws it: parts in stacks, snippets as uses, the fold's words along its
// line.
std::string half_front_svg() {
    return R"svg(<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
 xmlns:freesewing="http://freesewing.org/namespaces/freesewing" freesewing="4.0.0" class="freesewing" width="300mm"
 height="700mm" viewBox="0 0 300 700"><defs><g id="bnotch"><circle cx="0" cy="0" r="1.4"/></g>
 <g id="logo"><path class="note" d="M 0,0 L 5,5"/></g></defs><g id="fs-container">
 <g id="fs-stack-test.front" transform="translate(20, 30)">
 <g id="fs-stack-test.front-part-test.front" transform="translate(5, -7)">
 <path class="fabric" id="seam" d="M 0,600 L 250,600 L 260,250 C 200,250 190,120 200,40 L 90,10 C 85,60 40,100 0,100 L 0,600 z"/>
 <path class="fabric sa" d="M 0,610 L 260,610"/>
 <path class="note" id="fold" d="M 0,150 L 15,150 L 15,550 L 0,550"/>
 <text><textPath xlink:href="#fold" startOffset="50%">Cut on fold / Grainline</textPath></text>
 <use x="200" y="40" xlink:href="#bnotch"/><use x="9" y="9" xlink:href="#logo"/></g></g></g></svg>)svg";
}

// The largest distance between the vertices of two lines whose first vertices are at one place, in their unit. Infinite
// if they have other edges.
double distance_of(const DrawnPath& a, const DrawnPath& b) {
    if (a.edges.size() != b.edges.size()) return std::numeric_limits<double>::infinity();
    const Vec2d shift = b.vertices[0] - a.vertices[0];
    double farthest = 0;
    for (std::size_t v = 0; v < a.vertices.size(); ++v)
        farthest = std::max(farthest, (b.vertices[v] - shift - a.vertices[v]).norm());
    return farthest;
}

TEST(Freesewing, of_one_half_front_as_data_and_as_svg_is_the_same) {
    const Drawing data = parse_drawing(half_front_json(), ""), drawn = parse_drawing(half_front_svg(), "");
    EXPECT_EQ(drawn.format, "FreeSewing SVG");
    EXPECT_EQ(drawn.metres_per_unit, data.metres_per_unit);
    ASSERT_EQ(drawn.parts.size(), 1U);
    const DrawnPart &front = drawn.parts[0], &expected = data.parts[0];
    EXPECT_EQ(front.name, expected.name);
    ASSERT_EQ(front.paths.size(), expected.paths.size());
    for (std::size_t p = 0; p < front.paths.size(); ++p) {
        EXPECT_EQ(front.paths[p].kind, expected.paths[p].kind) << p;
        EXPECT_LT(distance_of(front.paths[p], expected.paths[p]), 1e-9) << p;
    }
    ASSERT_EQ(front.marks.size(), 1U) << "a logo is none";
    EXPECT_EQ(front.marks[0].count, expected.marks[0].count);
    const auto from_seam = [](const DrawnPart& part) { return Vec2d(part.marks[0].at - part.paths[0].vertices[0]); };
    EXPECT_LT((from_seam(front) - from_seam(expected)).norm(), 1e-9);
}

class FreesewingDraft : public ::testing::TestWithParam<const char*> {};

// The SVG is rounded to a hundredth of a millimetre.
TEST_P(FreesewingDraft, is_the_same_as_data_and_as_svg) {
    const std::filesystem::path folder = real_patterns("freesewing");
    if (folder.empty()) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
    const Drawing data = read_drawing(folder / (std::string(GetParam()) + ".json"));
    const Drawing drawn = read_drawing(folder / (std::string(GetParam()) + ".svg"));
    ASSERT_EQ(data.parts.size(), drawn.parts.size());
    const auto sewn = [](const DrawnPart& part) {
        return std::ranges::find_if(part.paths, [](const DrawnPath& path) { return path.kind == LineKind::Sew; });
    };
    for (std::size_t p = 0; p < data.parts.size(); ++p) {
        EXPECT_EQ(data.parts[p].name, drawn.parts[p].name);
        EXPECT_EQ(data.parts[p].marks.size(), drawn.parts[p].marks.size());
        const auto a = sewn(data.parts[p]), b = sewn(drawn.parts[p]);
        ASSERT_NE(a, data.parts[p].paths.end());
        ASSERT_NE(b, drawn.parts[p].paths.end());
        EXPECT_LT(distance_of(*a, *b), 0.02) << data.parts[p].name;
    }
}

INSTANTIATE_TEST_SUITE_P(, FreesewingDraft, ::testing::Values("teagan", "aaron", "sandy"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace selvedge::sim
