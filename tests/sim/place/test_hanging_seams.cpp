// What bears a garment, and what hangs from it.
#include "sim/place/hanging_seams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim/collide/body_collider.h"
#include "sim/mesh/sew.h"
#include "sim/place/placement.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

constexpr double kWaist = 1.0, kGap = 0.05;  // m

// Front and back above the waist, and front and back of a skirt below it, with a gap between them.
Pattern in_two_parts(Pattern upper) {
    const Pattern skirt = tube(0.4, 0.5, kWaist - kGap - 0.5, 0.15);
    upper.panels.insert(upper.panels.end(), skirt.panels.begin(), skirt.panels.end());
    upper.panels[2].name = "skirt front";
    upper.panels[3].name = "skirt back";
    upper.seams.push_back({.first = {2, 1}, .second = {3, 3}});
    upper.seams.push_back({.first = {2, 3}, .second = {3, 1}});
    upper.seams.push_back({.first = {0, 0}, .second = {2, 2}});
    upper.seams.push_back({.first = {1, 0}, .second = {3, 2}});
    return upper;
}

// How far the vertices of upper and lower panels rose, m: the least and the most.
struct Rises {
    double upper_least = 1, upper_most = -1, lower_least = 1, lower_most = -1;
};

Rises rises(const GarmentMesh& before, const GarmentMesh& after) {
    Rises found;
    for (const GarmentTriangle& triangle : before.triangles) {
        for (const int v : triangle.vertices) {
            const double rise = after.x[std::size_t(v)].y() - before.x[std::size_t(v)].y();
            double& least = triangle.panel < 2 ? found.upper_least : found.lower_least;
            double& most = triangle.panel < 2 ? found.upper_most : found.lower_most;
            least = std::min(least, rise);
            most = std::max(most, rise);
        }
    }
    return found;
}

TEST(LevelGaps, close_by_the_skirt_when_shoulder_seams_hold_the_bodice) {
    const GarmentMesh before = assemble(in_two_parts(tabard(0.4, 0.4, kWaist, 0.2)));
    GarmentMesh after = before;
    EXPECT_NEAR(close_level_gaps(after), kGap, 1e-9);
    const Rises found = rises(before, after);
    EXPECT_NEAR(found.upper_least, 0, 1e-12);
    EXPECT_NEAR(found.upper_most, 0, 1e-12);
    EXPECT_NEAR(found.lower_least, kGap, 1e-9);
    EXPECT_NEAR(found.lower_most, kGap, 1e-9);
}

TEST(LevelGaps, close_by_the_skirt_when_a_waistband_is_above_it) {
    const GarmentMesh before = assemble(in_two_parts(tube(0.4, 0.1, kWaist, 0.2)));
    GarmentMesh after = before;
    EXPECT_NEAR(close_level_gaps(after), kGap, 1e-9);
    const Rises found = rises(before, after);
    EXPECT_NEAR(found.upper_most, 0, 1e-12);
    EXPECT_NEAR(found.lower_least, kGap, 1e-9);
}

TEST(LevelGaps, are_not_between_panels_side_by_side) {
    Pattern pattern = tube(0.5, 0.4, 0.9, 0.2);
    pattern.panels[1].translation.y() += kGap;
    const GarmentMesh before = assemble(pattern);
    GarmentMesh after = before;
    EXPECT_EQ(close_level_gaps(after), 0);
}

// Its top lies that much below the shoulders.
TEST(HangOnShoulders, lifts_bodice_and_skirt_when_the_bodice_stands_below_the_shoulders) {
    constexpr double kLow = 0.08;  // m
    const MeasuredBody body(mannequin());
    ASSERT_TRUE(body.shoulder_top());
    Pattern pattern = in_two_parts(tabard(0.3, 0.4, kWaist, 0.2));
    for (Panel& panel : pattern.panels) panel.translation.y() += *body.shoulder_top() - kLow - kWaist - 0.4;
    const GarmentMesh before = assemble(pattern);
    GarmentMesh after = before;
    hang_on_shoulders(after, body);
    const Rises found = rises(before, after);
    EXPECT_NEAR(found.upper_least, kLow, 1e-9);
    EXPECT_NEAR(found.upper_most, kLow, 1e-9);
    EXPECT_NEAR(found.lower_least, kLow + kGap, 1e-9);
}

// A strip that stands over the top of a tabard's front, with a seam between them, or along its own upper edge on a
// head.
GarmentMesh with_strip(Pattern pattern, double y) {
    pattern.panels.push_back(rectangle("strip", {.width = 0.3, .height = 0.06, .y = y, .z = 0.2}));
    GarmentMesh mesh = assemble(pattern);
    std::vector<int> lower, upper;  // of the strip; of the front
    for (const GarmentTriangle& t : mesh.triangles) {
        for (const int v : t.vertices) {
            const double height = mesh.x[std::size_t(v)].y();
            if (t.panel == 2 && height < y + 1e-6) lower.push_back(v);
            if (t.panel == 0 && height > pattern.panels[0].translation.y() + 0.4 - 1e-6) upper.push_back(v);
        }
    }
    for (std::size_t i = 0; i < std::min(lower.size(), upper.size()); ++i)
        mesh.links.push_back({.a = lower[i], .b = upper[i], .seam = 9});
    return mesh;
}

