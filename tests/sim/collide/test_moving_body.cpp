#include "sim/collide/moving_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "tests/sim/collide/support.h"
#include "tests/support/bodies.h"

namespace selvedge::sim {
namespace {

// The surface of a ball after a turn, a drift and a deformation that grow with `share`.
std::vector<Vec3f> moved(const Body& body, double share) {
    const Eigen::AngleAxisd turn(0.3 * share, Vec3d(1, 2, 0.5).normalized());
    std::vector<Vec3f> x;
    for (const Vec3d& p : body.x) {
        const Vec3d wave(0, 0, 0.02 * share * std::sin(20 * p.x()));
        x.push_back((turn * (p + wave) + share * Vec3d(0.05, -0.02, 0.01)).cast<float>());
    }
    return x;
}

Body with_positions(Body body, const std::vector<Vec3f>& x) {
    for (std::size_t v = 0; v < x.size(); ++v) body.x[v] = x[v].cast<double>();
    return body;
}

Vec3f random_point(std::mt19937& random, float reach) {
    std::uniform_real_distribution<float> along(-reach, reach);
    const float x = along(random), y = along(random);
    return {x, y, along(random)};
}

TEST(MovingBody, finds_the_surface_where_it_arrived_as_a_hierarchy_that_is_built_there) {
    const Body body = shapes::sphere(Vec3d::Zero(), 0.1, 12);
    MovingBodyCollider moving(body);
    for (const double share : {0.5, 1.0}) {
        moving.move_to(moved(body, share));
        moving.arrive();
    }
    const Body there = with_positions(body, moved(body, 1));
    const SurfaceBvh built(there);
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
        const Vec3f p = random_point(random, 0.2F);
        const auto expected = built.closest(p, std::numeric_limits<float>::infinity());
        const auto found = moving.surface().closest(p, std::numeric_limits<float>::infinity());
        ASSERT_TRUE(expected && found);
        EXPECT_NEAR(found->distance, expected->distance, 1e-6F);
        EXPECT_LT((found->normal - expected->normal).norm(), 0.01F) << "at distance " << expected->distance;
        const Contact contact = moving.contact(p);
        if (std::abs(expected->distance) < MovingBodyCollider::kDeepest) {
            EXPECT_NEAR(contact.distance, expected->distance, 1e-6F);
        } else {
            EXPECT_EQ(contact.distance, moving.band());
        }
    }
    const auto hit = moving.first_hit(Vec3f(0.05F, 0.3F, 0), Vec3f(0.05F, -0.02F, 0));
    const auto expected = built.first_hit(Vec3f(0.05F, 0.3F, 0), Vec3f(0.05F, -0.02F, 0));
    ASSERT_TRUE(hit && expected);
    EXPECT_NEAR(hit->fraction, expected->fraction, 1e-5F);
}

TEST(MovingBody, answers_many_points_at_once_as_one_by_one) {
    const Body body = shapes::sphere(Vec3d::Zero(), 0.1, 12);
    MovingBodyCollider moving(body);
    moving.place(moved(body, 1));
    std::mt19937 random(4);
    std::vector<ContactBlock> blocks(5);
    for (std::size_t i = 0; i < blocks.size() * kContactLanes; ++i)
        blocks[i / kContactLanes].set_point(i % kContactLanes, random_point(random, 0.15F));
    moving.contacts(blocks, 0.003F);
    for (std::size_t i = 0; i < blocks.size() * kContactLanes; ++i) {
        const ContactBlock& block = blocks[i / kContactLanes];
        const Contact one = moving.contact(block.point(i % kContactLanes));
        EXPECT_NEAR(block.distance[i % kContactLanes], one.distance, 1e-6F);
        EXPECT_NEAR(block.nx[i % kContactLanes], one.normal.x(), 1e-4F);
    }
}

TEST(MovingBody, a_known_triangle_changes_nothing_but_where_the_search_starts) {
    const Body body = shapes::sphere(Vec3d::Zero(), 0.1, 12);
    MovingBodyCollider moving(body);
    moving.place(moved(body, 1));
    constexpr float kRadius = 0.05F;
    std::mt19937 random(8);
    std::vector<SearchPoint> points(300);  // not a multiple of sixteen
    for (SearchPoint& point : points) point.x = random_point(random, 0.2F);
    const auto alone = moving.closest(points, kRadius);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % 3 == 1) points[i].known = std::uint32_t(random() % body.triangles.size());  // most are far away
        if (i % 3 == 2 && alone[i]) points[i].known = alone[i]->triangle;
    }
    const auto started = moving.closest(points, kRadius);
    int found = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto exact = moving.surface().closest(points[i].x, kRadius);
        ASSERT_EQ(alone[i].has_value(), exact.has_value());
        ASSERT_EQ(started[i].has_value(), exact.has_value());
        if (!exact) continue;
        ++found;
        EXPECT_NEAR(alone[i]->distance, exact->distance, 1e-6F);
        EXPECT_NEAR(started[i]->distance, exact->distance, 1e-6F);
    }
    EXPECT_GT(found, 50);
    EXPECT_LT(found, 250);
}

