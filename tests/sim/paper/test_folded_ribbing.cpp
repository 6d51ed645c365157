// Bands of ribbing, which are drawn whole and worn folded in half.
#include <gtest/gtest.h>
#include <array>
#include <string>
#include <vector>

#include "sim/paper/folded_ribbing.h"
#include "sim/pattern/outline.h"
#include "tests/support/polygon.h"

namespace selvedge::sim {
namespace {

const std::vector<std::string> kCuff{"cuff"};

// A cuff, 10 cm high, whose lower edge (0) is sewn to a sleeve, and whose ends (1 and 3) meet.
Pattern sleeve_with_cuff() {
    Pattern pattern;
    pattern.panels = {polygon("sleeve", {{0, 0}, {0.22, 0}, {0.22, 0.5}, {0, 0.5}}),
                      polygon("cuff", {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}})};
    pattern.panels[1].allowance = 0.01;
    pattern.seams = {{.first = {1, 0}, .second = {0, 0}}, {.first = {1, 1}, .second = {1, 3}}};
    return pattern;
}

TEST(FoldedRibbing, is_worn_half_as_high_and_cut_as_it_is_drawn) {
    Pattern pattern = sleeve_with_cuff();
    const std::vector<std::string> notes = fold_ribbing(pattern, kCuff);
    EXPECT_EQ(notes, std::vector<std::string>{"cuff: folded in half, so worn 5.0 cm high; cut as it is drawn"});
    const Panel& cuff = pattern.panels[1];
    const std::vector<Vec2d> folded{{0, 0}, {0.2, 0}, {0.2, 0.05}, {0, 0.05}};
    for (std::size_t v = 0; v < folded.size(); ++v) EXPECT_LT((cuff.vertices[v] - folded[v]).norm(), 1e-12) << v;
    EXPECT_NEAR(cuff.edges[2].allowance.value_or(0), 0.06, 1e-12) << "the other half, and what was allowed before";
    EXPECT_FALSE(cuff.edges[0].allowance);
    EXPECT_EQ(pattern.panels[0], sleeve_with_cuff().panels[0]);
}

TEST(FoldedRibbing, has_its_marks_on_the_layer_below_turned_over) {
    Pattern pattern = sleeve_with_cuff();
    pattern.panels[1].drill_points = {{0.1, 0.02}, {0.1, 0.09}};
    fold_ribbing(pattern, kCuff);
    EXPECT_LT((pattern.panels[1].drill_points[0] - Vec2d(0.1, 0.02)).norm(), 1e-12);
    EXPECT_LT((pattern.panels[1].drill_points[1] - Vec2d(0.1, 0.01)).norm(), 1e-12);
}

TEST(FoldedRibbing, folds_the_mirror_image_of_a_band_with_it) {
    Pattern pattern = sleeve_with_cuff();
    pattern.panels[1].name = "cuff_mirrored";
    pattern.panels[1].mirror_of = "cuff";
    EXPECT_EQ(fold_ribbing(pattern, kCuff).size(), 1U);
}

TEST(FoldedRibbing, stays_whole_where_both_edges_are_sewn_or_it_is_no_band) {
    Pattern both = sleeve_with_cuff();
    both.seams.push_back({.first = {1, 2}, .second = {0, 2}});
    Pattern loose = sleeve_with_cuff();
    loose.seams.erase(loose.seams.begin());
    Pattern slanted = sleeve_with_cuff();
    slanted.panels[1].vertices[2].x() -= 0.02;
    Pattern curved = sleeve_with_cuff();
    curved.panels[1].edges[2].kind = CurveKind::Quadratic;
    curved.panels[1].edges[2].control[0] = {0.1, 0.12};
    for (const Pattern& pattern : {both, loose, slanted, curved}) {
        Pattern folded = pattern;
        EXPECT_TRUE(fold_ribbing(folded, kCuff).empty());
        EXPECT_EQ(folded, pattern);
    }
    Pattern other = sleeve_with_cuff();
    EXPECT_TRUE(fold_ribbing(other, std::array<std::string, 1>{"waistband"}).empty());
}

}  // namespace
}  // namespace selvedge::sim