TEST(HangOnShoulders, lifts_a_collar_when_the_bodice_under_it_stands_below_the_shoulders) {
    constexpr double kLow = 0.08;  // m
    const MeasuredBody body(mannequin());
    const double top = body.shoulder_top().value() - kLow;
    const GarmentMesh before = with_strip(tabard(0.3, 0.4, top - 0.4, 0.2), top + 0.02);
    GarmentMesh after = before;
    hang_on_shoulders(after, body);
    for (std::size_t v = 0; v < before.x.size(); ++v) EXPECT_NEAR(after.x[v].y() - before.x[v].y(), kLow, 1e-9);
}

TEST(HangOnShoulders, lifts_a_low_bodice_whose_hood_has_a_seam_over_the_head) {
    constexpr double kLow = 0.08;  // m
    const MeasuredBody body(mannequin());
    const double top = body.shoulder_top().value() - kLow;
    Pattern pattern = tabard(0.3, 0.4, top - 0.4, 0.2);
    const Pattern hood = tabard(0.3, 0.1, body.stature().crown - 0.08, 0.15);
    pattern.panels.insert(pattern.panels.end(), hood.panels.begin(), hood.panels.end());
    pattern.seams.push_back({.first = {2, 2}, .second = {3, 2}});
    const GarmentMesh before = assemble(pattern);
    GarmentMesh after = before;
    hang_on_shoulders(after, body);
    const Rises found = rises(before, after);
    EXPECT_NEAR(found.upper_least, kLow, 1e-9);
    EXPECT_EQ(found.lower_most, 0) << "nothing joins it with the bodice here";
}

TEST(HangOnShoulders, leaves_a_bodice_in_place_when_it_reaches_above_the_shoulders) {
    const MeasuredBody body(mannequin());
    const GarmentMesh before = assemble(tabard(0.3, 0.4, body.shoulder_top().value() - 0.39, 0.2));
    GarmentMesh after = before;
    hang_on_shoulders(after, body);
    EXPECT_EQ(before.x, after.x);
}

TEST(HangOnShoulders, leaves_a_skirt_whose_side_seams_slope_like_shoulders) {
    Pattern skirt = tube(0.4, 0.5, 0.6, 0.16);
    for (Panel& panel : skirt.panels) {
        panel.vertices[0].x() = -1.3;
        panel.vertices[1].x() = 1.3;
    }
    const GarmentMesh before = assemble(skirt);
    ASSERT_FALSE(shoulder_links(before).empty());
    GarmentMesh after = before;
    hang_on_shoulders(after, MeasuredBody(mannequin()));
    EXPECT_EQ(before.x, after.x);
}

TEST(ShoulderLinks, are_those_of_upper_edges_alone) {
    const GarmentMesh unsewn = assemble(in_two_parts(tabard(0.4, 0.4, kWaist, 0.2)));
    const std::vector<SeamLink> links = shoulder_links(unsewn);
    ASSERT_FALSE(links.empty());
    for (const SeamLink& link : links) EXPECT_EQ(link.seam, 0);
    EXPECT_TRUE(shoulder_links(assemble(tube(0.5, 0.4, 0.9, 0.2))).empty());
}

// The shoulder seam grazes the top of a column; seams under two arms beside it would be free 11 cm further down.
TEST(SeamClearingLift, does_not_sink_a_shoulder_seam_when_seams_under_the_arms_would_be_free) {
    Body body = shapes::box(Vec3d(-0.15, 0, -0.1), Vec3d(0.15, 1.36, 0.1), 8);
    GarmentMesh unsewn = assemble(tabard(0.25, 0.4, 0.95, 0.2));  // its upper edges are at 1.35 m
    for (const double side : {-1.0, 1.0}) {
        const Body arm = shapes::box(Vec3d(side * 0.35 - 0.1, 1.15, -0.1), Vec3d(side * 0.35 + 0.1, 1.6, 0.1), 8);
        const int first = int(body.x.size());
        body.x.insert(body.x.end(), arm.x.begin(), arm.x.end());
        for (const auto& t : arm.triangles) body.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        for (int i = 0; i < 20; ++i) {
            const int a = int(unsewn.x.size());
            unsewn.x.insert(unsewn.x.end(), {Vec3d(side * 0.35, 1.25, 0.2), Vec3d(side * 0.35, 1.25, -0.2)});
            unsewn.links.push_back({.a = a, .b = a + 1, .seam = 1});
        }
    }
    EXPECT_GE(seam_clearing_lift(unsewn, BodyCollider(body, {.cell = 0.006F, .band = 0.024F})), 0);
}

}  // namespace
}  // namespace selvedge::sim::test
