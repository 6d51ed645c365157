// FreeSewing's drafts, as data and as SVG.
#include "sim/paper/freesewing_json.h"

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
        ASSERT_EQ(a->edges.size(), b->edges.size()) << data.parts[p].name;
        const Vec2d shift = b->vertices[0] - a->vertices[0];
        for (std::size_t v = 0; v < a->vertices.size(); ++v)
            EXPECT_LT((b->vertices[v] - shift - a->vertices[v]).norm(), 0.02) << data.parts[p].name << " " << v;
    }
}

INSTANTIATE_TEST_SUITE_P(, FreesewingDraft, ::testing::Values("teagan", "aaron", "sandy"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace selvedge::sim