TEST(MovingBody, a_tangent_plane_turns_and_travels_with_the_surface) {
    const Body body = shapes::sphere(Vec3d::Zero(), 0.1, 16);
    MovingBodyCollider moving(body);
    const Eigen::AngleAxisd turn(0.1, Vec3d::UnitZ());
    const Vec3d travel(0.01, 0.02, 0);
    std::vector<Vec3f> end;
    for (const Vec3d& p : body.x) end.push_back((turn * p + travel).cast<float>());
    moving.move_to(end);
    EXPECT_NEAR(moving.longest_motion(), 0.0325F, 0.001F);
    EXPECT_NEAR(moving.longest_deformation(), 0.01F, 0.0005F) << "the turn alone";
    const Vec3f p(0.08F, 0.08F, 0.01F);
    const auto closest = moving.surface().closest(p, 1);
    ASSERT_TRUE(closest);
    const TangentPlane plane = moving.plane_at(closest->triangle, p);
    EXPECT_LT((plane.point - closest->point).norm(), 1e-6F);
    const Vec3d at_end = turn * closest->point.cast<double>() + travel;
    EXPECT_LT((plane.point + plane.motion - at_end.cast<float>()).norm(), 1e-5F);
    const Vec3d normal_at_end = turn * closest->normal.cast<double>();
    EXPECT_LT((plane.normal + plane.turn - normal_at_end.cast<float>()).norm(), 0.01F);
}

// What a point may meet is found although it is far away at the start of the step; and what only drifts along with the
// point is not searched.
TEST(MovingBody, a_search_with_a_reach_finds_whatever_comes_so_near_on_the_way) {
    const Body body = shapes::sphere(Vec3d::Zero(), 0.1, 12);
    MovingBodyCollider moving(body);
    const std::vector<Vec3f> end = moved(body, 1);
    moving.move_to(end);
    const std::span<const Vec3f> start = moving.surface().points();
    constexpr float kReach = 0.004F;
    std::mt19937 random(7);
    int met = 0, left_out = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3f p = random_point(random, 0.15F);
        bool comes_near = false;
        for (int k = 0; k <= 20 && !comes_near; ++k) {
            const float t = static_cast<float>(k) / 20;
            const Vec3f at = p + t * moving.surface().drift();
            for (const auto& [a, b, c] : moving.surface().triangles()) {
                const auto now = [&](std::uint32_t v) { return Vec3f(start[v] + t * (end[v] - start[v])); };
                if ((closest_on_triangle(at, now(a), now(b), now(c)).point - at).norm() < kReach) comes_near = true;
            }
        }
        PointGroup group;
        const float radius = kReach + moving.longest_deformation();
        for (std::size_t lane = 0; lane < PointGroup::kPoints; ++lane) group.start(lane, p, radius);
        moving.surface().find_nearest(group, kReach);
        const bool is_found = group.triangle[0] != NearestTriangle::kNone;
        EXPECT_TRUE(is_found || !comes_near);
        met += comes_near ? 1 : 0;
        left_out += is_found ? 0 : 1;
    }
    EXPECT_GT(met, 20);
    EXPECT_GT(left_out, 100);
}

// A finely meshed ball has parts that can be left out.
TEST(MovingBody, leaves_out_what_stays_outside_of_a_region_and_finds_it_again_when_it_is_asked_for) {
    const Body body = shapes::sphere(Vec3d::Zero(), 0.1, 48);
    MovingBodyCollider moving(body);
    const auto beside = [](float x) { return Region(std::vector<Vec3f>{Vec3f(x, 0, 0)}, 0.1F); };
    const Region right = beside(0.16F), left = beside(-0.16F);
    std::mt19937 random(11);
    bool has_left_out = false;
    for (const auto& [share, region] : {std::pair(0.2, right), {0.4, right}, {0.6, left}, {0.8, right}, {1.0, left}}) {
        moving.move_to(moved(body, share), region);
        const Vec3f drift = moving.surface().drift();
        moving.arrive();
        const SurfaceBvh built(with_positions(body, moved(body, share)));
        for (int i = 0; i < 200; ++i) {
            const Vec3f p = random_point(random, 0.12F);
            const auto expected = built.closest(p, kFar), found = moving.surface().closest(p, kFar);
            ASSERT_TRUE(expected && found);
            if (region.contains(Vec3f(expected->point - drift))) {
                EXPECT_NEAR(found->distance, expected->distance, 1e-6F) << "at " << share;
            } else {
                has_left_out = has_left_out || found->distance > expected->distance + 0.01F;
            }
        }
    }
    EXPECT_TRUE(has_left_out);
}

TEST(MovingBody, finds_the_other_side_of_a_crease) {
    // Two boxes with a gap of 2 cm between them, joined as one body.
    Body body = shapes::box(Vec3d(-0.1, 0, -0.1), Vec3d(0, 0.1, 0.1), 4);
    const Body other = shapes::box(Vec3d(0.02, 0, -0.1), Vec3d(0.12, 0.1, 0.1), 4);
    for (const auto& triangle : other.triangles) {
        const int first = static_cast<int>(body.x.size());
        body.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
    body.x.insert(body.x.end(), other.x.begin(), other.x.end());
    const MovingBodyCollider moving(body);
    const Vec3f p(0.005F, 0.05F, 0);
    const auto found = moving.surface().nearest_facing(p, Vec3f::UnitX(), {.most = -0.5F}, 0.03F);
    ASSERT_TRUE(found);
    EXPECT_NEAR(moving.plane_at(*found, p).normal.x(), -1, 1e-4F);
    EXPECT_FALSE(moving.surface().nearest_facing(p, Vec3f::UnitX(), {.most = -0.5F}, 0.01F)) << "15 mm away";
}

}  // namespace
}  // namespace selvedge::sim
