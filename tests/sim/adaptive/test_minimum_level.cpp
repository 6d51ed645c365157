#include "sim/adaptive/minimum_level.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/adaptive/check.h"
#include "sim/adaptive/criteria.h"
#include "sim/adaptive/square.h"
#include "sim/adaptive/uniform.h"
#include "tests/sim/adaptive/fixtures.h"

namespace selvedge::test {
namespace {

// Agrees to every rejoin and asks for nothing.
struct AlwaysRejoin {
    bool wants_split(const AdaptiveMesh&, EdgeId) const { return false; }
    bool allows_rejoin(const AdaptiveMesh&, EdgeId) const { return true; }
};

int coarsest_in(const AdaptiveMesh& mesh, const MinimumLevelDisc& disc) {
    int coarsest = kDeepestLevel;
    for (const LeafTriangle& t : mesh.leaf_triangles()) {
        if (t.panel == disc.panel && distance_to_triangle(disc.centre, t.u) <= disc.radius)
            coarsest = std::min(coarsest, int{t.level});
    }
    return coarsest;
}

TEST(DistanceToTriangle, is_nothing_inside_and_the_way_to_the_nearest_side_or_corner_outside) {
    const std::array<Vec2f, 3> t{Vec2f(0, 0), Vec2f(4, 0), Vec2f(0, 4)};
    EXPECT_EQ(distance_to_triangle({1, 1}, t), 0);
    EXPECT_FLOAT_EQ(distance_to_triangle({1, -2}, t), 2);
    EXPECT_FLOAT_EQ(distance_to_triangle({-3, -4}, t), 5);
    EXPECT_FLOAT_EQ(distance_to_triangle({3, 3}, t), std::sqrt(2.0F));
}

TEST(MinimumLevel, makes_every_leaf_that_touches_the_disc_fine_enough_and_leaves_the_rest_coarse) {
    const GarmentMesh base = make_square({.columns = 8, .rows = 8});
    const Vec2f middle = (base.triangles[60].u[0]).cast<float>();
    for (const int level : {1, 2, 3}) {
        for (const float radius : {0.0F, 0.05F, 0.2F}) {
            AdaptiveMesh mesh(base);
            NoState state;
            const MinimumLevelDisc disc{.panel = 0, .centre = middle, .radius = radius, .level = level};
            const MinimumLevelCriterion criterion{{&disc, 1}};
            adapt(mesh, state, {}, criterion);
            EXPECT_TRUE(check(mesh).empty());
            EXPECT_EQ(coarsest_in(mesh, disc), level) << radius;
            EXPECT_LT(mesh.leaf_triangles().size(), base.triangles.size() * (std::size_t{1} << (2 * level)) * 3 / 4);
            EXPECT_FALSE(adapt(mesh, state, {}, criterion).changed());
        }
    }
}

TEST(MinimumLevel, holds_its_region_when_all_others_agree_to_rejoin) {
    AdaptiveMesh mesh(make_square({.columns = 4, .rows = 4}));
    NoState state;
    set_uniform_level(mesh, state, 3);
    const MinimumLevelDisc disc{.panel = 0, .centre = Vec2f::Zero(), .radius = 0.1F, .level = 2};
    adapt(mesh, state, {}, AlwaysRejoin{}, MinimumLevelCriterion{{&disc, 1}});
    EXPECT_EQ(coarsest_in(mesh, disc), 2);
    EXPECT_LT(mesh.leaf_triangles().size(), 32U * 16U);
}

TEST(MinimumLevel, is_of_one_panel_only) {
    AdaptiveMesh mesh(front_and_back(6, 1.0));
    NoState state;
    const MinimumLevelDisc disc{.panel = 1, .centre = mesh.leaf_triangles().back().u[0], .radius = 0, .level = 2};
    adapt(mesh, state, {}, MinimumLevelCriterion{{&disc, 1}});
    const auto fine_in = [&](int panel) {
        const auto leaves = mesh.leaf_triangles();
        return std::count_if(leaves.begin(), leaves.end(),
                             [&](const LeafTriangle& t) { return t.panel == panel && t.level == 2; });
    };
    EXPECT_GT(fine_in(1), fine_in(0));
}

TEST(MinimumLevel, does_nothing_without_discs) {
    AdaptiveMesh mesh(make_square());
    NoState state;
    EXPECT_FALSE(adapt(mesh, state, {}, MinimumLevelCriterion{}).changed());
}

}  // namespace
}  // namespace selvedge::test
