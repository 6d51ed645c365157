// The criteria that the options of adapt_cloth switch on, on moving cloth.
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/solver_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/adaptive/check.h"
#include "sim/collide/collider.h"
#include "tests/sim/cloth/fixtures.h"

namespace selvedge::sim::test {
namespace {

// A cloth of 1 m falls on a ball of 0.25 m, with one adaptation every fourth step.
class Drape : public testing::Test {
 protected:
    const SphereCollider ball_{Vec3f::Zero(), 0.25F};
    Cloth cloth_ = make_patch(find_fabric("cotton_shirting"), {.side = 1.0, .quads = 6, .height = 0.26});
    StepOptions stepping_;
    AdaptClothOptions options_;

    void SetUp() override {
        stepping_.contact.floor = kNoFloor;
        refresh_contacts(cloth_);
    }

    // One adaptation and a thirtieth of a second.
    AdaptReport run_once() {
        const AdaptReport report = adapt_cloth(cloth_, ball_, options_);
        const float step_seconds = cloth_.substep * static_cast<float>(stepping_.substeps);
        for (float t = 0; t < 1.0F / 30 - 1e-4F; t += step_seconds) step(cloth_, ball_, stepping_);
        return report;
    }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(30 * seconds); ++i) run_once();
    }
    std::size_t leaves() const { return cloth_.mesh.leaf_triangles().size(); }
};

TEST_F(Drape, keeps_to_a_triangle_budget_that_steps_up_and_down) {
    TriangleBudget budget({.target = 500});
    options_.budget = &budget;
    run(0.5);
    for (const std::size_t target : {500U, 1200U, 400U, 900U}) {
        budget.set_target(target);
        run(1.0);
        for (int i = 0; i < 15; ++i) {
            run_once();
            EXPECT_NEAR(static_cast<double>(leaves()), static_cast<double>(target), 0.05 * static_cast<double>(target));
        }
        EXPECT_TRUE(check(cloth_.mesh).empty());
    }
    EXPECT_FALSE(find_bad_vertex(cloth_).has_value());
}

TEST_F(Drape, counts_its_transitions_on_demand) {
    TransitionCounts counts;
    options_.transitions = &counts;
    long made = 0;
    for (int i = 0; i < 10; ++i) made += run_once().transitions;
    std::uint64_t counted = 0;
    for (const auto& row : counts.by_configuration)
        for (const std::uint64_t n : row) counted += n;
    EXPECT_GT(made, 0);
    EXPECT_EQ(counted, static_cast<std::uint64_t>(made));
}

TEST(AdaptClothTo, a_viewer_from_below_sees_none_of_the_right_side_so_that_all_of_it_is_coarse) {
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 1.0, .quads = 6});
    const auto adapt_waves = [&](Visibility* visibility) {
        for (int i = 0; i < 4; ++i) {
            for (const VertexId v : cloth.mesh.leaf_vertices())
                cloth.x[v.value].y() = 2 + 0.05F * std::sin(12 * cloth.x[v.value].x());
            adapt_cloth(cloth, NoBody{}, {.visibility = visibility});
        }
        return cloth.mesh.leaf_triangles().size();
    };
    Visibility from_below({.eye = Vec3f(0, -1, 0), .is_orthographic = true});
    Visibility from_above({.eye = Vec3f(0, 1, 0), .is_orthographic = true});
    const std::size_t everywhere = adapt_waves(nullptr);
    ASSERT_GT(everywhere, 2 * cloth.mesh.base_triangle_count());
    EXPECT_EQ(adapt_waves(&from_below), cloth.mesh.base_triangle_count());
    EXPECT_EQ(adapt_waves(&from_above), everywhere);
}

TEST_F(Drape, is_fine_where_it_was_painted) {
    const MinimumLevelDisc disc{.panel = 0, .centre = Vec2f(0.1F, 0.1F), .radius = 0.05F, .level = 2};
    options_.minimum_levels = {&disc, 1};
    for (int i = 0; i < 10; ++i) {
        run_once();
        for (const LeafTriangle& t : cloth_.mesh.leaf_triangles()) {
            if (distance_to_triangle(disc.centre, t.u) <= disc.radius) {
                EXPECT_GE(t.level, 2);
            }
        }
    }
}

TEST_F(Drape, goes_no_deeper_than_asked_for) {
    options_.max_level = 1;
    run(0.5);
    EXPECT_GT(cloth_.mesh.split_edges(0).size(), 0U);
    EXPECT_TRUE(cloth_.mesh.split_edges(1).empty());
}

// The maximum depth below the offset surface, m, of the middles of edges that may be split and of their triangles.
float deepest_middle(const Cloth& cloth, const Collider& body, const SplitLimits& limits) {
    float deepest = 0;
    const auto look = [&](const Vec4f& middle) {
        deepest = std::max(deepest, ContactOptions{}.offset - body.contact(middle.head<3>()).distance);
    };
    for (const LeafEdge& e : cloth.mesh.leaf_edges()) {
        if (limits.allow(cloth.mesh, e.edge)) look((cloth.x[e.a.value] + cloth.x[e.b.value]) / 2);
    }
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        const auto may_split = [&](EdgeId e) { return limits.allow(cloth.mesh, e); };
        if (!std::ranges::any_of(cloth.mesh.triangle(t.triangle).edges, may_split)) continue;
        look((cloth.x[t.v[0].value] + cloth.x[t.v[1].value] + cloth.x[t.v[2].value]) / 3);
    }
    return deepest;
}

