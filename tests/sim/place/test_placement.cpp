// Placement of panels on bodies for which they were not drawn.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "sim/collide/body_collider.h"
#include "sim/collide/surface_bvh.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mesh/sew.h"
#include "sim/place/limbs.h"
#include "sim/place/placement.h"
#include "sim/place/shoulder_top.h"
#include "sim/session/dress.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/place/support.h"
#include "tests/support/bodies.h"
#include "tests/support/posed_body.h"

namespace selvedge::sim::test {
namespace {

// A column as a torso, standing on the floor, with its axis at (x, z).
Body column(double stature, double x = 0, double z = 0) {
    return shapes::box(Vec3d(x - 0.15, 0, z - 0.1), Vec3d(x + 0.15, stature, z + 0.1), 8);
}

// Flat faces do not need a fine grid.
constexpr DistanceFieldOptions kCoarse{.cell = 0.006F, .band = 0.024F};

void move_panels(Pattern& pattern, const Body& from, const Body& onto) {
    anchor_panels(pattern, MeasuredBody(from), MeasuredBody(onto));
}

double centre_height(const Panel& panel) {
    double sum = 0;
    for (const Vec2d& u : panel.vertices) sum += panel.place(u).y();
    return sum / static_cast<double>(panel.vertices.size());
}

TEST(AnchorPanels, leaves_panels_where_they_are_on_the_body_that_they_were_made_for) {
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    move_panels(pattern, column(1.7, 0.03, -0.02), column(1.7, 0.03, -0.02));
    EXPECT_LT((pattern.panels[0].translation - Vec3d(0, 0.9, 0.2)).norm(), 1e-12);
    EXPECT_LT((pattern.panels[1].translation - Vec3d(0, 0.9, -0.2)).norm(), 1e-12);
}

TEST(AnchorPanels, moves_a_garment_up_with_the_place_of_its_top_and_nothing_else) {
    Pattern pattern = tube(0.5, 0.4, 0.8, 0.2);
    move_panels(pattern, column(1.6), column(2.0));
    for (const Panel& panel : pattern.panels) {
        EXPECT_NEAR(centre_height(panel), 1.0 + 1.2 * (2.0 / 1.6 - 1), 1e-9);
        EXPECT_NEAR(panel.translation.x(), 0, 1e-9);
        EXPECT_NEAR(std::abs(panel.translation.z()), 0.2, 1e-9);
    }
}

TEST(AnchorPanels, follows_the_centre_of_the_torso) {
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    move_panels(pattern, column(1.7), column(1.7, 0.04, 0.03));
    EXPECT_LT((pattern.panels[0].translation - Vec3d(0.04, 0.9, 0.23)).norm(), 1e-9);
    EXPECT_LT((pattern.panels[1].translation - Vec3d(0.04, 0.9, -0.17)).norm(), 1e-9);
}

TEST(AnchorPanels, follows_a_torso_that_stands_higher) {
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    Body raised = column(1.7);
    for (Vec3d& p : raised.x) p.y() += 0.5;
    move_panels(pattern, column(1.7), raised);
    for (const Panel& panel : pattern.panels) EXPECT_NEAR(centre_height(panel), 1.6, 1e-9);
}

TEST(AnchorPanels, moves_a_shirt_up_on_a_taller_mannequin) {
    MannequinOptions tall{.subdivisions = 1};
    tall.measures.height = 1.80;
    MannequinOptions small{.subdivisions = 1};
    small.measures.height = 1.60;
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    const Body from = make_mannequin(small).body, onto = make_mannequin(tall).body;
    move_panels(pattern, from, onto);
    // The top, at 1.3 m, stays in its place between the waist and the top of the shoulders.
    const auto waist = [](const Body& body) { return torso_heights(body, find_stature(body)).waist; };
    const auto shoulders = [](const Body& body) { return find_shoulder_top(MeasuredBody(body)).value(); };
    const double share = (1.3 - waist(from)) / (shoulders(from) - waist(from));
    const double rise = std::lerp(waist(onto), shoulders(onto), share) - 1.3;
    for (const Panel& panel : pattern.panels) {
        EXPECT_NEAR(centre_height(panel), 1.1 + rise, 1e-9);
        EXPECT_NEAR(centre_height(panel), 1.1 + 0.8 * 0.2, 0.015);
    }
}

TEST(AnchorPanels, keeps_the_heights_of_joined_panels_among_themselves) {
    Pattern pattern = tube(0.5, 0.4, 0.8, 0.2);
    pattern.panels[1].translation.y() -= 0.1;
    move_panels(pattern, column(1.6), column(2.0));
    EXPECT_NEAR(centre_height(pattern.panels[0]) - centre_height(pattern.panels[1]), 0.1, 1e-9);
}

TEST(AnchorPanels, puts_a_shirt_under_a_large_head) {
    const Body from = make_mannequin({.subdivisions = 1}).body;
    const Body onto = with_large_head(from);
    Pattern pattern = tube(0.5, 0.6, 0.82, 0.2);
    const double before = centre_height(pattern.panels[0]);
    move_panels(pattern, from, onto);
    EXPECT_NEAR(centre_height(pattern.panels[0]), before, 0.01) << "its shoulders are as high as before";
}

TEST(AnchorPanels, puts_the_top_of_a_skirt_at_the_waist_where_that_is_lower) {
    Body low_waist = column(1.7);
    for (Vec3d& p : low_waist.x) {
        if (p.y() > 0.92 && p.y() < 1.01) p.x() *= 0.7;  // from 0.54 to 0.59 of the stature
    }
    Body usual = column(1.7);
    for (Vec3d& p : usual.x) {
        if (p.y() > 1.04 && p.y() < 1.08) p.x() *= 0.7;
    }
    const auto waist = [](const Body& body) { return torso_heights(body, find_stature(body)).waist; };
    ASSERT_GT(waist(usual) - waist(low_waist), 0.03);
    Pattern pattern = tube(0.5, 0.6, waist(usual) - 0.6, 0.2);
    const double before = centre_height(pattern.panels[0]);
    move_panels(pattern, usual, low_waist);
    EXPECT_NEAR(before - centre_height(pattern.panels[0]), waist(usual) - waist(low_waist), 1e-9);
}

// The bodies that a mannequin leaves when it is cut: without a head, without legs, without both.
std::vector<Body> parts_of(const Body& whole) {
    const double height = height_range(whole).high;
    const Body headless = shapes::cut(whole, 0.8701 * height, shapes::Side::Below);
    return {headless, shapes::cut(whole, 0.4201 * height, shapes::Side::Above),
            shapes::cut(headless, 0.5201 * height, shapes::Side::Above)};
}

TEST(AnchorPanels, puts_a_shirt_on_the_chest_of_a_body_without_head_or_legs) {
    const Body from = make_mannequin({.measures = {.height = 1.7}, .subdivisions = 1}).body;
    const Body whole = make_mannequin({.subdivisions = 1}).body;
    const auto placed_on = [&](const Body& onto) {
        Pattern pattern = tube(0.5, 0.4, 1.2, 0.2);
        move_panels(pattern, from, onto);
        return pattern.panels[0].translation;
    };
    const Vec3d expected = placed_on(whole);
    for (const Body& part : parts_of(whole)) EXPECT_LT((placed_on(part) - expected).norm(), 0.02);
}

TEST(ArrangementPoints, are_the_same_on_a_body_without_a_head) {
    const Body whole = make_mannequin({.subdivisions = 1}).body;
    Body bare = whole;
    bare.bones.clear();
    const Body headless = parts_of(bare)[0];
    std::map<std::string, Vec3d> expected;
    for (const ArrangementPoint& point : arrangement_points(bare)) expected[point.name] = point.position;
    const std::vector<ArrangementPoint> found = arrangement_points(headless);
    EXPECT_EQ(found.size(), expected.size());
    for (const ArrangementPoint& point : found)
        EXPECT_LT((point.position - expected.at(point.name)).norm(), 0.03) << point.name;
}

// The smallest distance of the mesh from the body, m: at vertices and triangle centres.
double clearance(const GarmentMesh& mesh, const BodyCollider& body) {
    double least = 1;
    for (const GarmentTriangle& t : mesh.triangles) {
        Vec3d middle = Vec3d::Zero();
        for (const int v : t.vertices) {
            const Vec3d& x = mesh.x[std::size_t(v)];
            least = std::min(least, double(body.contact(x.cast<float>()).distance));
            middle += x / 3;
        }
        least = std::min(least, double(body.contact(middle.cast<float>()).distance));
    }
    return least;
}

TEST(ClearPanels, moves_a_panel_out_of_the_body_along_its_right_side_and_says_so) {
    const Body body = column(1.7);
    const BodyCollider collider(body, kCoarse);
    for (const bool is_back : {false, true}) {
        const double side = is_back ? -1 : 1;
        Pattern pattern;
        pattern.panels = {rectangle("sunken", {.z = 0.07 * side, .is_back = is_back})};
        const GarmentMesh before = assemble(pattern);
        GarmentMesh after = before;
        const std::vector<std::string> notes = clear_panels(after, collider).notes;
        ASSERT_EQ(notes.size(), 1U);
        EXPECT_NE(notes[0].find("'sunken'"), std::string::npos) << notes[0];
        for (std::size_t v = 0; v < after.x.size(); ++v) {
            const Vec3d moved = after.x[v] - before.x[v];
            EXPECT_NEAR(moved.x(), 0, 1e-12);
            EXPECT_NEAR(moved.y(), 0, 1e-12);
            EXPECT_GT(moved.z() * side, 0.03);
            EXPECT_LT(moved.z() * side, 0.08) << "further than it need be";
        }
        EXPECT_GT(clearance(after, collider), 0.003);
    }
}

TEST(ClearPanels, names_a_panel_that_no_move_takes_out_of_the_body) {
    const Body body = shapes::box(Vec3d(-0.6, 0, -0.6), Vec3d(0.6, 1.7, 0.6), 6);
    const BodyCollider collider(body, kCoarse);
    Pattern pattern;
    pattern.panels = {rectangle("sunken", {.z = 0})};
    GarmentMesh mesh = assemble(pattern);
    const ClearedPanels cleared = clear_panels(mesh, collider);
    EXPECT_TRUE(cleared.notes.empty());
    ASSERT_EQ(cleared.stuck.size(), 1U);
    EXPECT_EQ(cleared.stuck[0], "panel 'sunken' stands in the body, and nowhere near is clear of it");
}

TEST(ClearPanels, moves_only_the_panel_that_stands_in_the_body) {
    const Body body = column(1.7);
    const BodyCollider collider(body, kCoarse);
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    pattern.panels[1].translation.z() = -0.05;
    const GarmentMesh before = assemble(pattern);
    GarmentMesh after = before;
    EXPECT_EQ(clear_panels(after, collider).notes.size(), 1U);
    for (const GarmentTriangle& t : after.triangles) {
        for (const int v : t.vertices) {
            EXPECT_EQ(after.x[std::size_t(v)] == before.x[std::size_t(v)], t.panel == 0);
        }
    }
}

TEST(ClearPanels, moves_a_panel_outside_of_the_cloth_that_is_worn_and_says_so) {
    const Body body = column(1.7);
    const BodyCollider collider(body, kCoarse);
    const GarmentMesh worn = assemble(tube(0.5, 0.4, 0.9, 0.25));
    GarmentMesh after = assemble(tube(0.6, 0.2, 1.0, 0.2));
    const std::vector<std::string> notes = clear_panels(after, collider, worn).notes;
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_NE(notes[0].find("of what is worn under it"), std::string::npos) << notes[0];
    for (const Vec3d& x : after.x) EXPECT_NEAR(std::abs(x.z()), 0.26, 1e-6);
    const GarmentMesh again = after;
    EXPECT_TRUE(clear_panels(after, collider, worn).notes.empty());
    EXPECT_EQ(after.x, again.x);
}

TEST(ClearPanels, moves_a_panel_outside_of_those_of_lower_layers) {
    const Body body = column(1.7);
    const BodyCollider collider(body, kCoarse);
    Pattern pattern;
    for (const char* name : {"outer", "inner", "middle"}) pattern.panels.push_back(rectangle(name, {.z = 0.2}));
    pattern.panels[0].layer = 7;
    pattern.panels[2].layer = 1;
    GarmentMesh mesh = assemble(pattern);
    EXPECT_EQ(clear_panels(mesh, collider).notes.size(), 2U);
    for (const GarmentTriangle& t : mesh.triangles) {
        const double expected = t.panel == 0 ? 0.22 : t.panel == 1 ? 0.20 : 0.21;
        for (const int v : t.vertices) EXPECT_NEAR(mesh.x[std::size_t(v)].z(), expected, 1e-6);
    }
}

// A tent whose ridge runs askew, so that one edge of the panel's mesh crosses it.
TEST(ClearPanels, finds_the_farthest_place_of_the_cloth_that_is_worn) {
    const Body body = column(1.7);
    const BodyCollider collider(body, kCoarse);
    GarmentMesh worn = assemble(tube(0.5, 0.4, 0.9, 0.25));
    const auto height_at = [](const Vec3d& x) { return 0.25 + 0.1 * (1 - std::abs(x.x() + 0.3 * (x.y() - 1.1))); };
    for (Vec3d& x : worn.x) x.z() = std::copysign(height_at(x), x.z());
    GarmentMesh after = assemble(tube(0.6, 0.2, 1.0, 0.2));
    double farthest = 0;  // the cloth is convex: nowhere farther than at a point of its mesh
    for (const Vec3d& x : worn.x) {
        if (std::abs(x.x()) < 0.3 && x.y() >= 1.0 && x.y() <= 1.2) farthest = std::max(farthest, std::abs(x.z()));
    }
    EXPECT_EQ(clear_panels(after, collider, worn).notes.size(), 2U);
    for (const Vec3d& x : after.x) {
        EXPECT_GT(std::abs(x.z()), farthest - 0.005);
        EXPECT_LE(std::abs(x.z()), farthest + 0.01 + 1e-9);
    }
}

TEST(ClearPanels, leaves_clear_panels_alone_and_says_nothing) {
    const Body body = column(1.7);
    const BodyCollider collider(body, kCoarse);
    const GarmentMesh before = assemble(tube(0.5, 0.4, 0.9, 0.2));
    GarmentMesh after = before;
    EXPECT_TRUE(clear_panels(after, collider).notes.empty());
    EXPECT_EQ(after.x, before.x);
}

// Panels round the left arm of the mannequin turn to the arm that is level, and all others stay.
TEST(AnchorPanels, turns_a_sleeve_with_its_arm) {
    const Body from = make_mannequin({.subdivisions = 1}).body;
    const Body onto = shapes::in_t_pose(from);
    const std::vector<LimbJoint> arm = find_limbs(from)[LimbKind::LeftArm].joints;
    const Vec3d up = arm[0].centre - arm[2].centre;
    Pattern pattern = tube(0.4, 0.3, 1.0, 0.2);
    pattern.panels.push_back(rectangle("sleeve", {.width = 0.1, .height = 0.2, .y = 0}));
    pattern.panels.back().rotation = Eigen::AngleAxisd(std::atan2(-up.x(), up.y()), Vec3d::UnitZ()).toRotationMatrix();
    pattern.panels.back().translation = (arm[0].centre + 3 * arm[2].centre) / 4 + Vec3d(0, 0, 0.08);
    const Pattern before = pattern;
    move_panels(pattern, from, onto);
    for (const std::size_t p : {0U, 1U}) EXPECT_TRUE(pattern.panels[p].rotation.isApprox(before.panels[p].rotation));
    const BodyLimbs level = find_limbs(onto);
    const Vec3d along = pattern.panels.back().rotation * Vec3d::UnitY();
    EXPECT_NEAR(
        std::abs(along.dot(
            (level[LimbKind::LeftArm].joints[2].centre - level[LimbKind::LeftArm].joints[0].centre).normalized())),
        1, 0.02);
    EXPECT_NEAR(pattern.panels.back().place(Vec2d(0, 0.1)).y(), level[LimbKind::LeftArm].joints[1].centre.y(), 0.05);
}

// Maximum depth (m) inside the body of the straight lines between linked vertices, with all vertices raised by `lift`.
double blocked_depth(const GarmentMesh& unsewn, double lift, const BodyCollider& body) {
    double deepest = 0;
    for (const SeamLink& link : unsewn.links) {
        for (int i = 0; i <= 40; ++i) {
            const Vec3d& a = unsewn.x[std::size_t(link.a)];
            const Vec3d p = a + (unsewn.x[std::size_t(link.b)] - a) * (i / 40.0) + Vec3d(0, lift, 0);
            deepest = std::max(deepest, -double(body.contact(p.cast<float>()).distance));
        }
    }
    return deepest;
}

TEST(SeamClearingLift, lifts_a_shoulder_seam_that_lies_too_low) {
    const Body body = column(1.4);
    const BodyCollider collider(body, kCoarse);
    const GarmentMesh unsewn = assemble(tabard(0.25, 0.4, 0.95, 0.2));  // its upper edges are at 1.35 m
    ASSERT_GT(blocked_depth(unsewn, 0, collider), 0.04);
    const double lift = seam_clearing_lift(unsewn, collider);
    EXPECT_GE(lift, 0.05);
    EXPECT_LE(lift, 0.12);
    EXPECT_LT(blocked_depth(unsewn, lift, collider), 1e-3);
}

TEST(SeamClearingLift, lowers_a_seam_under_a_body_that_lies_too_high) {
    const Body body = shapes::box(Vec3d(-0.15, 1.3, -0.1), Vec3d(0.15, 1.7, 0.1), 8);
    const BodyCollider collider(body, kCoarse);
    const GarmentMesh unsewn = assemble(tabard(0.25, 0.4, 0.95, 0.2));
    const double lift = seam_clearing_lift(unsewn, collider);
    EXPECT_LE(lift, -0.05);
    EXPECT_LT(blocked_depth(unsewn, lift, collider), 1e-3);
}

// A sleeve 6 cm high contains the middle of three bars. Above and below, its seams would be less blocked, but not free.
TEST(SeamClearingLift, does_not_take_a_sleeve_off_an_arm) {
    Body body;
    for (const double low : {1.1, 1.25, 1.4}) {
        const Body bar = shapes::box(Vec3d(-0.3, low, -0.1), Vec3d(0.3, low + 0.1, 0.1), 8);
        const int first = int(body.x.size());
        body.x.insert(body.x.end(), bar.x.begin(), bar.x.end());
        for (const auto& t : bar.triangles) body.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    GarmentMesh unsewn;
    for (const double height : {1.27, 1.33}) {
        for (const double x : {-0.1, 0.0, 0.1}) {
            const int first = int(unsewn.x.size());
            unsewn.x.insert(unsewn.x.end(), {Vec3d(x, height, 0.2), Vec3d(x, height, -0.2)});
            unsewn.links.push_back({.a = first, .b = first + 1});
        }
    }
    EXPECT_EQ(seam_clearing_lift(unsewn, BodyCollider(body, kCoarse)), 0);
}

// A shoulder seam 3 mm below the top of a column, and a seam 1 mm above the underside of an arm beside it.
TEST(SeamClearingLift, clears_a_shoulder_seam_that_grazes_the_shoulder_although_a_seam_under_the_arm_is_in_the_way) {
    Body body = shapes::box(Vec3d(-0.15, 1.0, -0.1), Vec3d(0.15, 1.353, 0.1), 8);
    const Body arm = shapes::box(Vec3d(0.25, 1.199, -0.1), Vec3d(0.55, 1.499, 0.1), 8);
    const int first = int(body.x.size());
    body.x.insert(body.x.end(), arm.x.begin(), arm.x.end());
    for (const auto& t : arm.triangles) body.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    GarmentMesh unsewn;
    unsewn.x = {Vec3d(0, 1.35, 0.2), Vec3d(0, 1.35, -0.2), Vec3d(0.4, 1.2, 0.2), Vec3d(0.4, 1.2, -0.2)};
    unsewn.links = {{.a = 0, .b = 1}, {.a = 2, .b = 3}};
    EXPECT_NEAR(seam_clearing_lift(unsewn, BodyCollider(body, kCoarse)), 0.01, 1e-9);
}

// Shoulder seams 4 cm below the top of a column, and seams that enter an arm beside it from 1 cm on when they are
// lifted.
TEST(SeamClearingLift, brings_shoulder_seams_onto_the_shoulders_when_seams_under_the_arms_would_rather_stay) {
    Body body = shapes::box(Vec3d(-0.15, 1.0, -0.1), Vec3d(0.15, 1.39, 0.1), 8);
    const Body arm = shapes::box(Vec3d(0.5, 1.21, -0.1), Vec3d(0.8, 1.51, 0.1), 8);
    const int corner = int(body.x.size());
    body.x.insert(body.x.end(), arm.x.begin(), arm.x.end());
    for (const auto& t : arm.triangles) body.triangles.push_back({corner + t[0], corner + t[1], corner + t[2]});
    GarmentMesh unsewn = assemble(tabard(0.25, 0.4, 0.95, 0.2));  // its upper edges are at 1.35 m
    constexpr int kUnderArms = 12;                                // twice as many links as the tabard has
    const double as_placed = blocked_depth(unsewn, 0, BodyCollider(body, kCoarse));
    for (int i = 0; i < kUnderArms; ++i) {
        const int first = int(unsewn.x.size());
        unsewn.x.insert(unsewn.x.end(), {Vec3d(0.65, 1.2, 0.2), Vec3d(0.65, 1.2, -0.2)});
        unsewn.links.push_back({.a = first, .b = first + 1});
    }
    const BodyCollider collider(body, kCoarse);
    const double lift = seam_clearing_lift(unsewn, collider);
    ASSERT_GT(as_placed, 0.03);
    EXPECT_GE(lift, 0.03);
    EXPECT_LT(lift, 0.06);
}

TEST(SeamClearingLift, is_nothing_where_nothing_is_in_the_way) {
    const Body body = column(1.3);
    const BodyCollider collider(body, kCoarse);
    EXPECT_EQ(seam_clearing_lift(assemble(tabard(0.25, 0.4, 0.95, 0.2)), collider), 0);
}

}  // namespace

// Arrangement points around a body.

namespace {

constexpr float kAnyFar = std::numeric_limits<float>::infinity();

struct NamedOptions {
    const char* name;
    MannequinOptions options;
};

const std::vector<NamedOptions>& mannequins() {
    static const std::vector<NamedOptions> all{
        {"female", {.subdivisions = 1}},
        {"male", {.sex = Sex::Male, .subdivisions = 1}},
        {"wide", {.measures = {.height = 1.60, .bust = 1.20, .waist = 1.05, .hip = 1.25}, .subdivisions = 1}},
        {"narrow", {.measures = {.height = 1.85, .bust = 0.82, .waist = 0.62, .hip = 0.88}, .subdivisions = 1}}};
    return all;
}

std::map<std::string, ArrangementPoint> by_name(const Body& body) {
    std::map<std::string, ArrangementPoint> points;
    for (const ArrangementPoint& point : arrangement_points(body)) points[point.name] = point;
    return points;
}

// Whether the triangle belongs to an arm by its skin weights: a wide panel at the chest may intersect an arm.
bool is_of_an_arm(const Body& body, std::uint32_t triangle) {
    const SkinWeights& skin = body.skin[static_cast<std::size_t>(body.triangles[triangle][0])];
    const auto heaviest = std::ranges::max_element(skin.weights) - skin.weights.begin();
    const std::string& bone = body.bones[skin.bones[static_cast<std::size_t>(heaviest)]].name;
    return bone.find("arm") != std::string::npos || bone.find("hand") != std::string::npos;
}

// m, from the trunk to the nearest of a grid of points on the panel.
float clearance_of(const Panel& panel, const Body& body, const SurfaceBvh& surface) {
    Eigen::AlignedBox2d box;
    for (const Vec2d& u : panel.vertices) box.extend(u);
    float least = 10;
    for (int i = 0; i <= 24; ++i) {
        for (int j = 0; j <= 6; ++j) {
            const Vec2d u = box.min() + Vec2d(i / 24.0 * box.sizes().x(), j / 6.0 * box.sizes().y());
            const auto closest = surface.closest(panel.place(u).cast<float>(), kAnyFar);
            if (!is_of_an_arm(body, closest->triangle)) least = std::min(least, closest->distance);
        }
    }
    return least;
}

TEST(ArrangementPoints, of_mannequins_of_all_kinds_stand_clear_of_them_and_near) {
    for (const NamedOptions& one : mannequins()) {
        const Body body = make_mannequin(one.options).body;
        const SurfaceBvh surface(body);
        for (const ArrangementPoint& point : arrangement_points(body)) {
            const float clear = surface.closest(point.position.cast<float>(), kAnyFar)->distance;
            EXPECT_GE(clear, 0.005F) << one.name << ", " << point.name;
            const bool is_between_thighs = point.name == "below hip front" || point.name == "below hip back";
            EXPECT_LE(clear, is_between_thighs ? 0.1F : 0.06F) << one.name << ", " << point.name;
            EXPECT_NEAR(point.outward.norm(), 1, 1e-9) << point.name;
            EXPECT_NEAR(point.outward.dot(point.upward), 0, 1e-9) << point.name;
        }
    }
}

TEST(ArrangementPoints, of_mannequins_cover_torso_arms_and_legs_in_a_fixed_order) {
    for (const NamedOptions& one : mannequins()) {
        const std::vector<ArrangementPoint> points = arrangement_points(make_mannequin(one.options).body);
        std::vector<std::string> torso;
        for (const ArrangementPoint& point : points) {
            if (torso.size() < 20) torso.push_back(point.name);
        }
        std::vector<std::string> expected;
        for (const char* level : {"neck", "chest", "waist", "hip", "below hip"}) {
            for (const char* way : {"front", "back", "left", "right"})
                expected.push_back(std::string(level) + " " + way);
        }
        EXPECT_EQ(torso, expected) << one.name;
        for (const char* limb : {"upper arm", "forearm", "thigh", "calf"}) {
            for (const char* way : {"outside", "front", "back"}) {
                const std::string name = std::string(limb) + " " + way;
                EXPECT_EQ(std::ranges::count(points, "left " + name, &ArrangementPoint::name), 1) << name;
                EXPECT_EQ(std::ranges::count(points, "right " + name, &ArrangementPoint::name), 1) << name;
            }
        }
    }
}

TEST(ArrangementPoints, of_the_left_are_mirror_images_of_the_right) {
    for (const NamedOptions& one : mannequins()) {
        const auto points = by_name(make_mannequin(one.options).body);
        int pairs = 0;
        for (const auto& [name, point] : points) {
            const std::size_t at = name.find("left");
            if (at == std::string::npos) continue;
            std::string other = name;
            other.replace(at, 4, "right");
            ASSERT_TRUE(points.contains(other)) << other;
            const ArrangementPoint& right = points.at(other);
            const Vec3d mirrored(-right.position.x(), right.position.y(), right.position.z());
            EXPECT_LT((point.position - mirrored).norm(), 0.001) << one.name << ", " << name;
            EXPECT_NEAR(point.radius, right.radius, 0.002) << one.name << ", " << name;
            ++pairs;
        }
        EXPECT_GE(pairs, 5 + 12);
    }
}

TEST(ArrangementPoints, of_a_body_without_bones_are_found_by_its_sections) {
    Body body = make_mannequin({.subdivisions = 1}).body;
    const auto with_bones = by_name(body);
    body.bones.clear();
    body.skin.clear();
    const auto points = by_name(body);
    for (const char* name : {"chest front", "waist left", "hip back", "left upper arm outside", "right thigh front"}) {
        ASSERT_TRUE(points.contains(name)) << name;
        EXPECT_LT((points.at(name).position - with_bones.at(name).position).norm(), 0.08) << name;
    }
    const auto column = by_name(shapes::box(Vec3d(-0.15, 0, -0.1), Vec3d(0.15, 1.7, 0.1), 8));
    EXPECT_TRUE(column.contains("waist front"));
    EXPECT_FALSE(column.contains("left upper arm outside"));
    EXPECT_TRUE(arrangement_points(Body{}).empty());
}

TEST(Arrange, puts_the_middle_of_a_panel_at_the_point_with_its_right_side_outward) {
    const auto points = by_name(make_mannequin({.subdivisions = 1}).body);
    for (const bool is_back : {false, true}) {
        for (const double shift : {0.0, 0.17}) {  // of the origin, from the panel's centre
            Panel panel = rectangle("panel", {.width = 0.4, .height = 0.1, .is_back = is_back});
            for (Vec2d& u : panel.vertices) u.x() += shift;
            for (const auto& [name, point] : points) {
                arrange(panel, point);
                const Vec2d middle(shift, 0.05);
                EXPECT_LT((panel.place(middle) - point.position).norm(), 1e-9) << name;
                const Vec3d along = panel.place(middle + Vec2d(1e-5, 0)) - panel.place(middle - Vec2d(1e-5, 0));
                const Vec3d up = panel.place(middle + Vec2d(0, 1e-5)) - panel.place(middle - Vec2d(0, 1e-5));
                EXPECT_NEAR(along.cross(up).normalized().dot(point.outward), 1, 1e-6) << name;
                EXPECT_NEAR(up.normalized().dot(point.upward), 1, 1e-6) << name;
            }
        }
    }
}

TEST(Arrange, wraps_a_wide_panel_round_the_torso_clear_of_it) {
    for (const NamedOptions& one : mannequins()) {
        const Body body = make_mannequin(one.options).body;
        const SurfaceBvh surface(body);
        const auto points = by_name(body);
        for (const char* level : {"chest", "waist", "hip", "below hip"}) {
            for (const char* way : {"front", "back"}) {
                const std::string name = std::string(level) + " " + way;
                Panel panel = rectangle("panel", {.width = 0.4, .height = 0.1, .is_back = true});
                arrange(panel, points.at(name));
                EXPECT_GT(clearance_of(panel, body, surface), 0.001F) << one.name << ", " << name;
            }
        }
    }
}

TEST(Arrange, a_tube_skirt_put_at_points_is_sewn_without_a_fault) {
    const Body body = make_mannequin({.subdivisions = 1}).body;
    const auto points = by_name(body);
    Pattern pattern = tube(0.50, 0.45, 0.6, 0.2);
    pattern.body = "mannequin:sex=female,resolution=1";
    for (Panel& panel : pattern.panels) {
        panel.is_mirrored = false;
        panel.vertices = {Vec2d(-0.3, 0), Vec2d(0.3, 0), Vec2d(0.185, 0.45), Vec2d(-0.185, 0.45)};
    }
    arrange(pattern.panels[0], points.at("hip front"));
    arrange(pattern.panels[1], points.at("hip back"));
    DressOptions options;
    options.max_level = 1;
    const DressReport report = dress(pattern, body, options).report;
    for (const DressFault& fault : report.faults) ADD_FAILURE() << fault.kind << ": " << fault.place;
    EXPECT_EQ(report.seams.open, 0);
}

}  // namespace

}  // namespace selvedge::sim::test
