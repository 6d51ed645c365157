// Checks the test data and the query modes of `bench collide`: moving points, slack distances and dense bodies.
#include <gtest/gtest.h>

#include "bench/collide/collide.h"
#include "bench/collide/contact_pass.h"
#include "sim/collide/body_collider.h"
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
    EXPECT_EQ(every.asked, every.queries);
    EXPECT_LT(some.asked, 0.7 * some.queries);
    ASSERT_EQ(all.size(), spared.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const sim::ClosestPoint& exact = path.exact[i / 1001][i % 1001];
        if (exact.distance < kOffset) {
            EXPECT_EQ(spared[i].distance, all[i].distance);
        }
    }
}

}  // namespace
}  // namespace selvedge::bench
