#include "sim/repair/outer_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/body/section.h"
#include "tests/support/bodies.h"
#include "tests/support/body_checks.h"

namespace selvedge::sim {
namespace {

constexpr double kCell = 0.006;  // m

Surface surface_of(const Body& body) {
    Surface surface{.x = body.x, .triangles = body.triangles, .origin = {}};
    for (std::size_t v = 0; v < body.x.size(); ++v) surface.origin.push_back(int(v));
    return surface;
}

Body hull_of(const Body& pieces) {
    const Surface hull = outer_hull(surface_of(pieces), {.cell = kCell, .highest_groove = 0});
    Body body;
    body.x = hull.x;
    body.triangles = hull.triangles;
    return body;
}

TEST(OuterHull, of_overlapping_balls_is_one_closed_surface_round_both) {
    constexpr double kRadius = 0.1, kApart = 0.12;  // m
    const Body balls =
        shapes::together(shapes::sphere({0, 0, 0}, kRadius, 20), shapes::sphere({kApart, 0, 0}, kRadius, 20));
    const Body hull = hull_of(balls);
    EXPECT_TRUE(is_closed_manifold(hull)) << "one piece";
    const double lens = std::numbers::pi * (4 * kRadius + kApart) * std::pow(2 * kRadius - kApart, 2) / 12;
    const double both = 8 * std::numbers::pi * std::pow(kRadius, 3) / 3 - lens;
    EXPECT_NEAR(volume(hull), both, 0.015 * both) << "outward, and the balls' own facets lose 1 %";
    for (const Vec3d& p : hull.x) {
        const double nearest = std::min(p.norm(), (p - Vec3d(kApart, 0, 0)).norm());
        EXPECT_GT(nearest, kRadius - 0.0015) << "no wall inside, but for the crease between the balls";
    }
}

TEST(OuterHull, keeps_the_girth_of_a_limb) {
    constexpr double kRadius = 0.04;  // m, of an arm
    const Body arm = shapes::sphere({0.013, 0.021, 0.034}, kRadius, 30);
    const auto loops = section(hull_of(arm), {.point = Vec3d(0, 0.021, 0)});
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_NEAR(tape_length(loops[0], {.point = Vec3d(0, 0.021, 0)}), 2 * std::numbers::pi * kRadius,
                std::numbers::pi * kCell * kCell / kRadius);
}

TEST(OuterHull, has_nothing_inside_a_hollow_that_the_pieces_enclose) {
    constexpr double kSide = 0.2, kWall = 0.02;  // m
    Body walls;
    for (int axis = 0; axis < 3; ++axis)
        for (const double at : {0.0, kSide - kWall}) {
            Vec3d low = Vec3d::Zero(), high = Vec3d::Constant(kSide);
            low[axis] = at;
            high[axis] = at + kWall;
            walls = shapes::together(walls, shapes::box(low, high, 2));
        }
    const Body hull = hull_of(walls);
    EXPECT_TRUE(is_closed_manifold(hull));
    EXPECT_NEAR(volume(hull), std::pow(kSide, 3), 0.02 * std::pow(kSide, 3)) << "its edges are blunt";
}

TEST(OuterHull, joins_parts_that_are_apart_but_only_the_nearest_ones) {
    // A trunk over two legs, which are nearer to it than to each other.
    const Body legs = shapes::together(shapes::box({-0.1, 0, 0}, {-0.02, 0.3, 0.1}, 6),
                                       shapes::box({0.02, 0, 0}, {0.1, 0.3, 0.1}, 6));
    const Body all = shapes::together(legs, shapes::box({-0.1, 0.32, 0}, {0.1, 0.6, 0.1}, 6));
    const Body hull = hull_of(all);
    EXPECT_TRUE(is_closed_manifold(hull)) << "one piece, and no ring from leg to leg";
    EXPECT_EQ(section(hull, {.point = Vec3d(0, 0.2, 0)}).size(), 2U);
    const auto gap = section(hull, {.point = Vec3d(0, 0.31, 0)});
    ASSERT_EQ(gap.size(), 2U);
    EXPECT_NEAR(gap[0].area, 0.09 * 0.11, 0.001) << "m^2: all of the way between them, and a cell beside it";
}

TEST(OuterHull, leaves_apart_what_is_farther_than_the_widest_gap) {
    const Body balls = shapes::together(shapes::sphere({0, 0, 0}, 0.05, 12), shapes::sphere({0.2, 0, 0}, 0.05, 12));
    EXPECT_FALSE(is_closed_manifold(hull_of(balls))) << "two pieces";
    EXPECT_TRUE(shapes::is_closed(hull_of(balls)));
}

TEST(OuterHull, goes_straight_over_a_groove_that_is_lower_than_a_waistband) {
    const Body lower = shapes::box({-0.1, 0, -0.1}, {0.1, 0.2, 0.1}, 6),
               upper = shapes::box({-0.1, 0.22, -0.1}, {0.1, 0.4, 0.1}, 6);
    const Body ball = shapes::sphere({0, 0.21, 0}, 0.04, 8);
    const Surface pieces = surface_of(shapes::together(shapes::together(lower, upper), ball));
    const auto girth = [&](double highest_groove) {
        const Surface hull = outer_hull(pieces, {.cell = kCell, .widest_gap = 0, .highest_groove = highest_groove});
        Body body;
        body.x = hull.x;
        body.triangles = hull.triangles;
        const Plane plane{.point = Vec3d(0, 0.21, 0)};
        const auto loops = section(body, plane);
        return loops.empty() ? 0 : tape_length(loops[0], plane);
    };
    EXPECT_NEAR(girth(0.03), 0.8, 0.03) << "m";
    EXPECT_NEAR(girth(0.01), 0.25, 0.01) << "m: it is higher than that, and the ball is in it";
}

TEST(OuterHull, has_nothing_inside_a_shell_with_a_narrow_gap) {
    // A shell of armour, 2 cm thick, open at its top by 3 cm.
    constexpr double kSide = 0.3, kWall = 0.02, kGap = 0.03;  // m
    Body walls = shapes::box({0, 0, 0}, {kSide, kWall, kSide}, 4);
    for (const double at : {0.0, kSide - kWall}) {
        walls = shapes::together(walls, shapes::box({at, 0, 0}, {at + kWall, kSide, kSide}, 4));
        walls = shapes::together(walls, shapes::box({0, 0, at}, {kSide, kSide, at + kWall}, 4));
    }
    const double half = (kSide - kGap) / 2;
    walls = shapes::together(walls, shapes::box({0, kSide - kWall, 0}, {half, kSide, kSide}, 4));
    walls = shapes::together(walls, shapes::box({kSide - half, kSide - kWall, 0}, {kSide, kSide, kSide}, 4));
    EXPECT_GT(volume(hull_of(walls)), 0.95 * std::pow(kSide, 3)) << "m^3";
}

TEST(OuterHull, is_a_manifold_where_pieces_meet_at_an_edge_or_a_corner_only) {
    const Body first = shapes::box(Vec3d::Zero(), Vec3d::Constant(0.1), 3);
    const double beside = 0.1 + 0.3 * kCell;  // nearer than the cells tell apart
    for (const Vec3d& low : {Vec3d(beside, beside, 0), Vec3d(beside, beside, beside), Vec3d(-beside, beside, beside)}) {
        const Body both = shapes::together(first, shapes::box(low, low + Vec3d::Constant(0.1), 3));
        EXPECT_TRUE(shapes::is_closed(hull_of(both))) << low.transpose();
    }
}

TEST(OuterHull, takes_the_skin_of_the_vertex_nearest_to_it) {
    const Body balls = shapes::together(shapes::sphere({0, 0, 0}, 0.05, 12), shapes::sphere({0.2, 0, 0}, 0.05, 12));
    const Surface pieces = surface_of(balls);
    const Surface hull = outer_hull(pieces, {.cell = kCell});
    ASSERT_EQ(hull.origin.size(), hull.x.size());
    for (std::size_t v = 0; v < hull.x.size(); ++v)
        EXPECT_LT((balls.x[std::size_t(hull.origin[v])] - hull.x[v]).norm(), 0.012) << "m: a triangle's side";
}

TEST(OuterHull, is_made_of_parts_that_count_only) {
    const Body body = shapes::sphere(Vec3d::Zero(), 0.3, 12);
    EXPECT_FALSE(is_of_parts(surface_of(body)));
    EXPECT_FALSE(is_of_parts(surface_of(shapes::together(body, shapes::sphere({0, 0.3, 0}, 0.012, 6))))) << "an eye";
    EXPECT_TRUE(is_of_parts(surface_of(shapes::together(body, shapes::sphere({0.35, 0, 0}, 0.06, 6))))) << "a hand";
}

}  // namespace
}  // namespace selvedge::sim
