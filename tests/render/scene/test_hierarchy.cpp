#include "render/scene/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace selvedge {
namespace {

using Corners = std::array<Vec2f, 3>;

// Two panels of one base triangle each; the first is cut in four, at level 1.
TriangleHierarchy two_panels() {
    const Vec2f a(0, 0), b(0.4F, 0), c(0, 0.4F);
    const Vec2f ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    TriangleHierarchy all{{.u = {a, b, c}, .panel = 0, .level = 0, .is_leaf = false}};
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
            const bool is_stack = t % 2 == 1;  // each leaf is laid flat, then raised
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
}  // namespace selvedge
