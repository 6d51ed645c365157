// Panels that nobody placed are placed round the body by their names and seams.
#include "sim/place/arrange_pattern.h"

#include <gtest/gtest.h>
#include <cmath>

#include "sim/collide/body_collider.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
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

// A half disc with a hollow waist, drawn with the waist up.
Panel half_disc_skirt(double waist_radius, double hem_radius) {
    Panel skirt;
    skirt.name = "skirt";
    skirt.vertices = {{-hem_radius, 0}, {hem_radius, 0}, {waist_radius, 0}, {-waist_radius, 0}};
    const auto arc = [](int start, double radius, bool turns_right) {
        return OutlineEdge{
            .start = start, .end = start + 1, .kind = CurveKind::Arc, .arc_radius = radius, .turns_right = turns_right};
    };
    skirt.edges = {
        arc(0, hem_radius, false), {.start = 1, .end = 2}, arc(2, waist_radius, true), {.start = 3, .end = 0}};
    return skirt;
}

TEST(ArrangePattern, bends_a_skirt_that_is_half_a_disc_to_a_cone_round_the_waist) {
    Pattern pattern;
    pattern.panels = {half_disc_skirt(0.28, 0.75)};
    pattern.seams = {{{0, 1}, {0, 3}}};
    arrange_pattern(pattern, mannequin());
    const Panel& skirt = pattern.panels[0];
    ASSERT_TRUE(skirt.wrap_cone);
    const BodyCollider body(mannequin());
    for (const double t : {0.02, 0.25, 0.5, 0.75, 0.98}) {
        const Vec3d waist = skirt.place(outline_point(skirt, skirt.edges[2], t));
        const Vec3d hem = skirt.place(outline_point(skirt, skirt.edges[0], 1 - t));
        EXPECT_GT(body.contact(waist.cast<float>()).distance, 0.01F) << t;
        EXPECT_LT(hem.y(), waist.y() - 0.2) << t;
        EXPECT_NEAR(waist.y(), skirt.place(outline_point(skirt, skirt.edges[2], 0.5)).y(), 1e-9) << t;
    }
    const Vec3d front = skirt.place(outline_point(skirt, skirt.edges[0], 0.5));
    EXPECT_GT(front.z(), 0.3) << "its middle is before the body";
    EXPECT_NEAR(front.x(), 0, 0.02);
    const Vec3d end = skirt.place({0.28, 0}), other = skirt.place({-0.28, 0});
    EXPECT_LT(end.z(), 0) << "and its ends are behind it";
    EXPECT_LT(other.z(), 0);
    EXPECT_LT((end - other).norm(), 0.35);
}

TEST(ArrangePattern, turns_a_half_disc_that_was_drawn_hem_up_or_aside) {
    for (const double drawn : {90.0, 180.0, -120.0}) {  // degrees
        Pattern pattern;
        const double angle = drawn * std::acos(-1) / 180;
        pattern.panels = {mapped_panel(half_disc_skirt(0.28, 0.75), Eigen::Affine2d(Eigen::Rotation2Dd(angle)))};
        pattern.seams = {{{0, 1}, {0, 3}}};
        arrange_pattern(pattern, mannequin());
        const Panel& skirt = pattern.panels[0];
        ASSERT_TRUE(skirt.wrap_cone) << drawn;
        Vec3d last = skirt.place(outline_point(skirt, skirt.edges[0], 0));
        for (int i = 1; i <= 50; ++i) {
            const Vec3d next = skirt.place(outline_point(skirt, skirt.edges[0], i / 50.0));
            EXPECT_LT((next - last).norm(), 0.06) << "the hem is not torn " << drawn << " " << i;
            last = next;
        }
        EXPECT_GT(skirt.place(outline_point(skirt, skirt.edges[0], 0.5)).z(), 0.3) << drawn;
    }
}

TEST(ArrangePattern, starts_a_band_lower_if_it_is_longer_than_the_waist) {
    double last = 10;
    for (const double length : {0.6, 0.75, 0.85, 2.0}) {
        Pattern pattern;
        pattern.panels = {rectangle("waistband", length, 0.04)};
        pattern.seams = {{{0, 1}, {0, 3}}};
        arrange_pattern(pattern, mannequin());
        const double height = middle_of(pattern.panels[0]).y();
        if (length == 0.75) {
            EXPECT_LT(height, last - 0.02);
        }
        EXPECT_LE(height, last) << length;
        last = height;
    }
    EXPECT_GT(last, 0.7) << "not below the hip";
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
