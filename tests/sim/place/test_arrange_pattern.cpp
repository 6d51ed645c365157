// Panels that nobody placed are placed round the body by their names and seams.
#include "sim/place/arrange_pattern.h"

#include <gtest/gtest.h>

#include "sim/pattern/edge_shape.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

// Edges: 0 bottom, 1 right, 2 top, 3 left.
Panel rectangle(const char* name, double width, double height) {
    Panel panel;
    panel.name = name;
    panel.vertices = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % 4});
    return panel;
}

Vec3d middle_of(const Panel& panel) {
    return panel.place(outline_box(panel).center());
}

// A boxy shirt: front and back sewn at the sides, sleeves sewn to the tops of both.
Pattern shirt() {
    Pattern pattern;
    pattern.panels = {rectangle("front", 0.5, 0.6), rectangle("back", 0.5, 0.6), rectangle("sleeve", 0.4, 0.2),
                      rectangle("sleeve_mirrored", 0.4, 0.2)};
    pattern.panels[3].mirror_of = "sleeve";
    // Right edges in two: the upper part is the armhole.
    for (std::size_t p = 0; p < 2; ++p) {
        split_edge(pattern.panels[p], 1, 0.6);
        split_edge(pattern.panels[p], 4, 0.4);
    }
    pattern.seams = {{{0, 1}, {1, 5}}, {{0, 5}, {1, 1}}, {{0, 2}, {2, 2}}, {{0, 4}, {3, 2}}};
    return pattern;
}

TEST(ArrangePattern, puts_fronts_before_and_backs_behind_the_body_at_one_height) {
    Pattern pattern = shirt();
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    const Vec3d front = middle_of(pattern.panels[0]), back = middle_of(pattern.panels[1]);
    EXPECT_GT(front.z(), 0.1);
    EXPECT_LT(back.z(), -0.1);
    EXPECT_NEAR(front.y(), back.y(), 1e-9);
    EXPECT_NEAR(front.x(), 0, 0.02);
    // The front faces to the front, the back to the back.
    EXPECT_GT(pattern.panels[0].rotation.col(2).z(), 0.99);
    EXPECT_LT(pattern.panels[1].rotation.col(2).z(), -0.99);
    EXPECT_EQ(arrangement.roles[0].part, GarmentPart::Torso);
    EXPECT_TRUE(arrangement.notes.empty());
}

TEST(ArrangePattern, wraps_each_sleeve_round_the_arm_of_its_armhole) {
    Pattern pattern = shirt();
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    // Seen from before, the right side of a front is the wearer's left, which is +x.
    EXPECT_EQ(arrangement.roles[2].flank, Flank::Left);
    EXPECT_EQ(arrangement.roles[3].flank, Flank::Right);
    EXPECT_GT(middle_of(pattern.panels[2]).x(), 0.15);
    EXPECT_LT(middle_of(pattern.panels[3]).x(), -0.15);
    EXPECT_GE(pattern.panels[2].wrap_radius, 0.4 / 6.3);
    EXPECT_EQ(pattern.panels[2].label, "arm");
}

TEST(ArrangePattern, says_what_it_placed_by_guess_and_continues_what_is_sewn) {
    Pattern pattern = shirt();
    pattern.panels.push_back(rectangle("thing", 0.2, 0.2));
    pattern.panels.push_back(rectangle("yoke", 0.5, 0.1));
    pattern.seams.push_back({{0, 3}, {5, 0}});  // on the front's top
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    ASSERT_EQ(arrangement.notes.size(), 1U);
    EXPECT_EQ(arrangement.notes[0].substr(0, 5), "thing");
    const Vec3d yoke = middle_of(pattern.panels[5]), front = middle_of(pattern.panels[0]);
    EXPECT_NEAR(yoke.y() - front.y(), 0.35, 1e-9);
    EXPECT_NEAR(yoke.z(), front.z(), 1e-9);
}

}  // namespace
}  // namespace selvedge::sim::test
