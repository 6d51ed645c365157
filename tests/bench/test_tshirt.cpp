// Parts of the T-shirt experiment: denser bodies, swaying cloth and the JSON.
#include "bench/tshirt/tshirt.h"
#include "sim/cloth/contact.h"

#include <gtest/gtest.h>

#include <map>

#include "bench/support/measured_mesh.h"
#include "sim/collide/collider.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

sim::Body tetrahedron() {
    return {.name = "tetrahedron",
            .x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
            .bones = {},
            .skin = {}};
}

double volume(const sim::Body& body) {
    double sum = 0;
    for (const auto& t : body.triangles) {
        const auto at = [&](int i) { return body.x[static_cast<std::size_t>(i)]; };
        sum += at(t[0]).dot(at(t[1]).cross(at(t[2]))) / 6;
    }
    return sum;
}

TEST(SplitTriangles, keeps_the_shape_and_closes_every_edge) {
    for (const int wanted : {4, 5, 16, 17, 100}) {
        const sim::Body split = split_triangles(tetrahedron(), wanted);
        EXPECT_GE(static_cast<int>(split.triangles.size()), wanted);
        EXPECT_NEAR(volume(split), 1.0 / 6, 1e-12);
        EXPECT_EQ(split.x.size() * 2, split.triangles.size() + 4);  // Euler: a closed surface without handles
        std::map<std::array<int, 2>, int> sides;
        for (const auto& t : split.triangles)
            for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
        for (const auto& [edge, count] : sides) {
            EXPECT_EQ(count, 1);
            EXPECT_EQ(sides.count({edge[1], edge[0]}), 1U);
        }
    }
}

TEST(SplitTriangles, takes_the_least_square_that_suffices) {
    EXPECT_EQ(split_triangles(tetrahedron(), 4).triangles.size(), 4U);
    EXPECT_EQ(split_triangles(tetrahedron(), 5).triangles.size(), 16U);
    EXPECT_EQ(split_triangles(tetrahedron(), 17).triangles.size(), 36U);
}

SwayStatistics sway_square() {
    sim::Cloth cloth = make_cloth(sim::make_square({.height = 0.5}), {sim::Fabric{}});
    refresh_contacts(cloth);
    return sway(cloth, sim::SphereCollider(Vec3f::Zero(), 0.45F), {.cycles = 12, .settling_cycles = 3});
}

TEST(Sway, measures_shares_between_nothing_and_all) {
    const SwayStatistics statistics = sway_square();
    EXPECT_GE(statistics.leaf_triangles, 32);
    EXPECT_GT(statistics.ms_median, 0);
    EXPECT_GE(statistics.ms_p95, statistics.ms_median);
    EXPECT_GT(statistics.adapt_share, 0);
    EXPECT_LT(statistics.adapt_share, 1);
    EXPECT_LT(statistics.collision_share, 1);
    EXPECT_GT(statistics.p99_stretch, 0);
    EXPECT_FALSE(statistics.allocations_per_step);
}

TEST(TshirtReport, has_every_figure_that_was_promised) {
    TshirtReport report;
    report.rows.push_back({.what = "a", .body_triangles = 4, .statistics = sway_square()});
    const sim::Json one = to_json(report);
    for (const char* key :
         {"leaf_triangles", "ms_adapt_plus_4_steps", "adapt_share", "collision_share", "p99_stretch"}) {
        ASSERT_NE(one.find(key), nullptr) << key;
        EXPECT_TRUE(one.find(key)->is_number()) << key;
    }
    EXPECT_EQ(one.find("growth_with_body"), nullptr);
    report.rows.resize(4, report.rows[0]);
    report.rows[1].statistics.ms_median = 2 * report.rows[0].statistics.ms_median;
    report.rows[3].statistics.ms_median = 3 * report.rows[2].statistics.ms_median;
    const sim::Json all = to_json(report);
    EXPECT_NEAR(all.find("growth_with_body")->number(), 2, 1e-12);
    EXPECT_NEAR(all.find("us_per_leaf_growth_with_leaves")->number(), 3, 1e-12);
}

}  // namespace
}  // namespace selvedge::bench
