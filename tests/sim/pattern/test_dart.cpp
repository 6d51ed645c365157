// Darts are found by the seams of their legs, and pressed as tailors press them.
#include "sim/pattern/dart.h"

#include <gtest/gtest.h>

#include "sim/pattern/edge_shape.h"
#include "tests/support/darted_panel.h"

namespace selvedge::sim {
namespace {

TEST(Dart, level_ones_are_pressed_down_and_upright_ones_to_the_centre) {
    const Pattern pattern = darted_pattern();
    const std::vector<Dart> darts = find_darts(pattern.panels[0], 0, pattern.seams);
    ASSERT_EQ(darts.size(), 2U);
    EXPECT_EQ(darts[0], (Dart{.first_leg = 1, .leg_edges = 1, .pressed_to = DartSide::Before, .is_level = false}));
    EXPECT_EQ(darts[1], (Dart{.first_leg = 5, .leg_edges = 1, .pressed_to = DartSide::Before, .is_level = true}));
}

TEST(Dart, of_the_mirror_image_are_pressed_to_the_same_side_of_the_body) {
    Pattern pattern = darted_pattern();
    pattern.panels[0] = mapped_panel(pattern.panels[0], Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    pattern.seams = {{{0, 8}, {0, 9}}, {{0, 4}, {0, 5}}};
    const std::vector<Dart> darts = find_darts(pattern.panels[0], 0, pattern.seams);
    ASSERT_EQ(darts.size(), 2U);
    EXPECT_EQ(darts[0], (Dart{.first_leg = 4, .leg_edges = 1, .pressed_to = DartSide::After, .is_level = true}));
    EXPECT_EQ(darts[1], (Dart{.first_leg = 8, .leg_edges = 1, .pressed_to = DartSide::After, .is_level = false}));
}

TEST(Dart, has_legs_of_several_edges) {
    Pattern pattern = darted_pattern();
    split_edge(pattern.panels[0], 2, 0.5);
    split_edge(pattern.panels[0], 1, 0.5);
    pattern.seams = {{{0, 2}, {0, 3}}, {{0, 4}, {0, 1}}};
    const std::vector<Dart> darts = find_darts(pattern.panels[0], 0, pattern.seams);
    ASSERT_EQ(darts.size(), 1U);
    EXPECT_EQ(darts[0].first_leg, 1);
    EXPECT_EQ(darts[0].leg_edges, 2);
}

TEST(Dart, is_none_without_a_seam_or_at_an_outer_corner) {
    Pattern pattern = darted_pattern();
    // Waist to side, at the outer corner between them; legs of different darts; right side to wrong side.
    pattern.seams = {{{0, 3}, {0, 4}}, {{0, 1}, {0, 6}}, {.first = {0, 5}, .second = {0, 6}, .is_reversed = false}};
    EXPECT_TRUE(find_darts(pattern.panels[0], 0, pattern.seams).empty());
    pattern.seams = {{{1, 1}, {1, 2}}};
    EXPECT_TRUE(find_darts(pattern.panels[0], 0, pattern.seams).empty());
}

}  // namespace
}  // namespace selvedge::sim
