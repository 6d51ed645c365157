// Panels that nobody placed are placed round the body by their names and seams.
#include "sim/place/arrange_pattern.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "sim/collide/body_collider.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/outline.h"
#include "sim/place/panel_cones.h"
#include "sim/place/placement.h"
#include "tests/sim/place/support.h"
#include "tests/support/mannequin.h"
#include "tests/support/polygon.h"

namespace selvedge::sim::test {
namespace {

Vec3d middle_of(const Panel& panel) {
    return panel.place(outline_box(panel).center());
}

// A boxy shirt: front and back sewn at the sides, sleeves sewn to the tops of both.
Pattern shirt() {
    Pattern pattern;
    pattern.panels = {unplaced_rectangle("front", 0.5, 0.6), unplaced_rectangle("back", 0.5, 0.6),
                      unplaced_rectangle("sleeve", 0.4, 0.2), unplaced_rectangle("sleeve_mirrored", 0.4, 0.2)};
    pattern.panels[3].mirror_of = "sleeve";
    // Right edges in two: the upper part is the armhole.
    for (std::size_t p = 0; p < 2; ++p) {
        split_edge(pattern.panels[p], 1, 0.6);
        split_edge(pattern.panels[p], 4, 0.4);
    }
    pattern.seams = {{{0, 1}, {1, 5}}, {{0, 5}, {1, 1}}, {{0, 2}, {2, 2}}, {{0, 4}, {3, 2}}};
    return pattern;
}

// Drawn upside down: its upper edge is sewn to the back.
TEST(ArrangePattern, wraps_collar_stands_round_the_neck_open_before_it) {
    Pattern pattern = shirt();
    pattern.panels.push_back(unplaced_rectangle("collar stand", 0.45, 0.04));
    constexpr int kStand = 4, kTop = 3;  // of the back: its sides are in two
    pattern.seams.push_back({{1, kTop}, {kStand, 2}});
    arrange_pattern(pattern, mannequin());
    const Panel& stand = pattern.panels[kStand];
    EXPECT_GT(stand.wrap_radius, 0.07);
    EXPECT_LT(stand.wrap_radius, 0.12);
    const auto at = [&](int edge, double t) {
        return stand.place(outline_point(stand, stand.edges[static_cast<std::size_t>(edge)], t));
    };
    EXPECT_LT(at(2, 0.5).y(), at(0, 0.5).y());
    EXPECT_LT(at(2, 0.5).z(), at(2, 0).z() - 0.1);
    EXPECT_GT(clearance_of(stand, BodyCollider(mannequin())), 0);
}

// The sides of a sleeve bend, and are drawn as several edges: the cone is that of the lines from end to end.
TEST(TaperingCone, is_that_of_whole_sides_and_mirrors_with_the_panel) {
    Panel sleeve;
    sleeve.vertices = {{0.05, 0}, {0.25, 0}, {0.27, 0.2}, {0.3, 0.4}, {0, 0.4}, {0.01, 0.1}};
    for (int i = 0; i < 6; ++i) sleeve.edges.push_back({.start = i, .end = (i + 1) % 6});
    const auto cone = tapering_cone(sleeve, {4, 5}, {1, 2});
    ASSERT_TRUE(cone);
    EXPECT_NEAR(cone->apex.x(), 0.15, 1e-9);
    EXPECT_NEAR(cone->apex.y(), -0.8, 1e-9);
    EXPECT_LT(cone->sine, 0);
    const Panel image = mapped_panel(sleeve, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    const auto mirrored =
        tapering_cone(image, {mirrored_edge(4, 6), mirrored_edge(5, 6)}, {mirrored_edge(1, 6), mirrored_edge(2, 6)});
    ASSERT_TRUE(mirrored);
    EXPECT_NEAR(mirrored->apex.x(), -0.15, 1e-9);
    EXPECT_NEAR(mirrored->apex.y(), -0.8, 1e-9);
    EXPECT_NEAR(mirrored->sine, cone->sine, 1e-12);
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

TEST(ArrangePattern, turns_a_sleeve_that_is_drawn_along_the_arm_with_its_cap_up) {
    Pattern pattern = shirt();
    pattern.panels[2] = unplaced_rectangle("sleeve", 0.2, 0.4);
    pattern.panels[3] = unplaced_rectangle("sleeve_mirrored", 0.2, 0.4);
    pattern.panels[3].mirror_of = "sleeve";
    pattern.seams[2].second.edge = 1;  // the right side
    pattern.seams[3].second.edge = 3;  // the left side
    arrange_pattern(pattern, mannequin());
    for (const std::size_t p : {2U, 3U}) {
        const Panel& sleeve = pattern.panels[p];
        const auto cap = static_cast<std::size_t>(pattern.seams[p].second.edge), hem = (cap + 2) % 4;
        const auto middle = [&](std::size_t edge) {
            return sleeve.place(outline_point(sleeve, sleeve.edges[edge], 0.5));
        };
        EXPECT_GT(middle(cap).y(), middle(hem).y() + 0.08);
        EXPECT_LT(std::abs(middle(cap).x()), std::abs(middle(hem).x()));
        EXPECT_GE(sleeve.wrap_radius, 0.4 / 6.3);
    }
}

// Halves that meet over the shoulder: hem 0, top seam and underarm, cap 2.
TEST(ArrangePattern, stands_the_front_and_the_back_of_a_sleeve_before_and_behind_the_arm) {
    Pattern pattern = shirt();
    const auto image = [](const Panel& panel) {
        Panel mirrored = mapped_panel(panel, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
        mirrored.mirror_of = panel.name;
        mirrored.name += "_mirrored";
        return mirrored;
    };
    const Panel front = polygon("sleeve_front", {{0, 0}, {0.19, 0}, {0.19, 0.25}, {0, 0.12}});
    const Panel back = polygon("sleeve_back", {{0, 0}, {0.19, 0}, {0.19, 0.12}, {0, 0.25}});
    pattern.panels.resize(2);
    for (const Panel& panel : {front, back, image(front), image(back)}) pattern.panels.push_back(panel);
    constexpr int kFront = 2, kBack = 3, kOther = 4, kOtherBack = 5;
    pattern.seams.resize(2);
    pattern.seams.insert(pattern.seams.end(), {{{kFront, 1}, {kBack, 3}}, {{kFront, 3}, {kBack, 1}}});
    pattern.seams.insert(pattern.seams.end(), {{{kOther, 3}, {kOtherBack, 1}}, {{kOther, 1}, {kOtherBack, 3}}});
    pattern.seams.insert(pattern.seams.end(), {{{0, 2}, {kFront, 2}}, {{1, 4}, {kBack, 2}}});
    pattern.seams.insert(pattern.seams.end(), {{{0, 4}, {kOther, 2}}, {{1, 2}, {kOtherBack, 2}}});
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    for (const int p : {kFront, kOther}) {
        const auto half = static_cast<std::size_t>(p), behind = half + 1;
        EXPECT_GT(middle_of(pattern.panels[half]).z(), middle_of(pattern.panels[behind]).z() + 0.08);
        EXPECT_EQ(arrangement.roles[half].flank, p == kFront ? Flank::Left : Flank::Right);
        EXPECT_EQ(arrangement.roles[behind].flank, arrangement.roles[half].flank);
    }
}

TEST(ArrangePattern, puts_an_upper_sleeve_to_the_shoulder_whichever_half_comes_first) {
    const auto place = [](bool is_upper_first) {
        Pattern pattern = shirt();
        // Hem 0, seam 1, cap 2 and 3, seam 4; hem 0, seam 1, cap 2, seam 3.
        const Panel upper = polygon("topsleeve", {{0, 0}, {0.2, 0}, {0.2, 0.4}, {0.1, 0.5}, {0, 0.4}});
        const Panel under = polygon("undersleeve", {{0, 0}, {0.14, 0}, {0.14, 0.4}, {0, 0.4}});
        pattern.panels.resize(2);
        const int first = is_upper_first ? 2 : 3, second = is_upper_first ? 3 : 2;
        pattern.panels.push_back(is_upper_first ? upper : under);
        pattern.panels.push_back(is_upper_first ? under : upper);
        pattern.seams.resize(2);
        pattern.seams.insert(pattern.seams.end(), {{{first, 1}, {second, 3}}, {{first, 4}, {second, 1}}});
        pattern.seams.insert(pattern.seams.end(), {{{0, 2}, {first, 2}}, {{1, 4}, {second, 2}}});
        for (Panel& panel : pattern.panels) panel.mirror_of.clear();
        arrange_pattern(pattern, mannequin());
        return pattern.panels[static_cast<std::size_t>(first)].translation;
    };
    EXPECT_LT((place(true) - place(false)).norm(), 1e-9);
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

// A skirt of two panels on a closed waistband of that length, m.
Pattern skirt_on_band(double length) {
    Pattern pattern;
    pattern.panels = {unplaced_rectangle("skirt front", length / 2, 0.5),
                      unplaced_rectangle("skirt back", length / 2, 0.5), unplaced_rectangle("waistband", length, 0.04)};
    split_edge(pattern.panels[2], 0, 0.5);
    pattern.seams = {{{0, 1}, {1, 3}}, {{0, 3}, {1, 1}}, {{2, 0}, {0, 2}}, {{2, 1}, {1, 2}}, {{2, 2}, {2, 4}}};
    return pattern;
}

TEST(ArrangePattern, gathers_a_closed_waistband_that_is_as_wide_as_the_hips_with_an_elastic) {
    Pattern pattern = skirt_on_band(1.2);
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    const Panel& band = pattern.panels[2];
    for (const std::size_t edge : {0U, 1U, 3U}) {
        ASSERT_TRUE(band.edges[edge].elastic) << edge;
        EXPECT_LT(band.edges[edge].elastic->share * 1.2, 0.75) << "m, less than the waist";
    }
    EXPECT_FALSE(band.edges[2].elastic || band.edges[4].elastic) << "its ends";
    const Fabric fabric = find_fabric("");
    const double weight = 9.81 * fabric.area_density * 1.2 * 0.54;  // N
    const double tension = band.edges[3].elastic->stiffness * (1 / 0.9 - 1);
    EXPECT_NEAR(2 * std::numbers::pi * tension * fabric.friction, 1.25 * weight, 1e-3)
        << "each ring holds it by friction";
    ASSERT_EQ(arrangement.notes.size(), 1U);
    EXPECT_NE(arrangement.notes[0].find("elastic"), std::string::npos) << arrangement.notes[0];
}

TEST(ArrangePattern, has_no_elastic_in_a_waistband_that_the_hips_hold_or_that_opens) {
    Pattern narrow = skirt_on_band(0.8), open = skirt_on_band(1.2);
    open.seams.pop_back();
    for (Pattern pattern : {narrow, open}) {
        arrange_pattern(pattern, mannequin());
        for (const OutlineEdge& edge : pattern.panels[2].edges) EXPECT_FALSE(edge.elastic);
    }
}

// Fronts of wide legs, whose hems would stand far beside the feet: hem 0, inseam 1, crotch 2, waist 3, outseam 4.
Pattern wide_legs() {
    Pattern pattern;
    Panel front = unplaced_rectangle("pants front", 0.5, 1);
    front.vertices = {{0.1, 0}, {0.3, 0}, {0.5, 0.72}, {0.4, 1}, {0, 1}};
    front.edges.clear();
    for (int i = 0; i < 5; ++i) front.edges.push_back({.start = i, .end = (i + 1) % 5});
    Panel image = mapped_panel(front, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    image.name = "pants front_mirrored";
    image.mirror_of = front.name;
    pattern.panels = {front, image};
    pattern.seams = {{{0, 2}, {1, mirrored_edge(2, 5)}}};
    return pattern;
}

TEST(ArrangePattern, leans_trouser_legs_so_that_their_hems_stand_before_the_feet) {
    Pattern pattern = wide_legs();
    arrange_pattern(pattern, mannequin());
    const BodyLimbs limbs = find_limbs(mannequin());
    for (const Panel& panel : pattern.panels) {
        const double hem = panel.place(Vec2d(panel.vertices[0] + panel.vertices[1]) / 2).x();
        const LimbKind leg = hem > 0 ? LimbKind::LeftLeg : LimbKind::RightLeg;
        EXPECT_NEAR(hem, limbs[leg].joints.back().centre.x(), 0.03) << panel.name;
    }
}

// Trousers that wrap, of one panel a leg: hem 0, sides 1 and 6, waist 2 and 5, crotch 3 and 4, wider on the right.
TEST(ArrangePattern, stands_a_leg_of_one_panel_round_the_leg_its_crotch_between_both) {
    Pattern pattern;
    Panel pants = unplaced_rectangle("pants", 0.9, 0.9);
    pants.vertices = {{0, 0}, {0.9, 0}, {0.9, 0.9}, {0.55, 0.9}, {0.46, 0.6}, {0.38, 0.9}, {0, 0.9}};
    pants.edges.clear();
    for (int i = 0; i < 7; ++i) pants.edges.push_back({.start = i, .end = (i + 1) % 7});
    Panel image = mapped_panel(pants, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    image.name = "pants_mirrored";
    image.mirror_of = pants.name;
    pattern.panels = {pants, image};
    pattern.seams = {{{0, 1}, {0, 6}}, {{1, 1}, {1, 6}}, {{0, 3}, {1, 4}}, {{0, 4}, {1, 3}}};
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    const Panel &right = pattern.panels[0], &left = pattern.panels[1];
    EXPECT_EQ(arrangement.roles[0].flank, Flank::Right) << "its back is on the right";
    EXPECT_EQ(arrangement.roles[1].flank, Flank::Left);
    EXPECT_LT(std::abs(right.place({0.46, 0.6}).x()), 0.02);
    EXPECT_NEAR(right.place({0.46, 0.6}).y(), left.place({-0.46, 0.6}).y(), 1e-9);
    EXPECT_LT(right.place({0, 0.3}).x(), -0.2);
    EXPECT_GT(left.place({0, 0.3}).x(), 0.2);
    EXPECT_GT(right.place({0.2, 0.3}).z(), right.place({0.7, 0.3}).z() + 0.1);
    EXPECT_TRUE(right.edges[2].elastic && right.edges[5].elastic) << "1.5 m round the waist";
    EXPECT_FALSE(right.edges[0].elastic);
}

// Four gores, the first in the middle: their sides are sewn to each other all round.
TEST(ArrangePattern, puts_panels_side_by_side_in_a_ring_round_the_waist) {
    Pattern pattern;
    for (const char* name : {"gore1", "gore2", "gore3", "gore4"})
        pattern.panels.push_back(unplaced_rectangle(name, 0.2, 0.25));
    pattern.seams = {{{0, 1}, {1, 3}}, {{1, 1}, {2, 3}}, {{2, 1}, {3, 3}}, {{3, 1}, {0, 3}}};
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    EXPECT_TRUE(arrangement.notes.empty()) << "none is placed by guess";
    Vec3d centre = Vec3d::Zero();
    for (const Panel& panel : pattern.panels) centre += middle_of(panel) / 4;
    std::vector<double> turns;
    for (const Panel& panel : pattern.panels) {
        EXPECT_GT(panel.wrap_radius, 0.1);
        const Vec3d middle = middle_of(panel) - centre;
        turns.push_back(std::atan2(middle.x(), middle.z()));
        EXPECT_NEAR(middle.y(), 0, 1e-9);
    }
    for (std::size_t p = 0; p < 4; ++p) {
        const double step = std::remainder(turns[(p + 1) % 4] - turns[p], 2 * std::numbers::pi);
        EXPECT_NEAR(step, std::numbers::pi / 2, 1e-6)
            << p << ": to the left of the body, seen from outside to the right";
    }
}

TEST(ArrangePattern, puts_a_cuff_of_trousers_round_the_ankle_above_the_foot) {
    Pattern pattern = wide_legs();
    pattern.panels.push_back(unplaced_rectangle("cuff", 0.36, 0.06));
    pattern.seams.push_back({{2, 2}, {0, 0}});
    pattern.seams.push_back({{2, 1}, {2, 3}});
    arrange_pattern(pattern, mannequin());
    const Panel& cuff = pattern.panels[2];
    const bool is_left = pattern.panels[0].place(pattern.panels[0].vertices[0]).x() > 0;
    const Vec3d ankle = find_limbs(mannequin())[is_left ? LimbKind::LeftLeg : LimbKind::RightLeg].joints[2].centre;
    Vec3d middle = Vec3d::Zero();
    for (int i = 0; i < 36; ++i) middle += cuff.place({0.36 * (i + 0.5) / 36, 0}) / 36;
    EXPECT_LT((middle - ankle).cwiseProduct(Vec3d(1, 0, 1)).norm(), 0.01);
    EXPECT_GE(middle.y(), ankle.y() - 1e-9);
    EXPECT_LT(middle.y(), ankle.y() + 0.1);
    EXPECT_EQ(cuff.label, "leg");
}

TEST(ArrangePattern, starts_a_band_lower_if_it_is_longer_than_the_waist) {
    double last = 10;
    for (const double length : {0.6, 0.75, 0.85, 2.0}) {
        Pattern pattern;
        pattern.panels = {unplaced_rectangle("waistband", length, 0.04)};
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
    pattern.panels.push_back(unplaced_rectangle("thing", 0.2, 0.2));
    pattern.panels.push_back(unplaced_rectangle("yoke", 0.5, 0.1));
    pattern.seams.push_back({{0, 3}, {5, 0}});  // on the front's top
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    ASSERT_EQ(arrangement.notes.size(), 1U);
    EXPECT_EQ(arrangement.notes[0].substr(0, 5), "thing");
    const Vec3d yoke = middle_of(pattern.panels[5]), front = middle_of(pattern.panels[0]);
    EXPECT_NEAR(yoke.y() - front.y(), 0.35, 1e-9);
    EXPECT_NEAR(yoke.z(), front.z(), 1e-9);
}

// A shirt with long sleeves that narrow to the wrist, and cuffs that are drawn along the cloth.
Pattern long_sleeved() {
    Pattern pattern = shirt();
    pattern.seams.resize(2);
    // Hem 0, underarm 1, cap 2, underarm 3.
    pattern.panels[2] = polygon("sleeve", {{-0.11, 0}, {0.11, 0}, {0.19, 0.55}, {-0.19, 0.55}});
    pattern.panels[3] = polygon("sleeve_mirrored", {{-0.11, 0}, {0.11, 0}, {0.19, 0.55}, {-0.19, 0.55}});
    pattern.panels[3].mirror_of = "sleeve";
    pattern.panels.push_back(unplaced_rectangle("cuff", 0.08, 0.2));
    for (const int sleeve : {2, 3}) pattern.seams.push_back({{sleeve, 1}, {sleeve, 3}});
    pattern.seams.push_back({{0, 2}, {2, 2}});
    pattern.seams.push_back({{0, 4}, {3, 2}});
    pattern.seams.push_back({{4, 0}, {4, 2}});
    pattern.seams.push_back({{2, 0}, {4, 1}});
    return pattern;
}

TEST(ArrangePattern, bends_a_sleeve_that_narrows_to_a_cone_clear_of_the_arm) {
    Pattern pattern = long_sleeved();
    arrange_pattern(pattern, mannequin());
    const BodyCollider body(mannequin());
    for (const int p : {2, 3}) {
        const Panel& sleeve = pattern.panels[static_cast<std::size_t>(p)];
        ASSERT_TRUE(sleeve.wrap_cone);
        EXPECT_LT(sleeve.wrap_cone->sine, 0) << "it opens upwards";
        // Its hem goes round the arm, and not through it.
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Vec3d at = sleeve.place(outline_point(sleeve, sleeve.edges[0], t));
            EXPECT_GT(body.contact(at.cast<float>()).distance, 0.002F) << p << " " << t;
        }
        const Vec3d one = sleeve.place(sleeve.vertices[0]), other = sleeve.place(sleeve.vertices[1]);
        // Halfway down, the arm is between the cloth outside of it and the edges inside.
        const Vec3d edges = sleeve.place(outline_point(sleeve, sleeve.edges[1], 0.5)) +
                            sleeve.place(outline_point(sleeve, sleeve.edges[3], 0.5));
        const Vec3d inside = (sleeve.place({0, 0.275}) + edges / 2) / 2;
        EXPECT_LT(body.contact(inside.cast<float>()).distance, 0) << p;
        EXPECT_LT((one - other).norm(), 0.11) << p;
    }
}

TEST(ArrangePattern, turns_a_cuff_level_and_puts_it_round_the_arm_of_its_sleeve) {
    Pattern pattern = long_sleeved();
    const Arrangement arrangement = arrange_pattern(pattern, mannequin());
    const Panel& cuff = pattern.panels[4];
    const Eigen::AlignedBox2d box = outline_box(cuff);
    EXPECT_NEAR(box.sizes().x(), 0.2, 1e-9) << "it was drawn upright";
    // The edge that is sewn to the sleeve is the upper one, nearer to the shoulder.
    const Vec3d upper = cuff.place(outline_point(cuff, cuff.edges[1], 0.5));
    const Vec3d lower = cuff.place(outline_point(cuff, cuff.edges[3], 0.5));
    EXPECT_GT(upper.y(), lower.y() + 0.03);
    EXPECT_EQ(arrangement.roles[2].flank, Flank::Left);
    EXPECT_GT(upper.x(), 0.3);
    EXPECT_NEAR((cuff.place(cuff.vertices[1]) - cuff.place(cuff.vertices[0])).norm(), 0, 0.16);
}

// Of a sleeve that ends beyond the wrist, the cuff lies beyond its hem: within the sleeve, it would be sewn inside out.
TEST(ArrangePattern, puts_a_cuff_beyond_the_hem_of_a_sleeve_that_is_longer_than_the_arm) {
    Pattern pattern = long_sleeved();
    for (const std::size_t p : {2U, 3U}) {
        for (const std::size_t v : {2U, 3U}) pattern.panels[p].vertices[v].y() = 0.7;
    }
    arrange_pattern(pattern, mannequin());
    const Panel &sleeve = pattern.panels[2], &cuff = pattern.panels[4];
    const double hem = sleeve.place(outline_point(sleeve, sleeve.edges[0], 0.5)).y();
    EXPECT_LT(cuff.place(outline_point(cuff, cuff.edges[1], 0.5)).y(), hem + 0.01);
}

TEST(ArrangePattern, puts_a_waistband_of_a_bodice_at_its_hem_with_its_ends_where_the_seam_ends) {
    Pattern pattern = shirt();
    pattern.panels.push_back(unplaced_rectangle("waistband", 1.0, 0.08));
    split_edge(pattern.panels[4], 2, 0.5);
    // From the wearer's left side over the front: the first half of the upper edge to the front.
    pattern.seams.push_back({{0, 0}, {4, 2}});
    pattern.seams.push_back({{1, 0}, {4, 3}});
    arrange_pattern(pattern, mannequin());
    const Panel& band = pattern.panels[4];
    const auto middle_of_edge = [&](std::size_t p, std::size_t e) {
        return pattern.panels[p].place(outline_point(pattern.panels[p], pattern.panels[p].edges[e], 0.5));
    };
    EXPECT_NEAR(middle_of_edge(4, 2).y(), middle_of_edge(0, 0).y(), 0.02);
    EXPECT_GT(middle_of_edge(4, 2).z(), 0.05) << "before the body";
    EXPECT_LT(middle_of_edge(4, 3).z(), -0.05) << "behind it";
    EXPECT_GT(std::abs(band.place({0, 0}).x()), 0.1) << "its ends are at the side";
}

TEST(ArrangePattern, stands_the_sides_of_a_hood_beside_the_head_and_bends_the_strip_over_it) {
    Pattern pattern;
    // Neck 0, back 1, top 2, face 3; the image has its back 3.
    pattern.panels = {unplaced_rectangle("hoodSide", 0.25, 0.35), unplaced_rectangle("hoodSide_mirrored", 0.25, 0.35),
                      unplaced_rectangle("hoodCenter", 0.35, 0.08)};
    pattern.panels[1].mirror_of = "hoodSide";
    pattern.seams = {{{0, 1}, {2, 0}}, {{1, 3}, {2, 2}}};
    arrange_pattern(pattern, mannequin());
    EXPECT_GT(middle_of(pattern.panels[0]).x(), 0.1);
    EXPECT_LT(middle_of(pattern.panels[1]).x(), -0.1);
    EXPECT_LT(pattern.panels[0].place({0.25, 0.1}).z(), pattern.panels[0].place({0, 0.1}).z()) << "its back is behind";
    EXPECT_LT(pattern.panels[1].place({0, 0.1}).z(), pattern.panels[1].place({0.25, 0.1}).z());
    EXPECT_GT(pattern.panels[2].wrap_radius, 0);
    EXPECT_GT(pattern.panels[2].place({0.1, 0}).x(), pattern.panels[2].place({0.1, 0.08}).x())
        << "left edge, left side";
}

TEST(ArrangePattern, lifts_a_high_necked_front_until_its_shoulders_pass_over_the_body) {
    Pattern pattern;
    Panel front;
    front.name = "front";
    front.vertices = {{-0.2, 0},    {0.2, 0},      {0.2, 0.4},    {0.16, 0.42},  {0.06, 0.44},
                      {0.05, 0.55}, {-0.05, 0.55}, {-0.06, 0.44}, {-0.16, 0.42}, {-0.2, 0.4}};
    for (int i = 0; i < 10; ++i) front.edges.push_back({.start = i, .end = (i + 1) % 10});
    Panel back = front;
    back.name = "back";
    pattern.panels = {front, back};
    pattern.seams = {{{0, 3}, {1, 7}}, {{0, 7}, {1, 3}}};
    arrange_pattern(pattern, mannequin());
    const Panel& placed = pattern.panels[0];
    for (const double t : {0.0, 0.5, 1.0}) {
        const Vec3d at = placed.place(outline_point(placed, placed.edges[3], t));
        double shoulder = 0;
        for (const Vec3d& p : mannequin().x) {
            const bool is_head = std::abs(p.x()) < 0.055;
            if (!is_head && std::abs(p.x() - at.x()) < 0.01) shoulder = std::max(shoulder, p.y());
        }
        if (at.x() <= 0.09) continue;  // beside the neck
        EXPECT_GT(at.y(), shoulder) << t;
    }
}

TEST(ArrangePattern, lets_a_yoke_go_on_from_the_back_though_single_edges_of_it_are_short) {
    Pattern pattern;
    pattern.panels = {unplaced_rectangle("front_right", 0.2, 0.6), unplaced_rectangle("front_left", 0.2, 0.6),
                      unplaced_rectangle("back", 0.4, 0.6), unplaced_rectangle("yoke", 0.4, 0.1)};
    Panel& back = pattern.panels[2];
    Panel& yoke = pattern.panels[3];
    split_edge(yoke, 2, 0.5);
    for (const double t : {2.0 / 3, 0.5}) {
        split_edge(yoke, 0, t);
        split_edge(back, 2, t);
    }
    // Yoke: bottom 0, 1, 2, right 3, top 4, 5; back: top 2, 3, 4.
    pattern.seams = {{{2, 4}, {3, 0}}, {{2, 3}, {3, 1}}, {{2, 2}, {3, 2}}, {{0, 2}, {3, 4}}, {{1, 2}, {3, 5}}};
    arrange_pattern(pattern, mannequin());
    EXPECT_LT(middle_of(pattern.panels[3]).z(), 0);
}

}  // namespace
}  // namespace selvedge::sim::test