TEST_F(Drape, is_split_by_collision_alone_wherever_it_cuts_into_the_ball_and_rejoins_at_once_when_that_is_gone) {
    options_.criteria = {.collision = true, .curvature = false, .length = false};
    const Cloth flat = cloth_;
    for (const float shortest : {0.0F, 0.06F}) {
        cloth_ = flat;
        options_.shortest_edge = shortest;
        run(1.0);
        EXPECT_GT(leaves(), 2 * cloth_.mesh.base_triangle_count());
        for (int i = 0; i < 10 && adapt_cloth(cloth_, ball_, options_).changed(); ++i) continue;
        EXPECT_LT(deepest_middle(cloth_, ball_, {.shortest_edge = shortest}), 0.00201F) << "split_depth";
        for (int i = 0; i < 3; ++i) adapt_cloth(cloth_, NoBody{}, options_);  // one level each
        EXPECT_EQ(leaves(), cloth_.mesh.base_triangle_count());
    }
}

TEST_F(Drape, stays_outside_of_the_ball_between_vertices_whoever_keeps_it_there) {
    const Cloth flat = cloth_;
    std::vector<std::size_t> samples;
    for (const bool splits_on_contact : {true, false}) {
        cloth_ = flat;
        options_.criteria.collision = splits_on_contact;
        run(1.5);
        samples.push_back(sample_count(cloth_.solver->contacts));
        float deepest = 0;
        for (const LeafTriangle& t : cloth_.mesh.leaf_triangles()) {
            for (const Vec3f& share : {Vec3f(0.5F, 0.5F, 0), Vec3f(0, 0.5F, 0.5F), Vec3f(0.5F, 0, 0.5F),
                                       Vec3f(1 / 3.0F, 1 / 3.0F, 1 / 3.0F)}) {
                Vec3f point = Vec3f::Zero();
                for (int k = 0; k < 3; ++k) {
                    point += share[k] * cloth_.x[t.v[static_cast<std::size_t>(k)].value].head<3>();
                }
                deepest = std::max(deepest, -ball_.contact(point).distance);
            }
        }
        EXPECT_EQ(deepest, 0.0F) << (splits_on_contact ? "by splits" : "by samples");
    }
    EXPECT_LT(samples[0], samples[1]);
}

TEST(CollisionCriterion, splits_a_long_edge_that_a_small_ball_touches_far_from_its_middle) {
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.4, .quads = 1});
    const Vec3f corner = cloth.x[0].head<3>();
    const SphereCollider ball{Vec3f(corner.x() / 2, corner.y() - 0.01F, corner.z()), 0.01F};
    EXPECT_GT(adapt_cloth(cloth, ball, {.criteria = {.curvature = false, .length = false}}).splits, 0);
}

TEST(CollisionCriterion, splits_a_triangle_that_a_small_ball_touches_between_its_edges) {
    Cloth cloth = make_patch(find_fabric("silk"), {.side = 0.4, .quads = 1});
    const LeafTriangle& t = cloth.mesh.leaf_triangles()[0];
    const Vec4f centroid = (cloth.x[t.v[0].value] + cloth.x[t.v[1].value] + cloth.x[t.v[2].value]) / 3;
    const SphereCollider ball{Vec3f(centroid.head<3>()), 0.01F};
    const AdaptClothOptions options{.criteria = {.curvature = false, .length = false}};
    for (const LeafEdge& e : cloth.mesh.leaf_edges()) {
        for (const float share : {0.0F, 0.25F, 0.5F, 0.75F}) {
            const Vec4f point = cloth.x[e.a.value] * (1 - share) + cloth.x[e.b.value] * share;
            ASSERT_GT(ball.contact(point.head<3>()).distance, 0.05F) << "an edge is near the ball as well";
        }
    }
    EXPECT_GT(adapt_cloth(cloth, ball, options).splits, 0);
    EXPECT_GT(adapt_cloth(cloth, NoBody{}, options).rejoins, 0) << "without the ball";
}

TEST_F(Drape, that_is_compressed_along_the_mesh_is_split_as_deep_as_it_may) {
    options_.criteria = {.collision = false, .curvature = false, .length = true};
    options_.shortest_edge = 0;
    for (const VertexId v : cloth_.mesh.leaf_vertices()) cloth_.x[v.value].x() *= 0.9F;
    for (int i = 0; i < 5; ++i) adapt_cloth(cloth_, ball_, options_);
    EXPECT_GT(cloth_.mesh.split_edges(2).size(), 0U) << "edges across the compression never ask themselves";
}

TEST_F(Drape, asks_for_buckling_when_that_alone_is_switched_on) {
    options_.criteria = {.collision = false, .curvature = false, .length = false, .buckling = true};
    options_.shortest_edge = 0;
    EXPECT_FALSE(adapt_cloth(cloth_, ball_, options_).changed()) << "flat and at rest";
    for (const VertexId v : cloth_.mesh.leaf_vertices()) cloth_.x[v.value].x() *= 0.97F;
    EXPECT_GT(adapt_cloth(cloth_, ball_, options_).splits, 0);
}

}  // namespace
}  // namespace selvedge::sim::test
