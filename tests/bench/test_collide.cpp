// Checks the test data and the query modes of `bench collide`: moving points, slack distances and dense bodies.
#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "bench/collide/collide.h"
#include "bench/collide/grid_collider.h"
#include "sim/collide/body_collider.h"
#include "sim/core/simd_level.h"
#include "tests/support/bodies.h"

namespace selvedge::bench {
namespace {

TEST(DenseBody, has_the_triangles_asked_for_and_is_closed) {
    const sim::Body coarse = dense_body(17184);
    const sim::Body dense = dense_body(40001);
    EXPECT_EQ(coarse.triangles.size(), 17184U);
    EXPECT_EQ(dense.triangles.size(), 40000U);
    EXPECT_TRUE(sim::shapes::is_closed(dense));
    EXPECT_NEAR(sim::shapes::volume(dense), sim::shapes::volume(coarse), 0.01 * sim::shapes::volume(coarse));
}

// An ellipsoid 1.5 m high, about as tall as a person.
sim::Body column() {
    sim::Body body = sim::shapes::sphere(Vec3d::Zero(), 0.15, 16);
    for (Vec3d& p : body.x) p = Vec3d(p.x(), 0.85 + p.y() * 5, p.z());
    return body;
}

TEST(ClothPoints, stay_near_the_body_and_touch_it_about_as_often_as_cloth_does) {
    const sim::SurfaceBvh surface(column());
    const ClothPoints path = move_cloth_points(surface, {.points = 1000, .steps = 40});
    EXPECT_GT(path.in_contact, 0.2);
    EXPECT_LT(path.in_contact, 0.4);
    for (std::size_t step = 0; step < path.x.size(); ++step)
        for (std::size_t i = 0; i < path.x[step].size(); ++i) {
            EXPECT_GT(path.exact[step][i].distance, -0.025F);
            EXPECT_LT(path.exact[step][i].distance, 0.04F);
            if (step > 0) {
                EXPECT_LT((path.x[step][i] - path.x[step - 1][i]).norm(), 0.03F);
            }
        }
}

TEST(QueryRun, with_slack_asks_fewer_and_misses_none_that_touches) {
    constexpr float kOffset = 0.003F;
    const sim::Body body = column();
    const sim::BodyCollider collider(body);
    const ClothPoints path = move_cloth_points(collider.surface(), {.points = 1001, .steps = 40});
    const QueryPoints points(path);
    std::vector<sim::Contact> all;
    std::vector<sim::Contact> spared;
    const QueryReport every = run_queries(points, collider, ContactWay::InBlocks, kOffset, &all);
    const QueryReport some = run_queries(points, collider, ContactWay::WithSlack, kOffset, &spared);
    EXPECT_EQ(every.queries, 40 * 1001);
    EXPECT_EQ(every.queried, every.queries);
    EXPECT_LT(some.queried, 0.7 * some.queries);
    ASSERT_EQ(all.size(), spared.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const sim::ClosestPoint& exact = path.exact[i / 1001][i % 1001];
        if (exact.distance < kOffset) {
            EXPECT_EQ(spared[i].distance, all[i].distance);
        }
    }
}

}  // namespace

// The grid and BVH colliders against exact distances, and the BVH's group queries at every SIMD level.

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kReach = 0.01F;

sim::Body figure() {
    return sim::shapes::together(sim::shapes::sphere({0.05, 0.3, 0.05}, 0.06, 12),
                                 sim::shapes::box({0, 0, 0}, {0.1, 0.2, 0.08}, 9));
}

std::vector<Vec3f> points_about_figure() {
    std::mt19937 random(23);
    std::uniform_real_distribution<float> wide(-0.03F, 0.13F), tall(-0.03F, 0.4F);
    std::vector<Vec3f> points;
    for (int i = 0; i < 20000; ++i) {
        const float x = wide(random);
        const float y = tall(random);
        points.emplace_back(x, y, wide(random));
    }
    return points;
}

// Expects the exact distance within the reach, and the reach beyond it.
void expect_the_surface(const sim::Collider& collider, const sim::SurfaceBvh& surface) {
    int near = 0;
    for (const Vec3f& p : points_about_figure()) {
        const sim::Contact contact = collider.contact(p);
        const sim::ClosestPoint exact = *surface.closest(p, kFar);
        if (std::abs(exact.distance) >= kReach) {
            EXPECT_EQ(contact.distance, collider.band());
            EXPECT_EQ(contact.normal, Vec3f::Zero());
            continue;
        }
        ++near;
        EXPECT_NEAR(std::abs(contact.distance), std::abs(exact.distance), 1e-6F);
        if (std::abs(exact.distance) > 1e-5F) {
            EXPECT_EQ(contact.distance < 0, exact.distance < 0);
        }
        EXPECT_NEAR(contact.normal.norm(), 1, 1e-4);
    }
    EXPECT_GT(near, 3000);
}

TEST(GridCollider, knows_the_surface_as_far_as_its_reach) {
    const sim::SurfaceBvh surface(figure());
    expect_the_surface(GridCollider(surface, kReach), surface);
}

TEST(GridCollider, of_a_flat_or_an_empty_body_touches_what_there_is) {
    sim::Body flat;
    flat.x = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    flat.triangles = {{0, 2, 1}};
    const sim::SurfaceBvh surface(flat);
    EXPECT_NEAR(GridCollider(surface, kReach).contact({0.2F, 0.005F, 0.2F}).distance, 0.005F, 1e-6F);
    EXPECT_NEAR(GridCollider(surface, kReach).contact({-0.004F, 0, -0.003F}).distance, 0.005F, 1e-6F);
    const sim::SurfaceBvh nothing{sim::Body{}};
    EXPECT_EQ(GridCollider(nothing, kReach).contact({0, 0, 0}).distance, kReach);
}

TEST(BvhCollider, knows_the_surface_as_far_as_its_reach) {
    const sim::SurfaceBvh surface(figure());
    expect_the_surface(BvhCollider(surface, kReach), surface);
}

TEST(SurfaceBvh, has_the_same_bits_at_every_simd_level) {
    const sim::SurfaceBvh fastest(figure());
    const sim::SimdLimit limit(sim::SimdLevel::Plain);
    const sim::SurfaceBvh plain(figure());
    for (const Vec3f& p : points_about_figure()) {
        const sim::ClosestPoint a = *fastest.closest(p, kFar);
        const sim::ClosestPoint b = *plain.closest(p, kFar);
        ASSERT_EQ(a.triangle, b.triangle);
        ASSERT_EQ(a.distance, b.distance);
    }
}

// Groups of points that are close together; the last group is scattered.
std::vector<sim::PointGroup> groups_about_figure(float radius) {
    std::vector<sim::PointGroup> groups;
    const std::vector<Vec3f> points = points_about_figure();
    for (std::size_t g = 0; g < 400; ++g) {
        sim::PointGroup& group = groups.emplace_back();
        for (std::size_t i = 0; i < sim::PointGroup::kPoints; ++i) {
            const Vec3f step(float(i % 3), float(i / 3 % 3), float(i / 9));
            group.start(i, g < 399 ? Vec3f(points[g] + 0.003F * step) : points[400 + i], radius);
        }
    }
    return groups;
}

class GroupsAtLevel : public testing::TestWithParam<sim::SimdLevel> {
 protected:
    void SetUp() override {
        if (GetParam() > sim::detected_simd_level()) GTEST_SKIP() << "not on this processor";
    }
};

TEST_P(GroupsAtLevel, find_what_each_point_would) {
    const sim::SimdLimit limit(GetParam());
    const sim::SurfaceBvh surface(figure());
    constexpr float kRadius = 0.02F;
    int found = 0;
    for (sim::PointGroup& group : groups_about_figure(kRadius)) {
        surface.find_nearest(group);
        for (std::size_t i = 0; i < sim::PointGroup::kPoints; ++i) {
            const float exact = std::abs(surface.closest(group.point(i), kFar)->distance);
            if (group.triangle[i] == sim::NearestTriangle::kNone) {
                EXPECT_GT(exact, kRadius - 1e-6F);
                continue;
            }
            ++found;
            EXPECT_NEAR(std::abs(surface.closest_on(group.triangle[i], group.point(i)).distance), exact, 2e-6F);
            EXPECT_NEAR(std::sqrt(group.squared[i]), exact, 1e-5F);
        }
    }
    EXPECT_GT(found, 2000);
}

TEST_P(GroupsAtLevel, have_the_bits_of_every_other_level) {
    const auto distances_at = [](sim::SimdLevel level) {
        const sim::SimdLimit limit(level);
        const sim::SurfaceBvh surface(figure());
        std::vector<float> squares;
        for (sim::PointGroup& group : groups_about_figure(0.05F)) {
            surface.find_nearest(group);
            squares.insert(squares.end(), group.squared.begin(), group.squared.end());
            for (const std::uint32_t triangle : group.triangle) squares.push_back(float(triangle));
        }
        return squares;
    };
    EXPECT_EQ(distances_at(GetParam()), distances_at(sim::SimdLevel::Plain));
}

std::string simd_level_name(const testing::TestParamInfo<sim::SimdLevel>& info) {
    return std::string(name_of(info.param));
}
INSTANTIATE_TEST_SUITE_P(Kernels, GroupsAtLevel,
                         testing::Values(sim::SimdLevel::Plain, sim::SimdLevel::Avx2, sim::SimdLevel::Avx512),
                         simd_level_name);

}  // namespace

}  // namespace selvedge::bench
