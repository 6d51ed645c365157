#include <gtest/gtest.h>
#include <algorithm>
#include <map>

#include "render/scene/solids.h"

namespace selvedge::render {
namespace {

double volume(const SolidItem& solid) {
    double six_times = 0;
    for (const auto& [a, b, c] : solid.triangles)
        six_times += static_cast<double>(solid.x[a].dot(solid.x[b].cross(solid.x[c])));
    return six_times / 6;
}

// Number of edges that no second triangle uses in the opposite direction.
std::size_t open_edges(const SolidItem& solid) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& t : solid.triangles) {
        for (std::size_t i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
    }
    std::size_t open = 0;
    for (const auto& [edge, count] : uses) open += uses.contains({edge.second, edge.first}) && count == 1 ? 0 : 1;
    return open;
}

TEST(Solids, a_ball_is_closed_round_and_faces_outward) {
    for (const BallDetail detail : {BallDetail::Coarse, BallDetail::Fine}) {
        SolidItem solid;
        const Vec3f centre(1, 2, 3);
        add_ball(solid, centre, 0.5F, {1, 2, 3}, detail);
        EXPECT_EQ(open_edges(solid), 0U);
        EXPECT_EQ(solid.triangles.size(), detail == BallDetail::Coarse ? 80U : 320U);
        for (std::size_t i = 0; i < solid.x.size(); ++i) {
            EXPECT_NEAR((solid.x[i] - centre).norm(), 0.5F, 1e-5F);
            EXPECT_NEAR((solid.x[i] - centre).normalized().dot(solid.normals[i]), 1, 1e-5F);
        }
        EXPECT_NEAR(volume(solid), 0.5236, detail == BallDetail::Coarse ? 0.075 : 0.02) << "positive: outward";
    }
}

TEST(Solids, a_tube_keeps_its_radius_round_a_bend_and_passes_over_repeated_points) {
    SolidItem solid;
    add_tube(solid, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0.01F, {9, 9, 9});
    ASSERT_FALSE(solid.x.empty());
    for (const Vec3f& x : solid.x) {
        EXPECT_TRUE(x.allFinite());
        const float to_first = std::hypot(x.y(), x.z()), to_second = std::hypot(x.x() - 1, x.z());
        EXPECT_LT(std::min(to_first, to_second), 0.0105F);
    }
    EXPECT_EQ(solid.normals.size(), solid.x.size());
    EXPECT_EQ(solid.colours.size(), solid.x.size());
}

TEST(Solids, a_path_of_one_point_and_a_triangle_without_area_leave_nothing_broken) {
    SolidItem solid;
    add_tube(solid, {{0, 0, 0}, {0, 0, 0}}, 0.01F, {9, 9, 9});
    EXPECT_TRUE(solid.x.empty());
    add_outline(solid, {Vec3f::Zero(), Vec3f::Zero(), Vec3f::UnitX()}, 0.01F, {9, 9, 9});
    for (const Vec3f& x : solid.x) EXPECT_TRUE(x.allFinite());
}

using Corners = std::array<Vec2f, 3>;

// Two panels of one base triangle each; the first one is split into four triangles of level 1.
sim::TriangleHierarchy two_panels() {
    const Vec2f a(0, 0), b(0.4F, 0), c(0, 0.4F);
    const Vec2f ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    sim::TriangleHierarchy all{{.u = {a, b, c}, .panel = 0, .level = 0, .is_leaf = false}};
    for (const Corners& u : {Corners{a, ab, ca}, Corners{b, bc, ab}, Corners{c, ca, bc}, Corners{ab, bc, ca}})
        all.push_back({.u = u, .panel = 0, .level = 1, .is_leaf = true});
    all.push_back({.u = {a, b, c}, .panel = 1, .level = 0, .is_leaf = true});
    return all;
}

TEST(HierarchyModel, leaves_lie_flat_once_and_stand_at_their_levels_height_once) {
    const HierarchyModel model = model_hierarchy(two_panels(), StackSide::Right);
    ASSERT_EQ(model.mesh.triangles.size(), 10U);
    ASSERT_EQ(model.refined.size(), 1U);
    float height = 0;
    int raised = 0;
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        const float y = model.mesh.x[model.mesh.triangles[t][0]].y();
        for (const std::uint32_t v : model.mesh.triangles[t]) EXPECT_EQ(model.mesh.x[v].y(), y);
        if (y == 0) continue;
        EXPECT_EQ(model.mesh.level[t], 1);
        height = y;
        ++raised;
    }
    EXPECT_EQ(raised, 4);
    EXPECT_GT(height, 0.05F);
    for (const Vec3f& x : model.refined[0].x) EXPECT_EQ(x.y(), 0) << "a refined triangle of level 0 lies at height 0";
}

TEST(HierarchyModel, is_as_large_as_the_panels_are) {
    const HierarchyModel model = model_hierarchy(two_panels(), StackSide::Behind);
    const auto& [a, b, c] = model.mesh.triangles.back();
    EXPECT_NEAR((model.mesh.x[b] - model.mesh.x[a]).norm(), 0.4F, 1e-6F);
    EXPECT_NEAR((model.mesh.x[c] - model.mesh.x[a]).norm(), 0.4F, 1e-6F);
}

TEST(HierarchyModel, panels_and_stack_lie_beside_each_other) {
    for (const StackSide side : {StackSide::Right, StackSide::Behind}) {
        const HierarchyModel model = model_hierarchy(two_panels(), side);
        const int axis = side == StackSide::Right ? 0 : 2;
        float flat_end = -1e9F, stack_begin = 1e9F;
        for (std::size_t t = 0; t < 10; ++t) {
            const bool is_stack = t % 2 == 1;  // each leaf is added twice: flat, then in the stack
            for (const std::uint32_t v : model.mesh.triangles[t]) {
                const float at = axis == 0 ? model.mesh.x[v].x() : -model.mesh.x[v].z();
                if (is_stack)
                    stack_begin = std::min(stack_begin, at);
                else
                    flat_end = std::max(flat_end, at);
            }
        }
        EXPECT_GT(stack_begin, flat_end);
    }
}

TEST(HierarchyModel, faces_up_and_shares_the_vertices_of_a_panel) {
    const HierarchyModel model = model_hierarchy(two_panels(), StackSide::Right);
    for (const Vec3f& normal : model.mesh.normals) EXPECT_GT(normal.y(), 0.99F);
    EXPECT_EQ(model.mesh.x.size(), 2U * (6 + 3));
}

}  // namespace

}  // namespace selvedge::render
