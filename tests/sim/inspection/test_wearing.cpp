// Whether a garment is worn as it was placed, on mannequins and small tubes.
#include "sim/inspection/wearing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth_penetration.h"
#include "sim/collide/collider.h"
#include "sim/collide/surface_bvh.h"
#include "sim/inspection/missed_limbs.h"
#include "sim/inspection/worn_garment.h"
#include "sim/mesh/sew.h"
#include "sim/place/limbs.h"
#include "sim/place/shoulder_top.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"
#include "tests/support/notes.h"
#include "tests/support/posed_body.h"

namespace selvedge::sim::test {
namespace {

const Body& mannequin_in_t_pose() {
    static const Body body = shapes::in_t_pose(mannequin());
    return body;
}

std::string list(const DressReport& report) {
    std::string text;
    for (const DressFault& fault : report.faults) text += fault.kind + ": " + fault.place + "\n";
    return text;
}

using Move = std::function<Vec3d(const Vec3d&)>;

// The report on a garment whose vertices, down to a level, ended where `move` brought them from where they were placed.
DressReport report_on(const GarmentMesh& unsewn, const Move& move, const Body& wearer, int level = 0,
                      const Fabric& fabric = {}) {
    GarmentMesh sewn = unsewn;
    merge_seams(sewn);
    Cloth cloth = make_cloth(sewn, std::vector<Fabric>(sewn.panel_names.size(), fabric), {.max_level = level});
    std::vector<MinimumLevelDisc> everywhere;
    for (std::uint16_t p = 0; p < sewn.panel_names.size(); ++p)
        everywhere.push_back({.panel = p, .radius = 10, .level = level});
    adapt_cloth(cloth, NoBody(), {.minimum_levels = everywhere, .max_level = level});
    for (const VertexId v : cloth.mesh.leaf_vertices())
        cloth.x[v.value].head<3>() = move(cloth.x[v.value].head<3>().cast<double>()).cast<float>();
    DressReport report;
    report.contact.faces_in_body = find_penetration(cloth, SurfaceBvh(wearer), {.depth = 0.0005F}).faces;
    const MeasuredBody designed_for(mannequin()), worn_by(wearer);
    Pattern unlabelled;
    unlabelled.panels.resize(sewn.panel_names.size());
    WearingCheck(sewn, {.unsewn = unsewn, .pattern = &unlabelled, .body = &designed_for}, worn_by)
        .validate(cloth, report);
    return report;
}

DressReport report_on(const Pattern& pattern, const Move& move, const Body& wearer, const Fabric& fabric = {}) {
    return report_on(assemble(pattern), move, wearer, 0, fabric);
}

Pattern skirt() {
    return tube(0.5, 0.5, 0.5, 0.2);
}

Pattern narrow_skirt() {
    return tube(0.3, 0.5, 0.5, 0.2);
}

// Round the left forearm, front and back of it.
Pattern sleeve() {
    Pattern pattern = tube(0.2, 0.2, 0, 0.1);
    const std::vector<LimbJoint> joints = find_limbs(mannequin())[LimbKind::LeftArm].joints;
    const Vec3d middle = (joints[1].centre + joints[2].centre) / 2, up = (joints[1].centre - joints[2].centre);
    const Eigen::AngleAxisd turn(std::atan2(-up.x(), up.y()), Vec3d::UnitZ());
    for (Panel& panel : pattern.panels) {
        const double side = panel.translation.z();
        panel.rotation = turn.toRotationMatrix();
        panel.translation = middle - turn * Vec3d(0, 0.1, 0) + Vec3d(0, 0, side);
    }
    return pattern;
}

Vec3d stays(const Vec3d& x) {
    return x;
}

TEST(Wearing, of_a_garment_where_it_was_placed_has_no_fault) {
    for (const Pattern& pattern : {skirt(), sleeve()}) {
        const DressReport report = report_on(pattern, stays, mannequin());
        EXPECT_EQ(list(report), "");
        EXPECT_TRUE(report.notes.empty());
    }
}

TEST(Wearing, of_a_garment_that_settled_by_a_few_centimetres_has_no_fault) {
    const DressReport report = report_on(
        skirt(), [](const Vec3d& x) { return Vec3d(x - Vec3d(0, 0.06, 0)); }, mannequin());
    EXPECT_EQ(list(report), "");
    EXPECT_TRUE(has_note(report.notes, "the waist of 'front' lies 6 cm lower than it was placed"));
    const auto less = [](const Vec3d& x) { return Vec3d(x - Vec3d(0, 0.03, 0)); };
    EXPECT_TRUE(report_on(skirt(), less, mannequin()).notes.empty());
}

TEST(Wearing, finds_a_skirt_at_the_ankles) {
    const DressReport report = report_on(
        narrow_skirt(), [](const Vec3d& x) { return Vec3d(x.x(), 0.05 + 0.2 * (x.y() - 0.5), x.z()); }, mannequin());
    ASSERT_EQ(report.faults.size(), 3U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "displaced");
    EXPECT_NE(report.faults[0].place.find("'front' lies 65 cm lower than it was placed"), std::string::npos)
        << report.faults[0].place;
    EXPECT_NEAR(report.faults[0].value, 0.65, 0.03);
    EXPECT_EQ(report.faults[2].kind, "displaced");
    EXPECT_EQ(report.faults[2].place, "the waist of 'front' lies 85 cm lower than it was placed, below the hips");
}

// Its panels are not also said to be displaced, or on the floor: that follows.
TEST(Wearing, of_a_skirt_that_is_too_large_says_that_it_does_not_fit) {
    const auto slips = [](const Vec3d& x) { return Vec3d(x.x(), 0.004 + 0.4 * (x.y() - 0.5), x.z()); };
    const DressReport report = report_on(skirt(), slips, mannequin());
    ASSERT_EQ(report.faults.size(), 1U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "does_not_fit");
    EXPECT_NE(report.faults[0].place.find("too large above the hips by"), std::string::npos) << list(report);
    EXPECT_GT(report.faults[0].value, 0.2) << "1 m long";
}

// Each panel still covers most of the heights over which it was placed.
TEST(Wearing, finds_a_strapless_dress_whose_upper_edge_slipped_below_the_bust) {
    const double chest = find_limbs(mannequin()).torso[2].centre.y();
    const Pattern dress = tube(0.36, 0.7, chest + 0.02 - 0.7, 0.2);
    const auto lower = [](double by) { return [by](const Vec3d& x) { return Vec3d(x - Vec3d(0, by, 0)); }; };
    EXPECT_EQ(list(report_on(dress, lower(0.01), mannequin())), "");
    EXPECT_EQ(list(report_on(dress, lower(0.03), mannequin())), "");  // settled by less than a waistband's width
    const DressReport slipped = report_on(dress, lower(0.07), mannequin());
    ASSERT_EQ(slipped.faults.size(), 1U) << list(slipped);
    EXPECT_EQ(slipped.faults[0].kind, "displaced") << "72 cm long, less than the body is round";
    EXPECT_NEAR(slipped.faults[0].value, 0.07, 1e-3);
    EXPECT_EQ(slipped.faults[0].place, "the upper edge of 'front' lies 7 cm lower than it was placed, below the chest");
}

// It was placed under the widest level of the bust, but nearer to that than to the waist.
TEST(Wearing, finds_a_strapless_dress_that_slipped_to_the_waist_when_it_was_placed_below_the_widest_bust) {
    const std::vector<LimbJoint> torso = find_limbs(mannequin()).torso;
    const double waist = torso[1].centre.y(), chest = torso[2].centre.y(), top = chest - 0.02;
    const auto lower = [](double by) { return [by](const Vec3d& x) { return Vec3d(x - Vec3d(0, by, 0)); }; };
    const Pattern wide = tube(0.6, 0.3, top - 0.3, 0.2), narrow = tube(0.36, 0.3, top - 0.3, 0.2);
    EXPECT_EQ(list(report_on(wide, lower((chest - waist) / 2 - 0.03), mannequin())), "") << "it settled on the bust";
    const DressReport slipped = report_on(wide, lower(top - waist), mannequin());
    ASSERT_EQ(slipped.faults.size(), 1U) << list(slipped);
    EXPECT_EQ(slipped.faults[0].kind, "does_not_fit") << "1.2 m long, more than the bust is round";
    EXPECT_NE(slipped.faults[0].place.find("too large above the chest by"), std::string::npos) << list(slipped);
    const DressReport pulled = report_on(narrow, lower(top - waist), mannequin());
    ASSERT_FALSE(pulled.faults.empty());
    EXPECT_EQ(pulled.faults.back().kind, "displaced") << "72 cm long, less than the bust is round";
}

TEST(Wearing, does_not_take_the_hem_of_a_shirt_for_a_waist) {
    const double hips = find_limbs(mannequin()).torso[0].centre.y();
    const auto longer = [&](const Vec3d& x) {  // by 8 cm at the hem, which was placed at the hips
        return Vec3d(x - Vec3d(0, 0.08 * std::clamp((1.1 - x.y()) / (1.1 - hips), 0.0, 1.0), 0));
    };
    EXPECT_EQ(list(report_on(shipped("tshirt"), longer, mannequin())), "");
}

// It weighs 4.9 N in both fabrics.
TEST(Wearing, of_an_edge_that_slipped_names_cloth_that_is_too_stretchy_to_carry_the_garment) {
    const double chest = find_limbs(mannequin()).torso[2].centre.y();
    const Pattern dress = tube(0.36, 0.7, chest + 0.02 - 0.7, 0.2);
    const auto slips = [](const Vec3d& x) { return Vec3d(x - Vec3d(0, 0.07, 0)); };
    const Fabric stiff{.area_density = 1};
    const Fabric weak{.area_density = 1, .stretch_warp = 6, .stretch_weft = 6, .shear = 3};
    ASSERT_EQ(report_on(dress, slips, mannequin(), stiff).faults.size(), 1U);
    EXPECT_EQ(report_on(dress, slips, mannequin(), stiff).faults[0].kind, "displaced");
    EXPECT_EQ(list(report_on(dress, stays, mannequin(), weak)), "") << "it did not slide";
    const DressReport slipped = report_on(dress, slips, mannequin(), weak);
    ASSERT_EQ(slipped.faults.size(), 1U) << list(slipped);
    EXPECT_EQ(slipped.faults[0].kind, "does_not_fit");
    EXPECT_NE(slipped.faults[0].place.find("too stretchy above the chest"), std::string::npos) << list(slipped);
    EXPECT_NE(slipped.faults[0].place.find("of the garment's 4.9 N, and it lies 7 cm lower"), std::string::npos)
        << list(slipped);
    EXPECT_GT(slipped.faults[0].value, 4);
}

// GarmentCode places long skirts below the bodice that they are sewn to.
TEST(Wearing, lets_seams_pull_a_panel_to_its_neighbour) {
    Pattern pattern = narrow_skirt();
    pattern.panels.push_back(rectangle("bodice", {.width = 0.3, .height = 0.3, .y = 1.0, .z = 0.2}));
    pattern.seams.push_back({.first = {0, 2}, .second = {2, 0}});
    for (const int p : {0, 1}) pattern.panels[std::size_t(p)].translation.y() -= 0.4;
    const auto pulled_up = [](const Vec3d& x) { return x.y() < 0.9 ? Vec3d(x + Vec3d(0, 0.4, 0)) : x; };
    EXPECT_EQ(list(report_on(pattern, pulled_up, mannequin())), "");
    const auto fallen = [](const Vec3d& x) { return Vec3d(x.x(), 0.03 + 0.1 * x.y(), x.z()); };
    EXPECT_NE(list(report_on(pattern, fallen, mannequin())), "");
}

// As GarmentCode places dresses: the bodice below the shoulders, and a waistband far below the bodice.
TEST(Wearing, expects_a_waistband_where_it_hangs_from_the_shoulders) {
    constexpr double kLow = 0.06, kGap = 0.10;  // m
    const double top = find_shoulder_top(MeasuredBody(mannequin())).value(), waist = top - 0.45;
    Pattern pattern = tabard(0.3, 0.45, waist - kLow, 0.2);
    const Pattern band = tube(0.3, 0.06, waist - kLow - kGap - 0.06, 0.2);
    pattern.panels.insert(pattern.panels.end(), band.panels.begin(), band.panels.end());
    pattern.seams.insert(pattern.seams.end(), {{.first = {2, 1}, .second = {3, 3}},
                                               {.first = {2, 3}, .second = {3, 1}},
                                               {.first = {0, 0}, .second = {2, 2}},
                                               {.first = {1, 0}, .second = {3, 2}}});
    const auto hangs = [&](const Vec3d& x) {
        return Vec3d(x + Vec3d(0, x.y() < waist - kLow - kGap / 2 ? kLow + kGap : kLow, 0));
    };
    EXPECT_EQ(list(report_on(pattern, hangs, mannequin())).find("displaced"), std::string::npos);
    const auto pushed_up = [&](const Vec3d& x) { return Vec3d(hangs(x) + Vec3d(0, 0.25, 0)); };
    EXPECT_NE(list(report_on(pattern, pushed_up, mannequin())).find("displaced"), std::string::npos);
}

// Its front and back stand before and behind one hand; it hangs beside it.
TEST(Wearing, does_not_mean_an_arm_for_the_hem_of_a_wide_skirt) {
    Pattern wide = tube(0.4, 0.5, 0.5, 0.2);
    for (Panel& panel : wide.panels) panel.vertices[panel.name == "front" ? 1 : 0].x() *= 6;
    const auto hangs = [](const Vec3d& x) { return Vec3d(std::clamp(x.x(), -0.3, 0.3), x.y(), x.z()); };
    EXPECT_EQ(list(report_on(wide, hangs, mannequin())), "");
}

TEST(MeantOpenings, of_a_skirt_have_the_arms_above_its_waist_when_the_body_has_no_head) {
    BodyLimbs headless = find_limbs(mannequin());
    headless.limbs[index_of(LimbKind::Head)] = {};
    const GarmentMesh unsewn = assemble(skirt());
    const WornGarment placed = undraped(unsewn, unsewn.x);
    const std::vector<std::size_t> parts = garment_parts(placed, vertices_by_panel(unsewn));
    const MeantOpenings meant = find_meant_openings(placed, parts, {true, true}, headless);
    ASSERT_EQ(meant.openings.size(), 2U);
    for (const LimbSet& through : meant.limbs.through)
        EXPECT_NE(through[index_of(LimbKind::LeftArm)], through[index_of(LimbKind::LeftLeg)]) << "by one or the other";
}

// It is placed at the hips, and hangs below them.
TEST(Wearing, does_not_take_the_hem_of_a_short_dress_without_straps_for_a_waist) {
    const std::vector<LimbJoint> torso = find_limbs(mannequin()).torso;
    const double top = torso[2].centre.y() + 0.02, hips = torso[0].centre.y();
    const Pattern dress = tube(0.4, top - hips - 0.02, hips + 0.02, 0.2);
    const auto longer = [&](const Vec3d& x) { return Vec3d(x - Vec3d(0, 0.15 * (top - x.y()) / (top - hips), 0)); };
    EXPECT_EQ(list(report_on(dress, longer, mannequin())), "");
}

// A long skirt still covers half of its heights, but it is no place to which the bodice was drawn.
TEST(Wearing, finds_a_bodice_that_fell_with_its_long_skirt) {
    Pattern pattern = tube(0.5, 0.7, 0.2, 0.2);
    pattern.panels.push_back(rectangle("bodice", {.width = 0.5, .height = 0.3, .y = 0.9, .z = 0.2}));
    pattern.seams.push_back({.first = {0, 2}, .second = {2, 0}});
    const auto fallen = [](const Vec3d& x) { return Vec3d(x - Vec3d(0, 0.19, 0)); };
    const DressReport report = report_on(pattern, fallen, mannequin());
    ASSERT_EQ(report.faults.size(), 1U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "displaced");
    EXPECT_NE(report.faults[0].place.find("'bodice' lies 19 cm lower"), std::string::npos) << list(report);
}

// A bodice to 0.85 m, and a skirt below it.
Pattern dress_in_four_panels() {
    Pattern pattern = tube(0.5, 0.2, 0.85, 0.2);
    const Pattern skirt = tube(0.5, 0.55, 0.3, 0.2);
    pattern.panels.insert(pattern.panels.end(), skirt.panels.begin(), skirt.panels.end());
    pattern.panels[2].name = "skirt";
    pattern.panels[3].name = "skirt back";
    pattern.seams.insert(pattern.seams.end(), {{.first = {2, 1}, .second = {3, 3}},
                                               {.first = {2, 3}, .second = {3, 1}},
                                               {.first = {0, 0}, .second = {2, 2}},
                                               {.first = {1, 0}, .second = {3, 2}}});
    return pattern;
}

TEST(Wearing, finds_a_skirt_that_lies_bunched_above_the_hips_though_its_bodice_is_at_its_place) {
    const Pattern pattern = dress_in_four_panels();
    EXPECT_EQ(list(report_on(pattern, stays, mannequin())), "");
    const auto bunched = [](const Vec3d& x) {
        return x.y() < 0.85 ? Vec3d(x.x(), 0.85 - 0.2 * (0.85 - x.y()), x.z()) : x;
    };
    const DressReport report = report_on(pattern, bunched, mannequin());
    ASSERT_EQ(report.faults.size(), 2U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "displaced");
    EXPECT_NE(report.faults[0].place.find("'skirt' lies 22 cm higher"), std::string::npos) << list(report);
}

// Of a child's size on a giant: the skirt hangs, but ends above its place.
TEST(Wearing, of_a_short_dress_on_a_taller_body_has_nothing_bunched) {
    Body tall = mannequin();
    for (Vec3d& x : tall.x) x *= 1.5;
    for (Bone& bone : tall.bones) bone.joint *= 1.5;
    const auto at_the_waist = [](const Vec3d& x) { return Vec3d(1.5 * x.x(), x.y() + 0.48, 1.5 * x.z()); };
    const DressReport report = report_on(dress_in_four_panels(), at_the_waist, tall);
    EXPECT_EQ(list(report).find("displaced: 'skirt"), std::string::npos) << list(report);
}

TEST(Wearing, finds_a_skirt_on_the_floor) {
    const DressReport report = report_on(
        narrow_skirt(), [](const Vec3d& x) { return Vec3d(x.x(), 0.004, x.z()); }, mannequin());
    EXPECT_EQ(std::ranges::count(report.faults, "on_floor", &DressFault::kind), 1) << list(report);
}

TEST(Wearing, only_notes_a_hem_that_is_long_enough_to_lie_on_the_floor) {
    const DressReport report = report_on(
        tube(0.5, 1.0, 0.05, 0.2), [](const Vec3d& x) { return Vec3d(x.x(), std::max(0.004, x.y() - 0.1), x.z()); },
        mannequin());
    EXPECT_EQ(list(report), "");
    EXPECT_EQ(report.notes.size(), 2U);
    EXPECT_TRUE(has_note(report.notes, "lies on the floor"));
    EXPECT_TRUE(has_note(report.notes, "the waist of 'front' lies 10 cm lower than it was placed"));
}

// A strip of cloth that reaches the floor.
Pattern strip() {
    Pattern pattern;
    pattern.panels = {rectangle("strip", {.width = 0.2, .height = 1.5, .y = 0.005, .z = 0.5})};
    return pattern;
}

TEST(Wearing, finds_a_strip_that_stands_on_the_floor_beside_the_body) {
    const DressReport report = report_on(strip(), stays, mannequin());
    ASSERT_EQ(report.faults.size(), 1U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "on_floor");
    EXPECT_NE(report.faults[0].place.find("'strip' stands on the floor"), std::string::npos) << list(report);
}

TEST(Wearing, of_a_strip_that_hangs_from_a_shoulder_to_the_floor_has_no_fault) {
    Vec3d shoulder = Vec3d::Zero();
    for (const Vec3d& x : mannequin().x)
        if (std::abs(x.x() - 0.1) < 0.01 && x.y() < 0.86 * height_range(mannequin()).high && x.y() > shoulder.y())
            shoulder = x;
    const auto hangs = [&](const Vec3d& x) { return Vec3d(x.y() > 1.4 ? shoulder + Vec3d(0, 0.002, 0) : x); };
    EXPECT_EQ(list(report_on(strip(), hangs, mannequin())), "");
}

TEST(Wearing, finds_a_garment_beside_the_body) {
    const DressReport report = report_on(
        skirt(), [](const Vec3d& x) { return Vec3d(x + Vec3d(0, 0, 0.8)); }, mannequin());
    // One fault, although the legs miss both openings.
    ASSERT_EQ(report.faults.size(), 1U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "limb_missed");
    EXPECT_EQ(report.faults[0].place,
              "the left leg and the right leg do not pass through the hem of 'front' or the waist of 'front'");
    EXPECT_EQ(report.faults[0].value, 2);
}

TEST(Wearing, finds_a_hem_that_holds_an_arm) {
    const auto swallow = [](const Vec3d& x) {
        const double low = std::clamp((1.0 - x.y()) / 0.2, 0.0, 1.0);
        return Vec3d(x.x() > 0 ? x.x() * (1 + 3 * low) : x.x(), x.y(), x.z());
    };
    const DressReport report = report_on(skirt(), swallow, mannequin());
    ASSERT_EQ(report.faults.size(), 1U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "limb_missed");
    EXPECT_EQ(report.faults[0].place, "the hem of 'front' holds the left arm");
    EXPECT_EQ(report.faults[0].value, 1);
}

// Its lower edge is as wide as the body with its arms.
Pattern poncho() {
    return tube(1.9, 0.8, 0.62, 0.25);
}

TEST(Wearing, finds_an_arm_that_a_hem_for_all_limbs_but_the_head_misses) {
    EXPECT_EQ(list(report_on(poncho(), stays, mannequin())), "");
    const auto narrower = [](const Vec3d& x) { return Vec3d(x.x() < 0 ? 0.3 * x.x() : x.x(), x.y(), x.z()); };
    EXPECT_EQ(list(report_on(poncho(), narrower, mannequin())),
              "limb_missed: the right arm does not pass through the hem of 'front'\n");
}

// The cloth bulges round the body and the hands between an upper edge and a hem of 1.5 m; its edges of level 0 go
// straight from one to the other, inside of the hands.
Vec3d bulge(const Vec3d& x) {
    const double height = (x.y() - 0.62) / 0.8, side = x.x() / 0.95;
    const double width = 0.25 + 0.75 * std::sin(std::numbers::pi * height), depth = 0.25 * std::sqrt(1 - side * side);
    return {x.x() * width, x.y(), std::copysign(depth, x.z())};
}

TEST(Wearing, lets_limbs_pass_the_corners_that_level_0_cuts) {
    const GarmentMesh unsewn = assemble(poncho(), {.target_edge = 0.8});
    EXPECT_EQ(list(report_on(unsewn, bulge, mannequin(), 3)), "");
    EXPECT_EQ(list(report_on(unsewn, bulge, mannequin(), 0)),
              "limb_missed: the left arm and the right arm do not pass through the hem of 'front'\n");
}

TEST(Wearing, finds_an_empty_sleeve) {
    const DressReport report = report_on(
        sleeve(), [](const Vec3d& x) { return Vec3d(x + Vec3d(0, 0, 0.2)); }, mannequin());
    ASSERT_GE(report.faults.size(), 1U) << list(report);
    EXPECT_EQ(report.faults[0].kind, "limb_missed");
    EXPECT_EQ(report.faults[0].place, "the left arm does not pass through the cuff of 'front'");
}

// The placed panels of a sleeve that stands open do not hold the arm.
TEST(Wearing, lets_an_arm_go_through_the_sleeve_beside_which_it_was) {
    Pattern beside = sleeve();
    for (Panel& panel : beside.panels) panel.translation.z() += 0.12;
    const auto onto_the_arm = [](const Vec3d& x) { return Vec3d(x - Vec3d(0, 0, 0.12)); };
    EXPECT_EQ(std::ranges::count(report_on(beside, onto_the_arm, mannequin()).faults, "limb_missed", &DressFault::kind),
              0);
}

// The garment was placed round an arm that hangs at an angle, and is worn on one that is level.
TEST(Wearing, expects_the_same_arm_in_a_sleeve_whatever_the_pose) {
    const DressReport missed = report_on(sleeve(), stays, mannequin_in_t_pose());
    EXPECT_EQ(std::ranges::count(missed.faults, "limb_missed", &DressFault::kind), 1) << list(missed);
    const auto turned = [](const Vec3d& x) {
        const auto arm_a = find_limbs(mannequin())[LimbKind::LeftArm].joints;
        static const auto arm_t = find_limbs(mannequin_in_t_pose())[LimbKind::LeftArm].joints;
        const auto turn =
            Eigen::Quaterniond::FromTwoVectors(arm_a[2].centre - arm_a[1].centre, arm_t[2].centre - arm_t[1].centre);
        return Vec3d((arm_t[1].centre + arm_t[2].centre) / 2 + turn * (x - (arm_a[1].centre + arm_a[2].centre) / 2));
    };
    EXPECT_EQ(list(report_on(sleeve(), turned, mannequin_in_t_pose())), "");
}

// Folds what lies below a height up.
Move folded_up_from(double y, const std::function<bool(const Vec3d&)>& is_folded) {
    return [=](const Vec3d& x) { return x.y() < y && is_folded(x) ? Vec3d(x.x(), 2 * y - x.y(), x.z()) : x; };
}

double rolled_share(const DressReport& report) {
    const auto found = std::ranges::find(report.faults, "rolled_edge", &DressFault::kind);
    return found == report.faults.end() ? 0 : found->value;
}

TEST(Wearing, finds_a_hem_that_is_rolled_up) {
    const auto everywhere = [](const Vec3d&) { return true; };
    const DressReport report = report_on(skirt(), folded_up_from(0.62, everywhere), mannequin());
    EXPECT_NEAR(rolled_share(report), 1, 1e-9) << list(report);
    EXPECT_NE(list(report).find("the hem of 'front' is rolled up or folded over by"), std::string::npos)
        << list(report);
    const auto on_the_left = [](const Vec3d& x) { return x.x() > 0; };
    EXPECT_NEAR(rolled_share(report_on(skirt(), folded_up_from(0.62, on_the_left), mannequin())), 0.5, 0.15);
}

TEST(Wearing, takes_neither_a_narrow_fold_nor_a_slanting_hem_for_a_rolled_one) {
    const auto at_one_place = [](const Vec3d& x) { return std::abs(x.x()) < 0.02 && x.z() > 0; };
    const DressReport fold = report_on(skirt(), folded_up_from(0.62, at_one_place), mannequin());
    EXPECT_EQ(rolled_share(fold), 0) << list(fold);
    const auto slant = [](const Vec3d& x) { return Vec3d(x.x(), x.y() + 0.4 * x.x(), x.z()); };
    const DressReport slanting = report_on(skirt(), slant, mannequin());
    EXPECT_EQ(rolled_share(slanting), 0) << list(slanting);
}

TEST(Wearing, finds_a_cuff_that_is_flipped_over_its_sleeve) {
    const std::vector<LimbJoint> joints = find_limbs(mannequin())[LimbKind::LeftArm].joints;
    const Vec3d middle = (joints[1].centre + joints[2].centre) / 2;
    const Vec3d along = (joints[2].centre - joints[1].centre).normalized();
    const auto flip = [&](const Vec3d& x) {
        const double beyond = along.dot(x - middle) - 0.03;
        return beyond > 0 ? Vec3d(x - 2 * beyond * along) : x;
    };
    const DressReport report = report_on(sleeve(), flip, mannequin());
    EXPECT_GT(rolled_share(report), 0.9) << list(report);
    EXPECT_NE(list(report).find("the cuff of"), std::string::npos) << list(report);
    EXPECT_EQ(rolled_share(report_on(sleeve(), stays, mannequin())), 0);
}

// A wide collar that stands up to the crown, sewn to the front of a bodice.
Pattern hooded() {
    Pattern pattern = tube(0.5, 0.5, 0.9, 0.2);
    const BodyLimbs limbs = find_limbs(mannequin());
    const double neck = limbs[LimbKind::Head].joints.front().centre.y();
    pattern.panels.push_back(rectangle("hood", {.width = 0.5, .height = 0.35, .y = neck - 0.02, .z = 0.2}));
    pattern.seams.push_back({.first = {0, 2}, .second = {2, 0}});
    return pattern;
}

TEST(Wearing, finds_a_hood_that_slid_off_the_head_though_the_garment_stayed) {
    EXPECT_EQ(list(report_on(hooded(), stays, mannequin())).find("displaced"), std::string::npos);
    const auto slides = [](const Vec3d& x) { return x.y() > 1.42 ? Vec3d(x.x(), 2.84 - x.y(), x.z()) : x; };
    const std::string faults = list(report_on(hooded(), slides, mannequin()));
    EXPECT_NE(faults.find("displaced: 'hood' lies"), std::string::npos) << faults;
    EXPECT_EQ(faults.find("'front' lies"), std::string::npos) << faults;
}

TEST(Wearing, tells_that_a_waist_was_pushed_up_by_what_is_worn_with_it) {
    Pattern pattern = skirt();
    const Pattern other = tube(0.5, 0.2, 0.5, 0.25);
    for (const Panel& panel : other.panels) pattern.panels.push_back(panel);
    for (Seam seam : other.seams) {
        seam.first.panel += 2;
        seam.second.panel += 2;
        pattern.seams.push_back(seam);
    }
    pattern.panels[2].name = "apron_front";
    pattern.panels[3].name = "apron_back";
    const auto up_by = [](double lift) {
        return [lift](const Vec3d& x) { return x.y() > 0.8 ? Vec3d(x + Vec3d(0, lift, 0)) : x; };
    };
    constexpr const char* kTold = "the waist of 'front' lies 5 cm higher than it was placed";
    const DressReport pushed = report_on(pattern, up_by(0.05), mannequin());
    EXPECT_TRUE(has_note(pushed.notes, kTold)) << testing::PrintToString(pushed.notes) << list(pushed);
    EXPECT_FALSE(has_note(report_on(pattern, up_by(0.03), mannequin()).notes, "higher"));
    EXPECT_FALSE(has_note(report_on(skirt(), up_by(0.05), mannequin()).notes, "higher"));
}

TEST(Wearing, says_which_limbs_it_could_not_check) {
    const Body column = shapes::box(Vec3d(-0.15, 0, -0.1), Vec3d(0.15, 1.7, 0.1), 8);
    const DressReport report = report_on(skirt(), stays, column);
    ASSERT_GE(report.notes.size(), 1U);
    EXPECT_NE(report.notes[0].find("could not find the left arm and the right arm"), std::string::npos)
        << report.notes[0];
}

}  // namespace
}  // namespace selvedge::sim::test
