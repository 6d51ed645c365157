#include "render/scene/solids.h"

#include <gtest/gtest.h>

#include <map>

namespace selvedge {
namespace {

double volume(const SolidItem& solid) {
    double six_times = 0;
    for (const auto& [a, b, c] : solid.triangles)
        six_times += static_cast<double>(solid.x[a].dot(solid.x[b].cross(solid.x[c])));
    return six_times / 6;
}

// Edges that no second triangle runs the other way.
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

}  // namespace
}  // namespace selvedge
