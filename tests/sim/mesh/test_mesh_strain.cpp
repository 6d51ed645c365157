#include "sim/mesh/mesh_strain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace selvedge {
namespace {

// One triangle, sheared and stretched by a map of the plane.
PlainMesh mapped(const Eigen::Matrix2f& map, float grain) {
    PlainMesh mesh;
    const std::array<Vec2f, 3> u{Vec2f(0.1F, 0.2F), Vec2f(1.3F, 0.1F), Vec2f(0.4F, 0.9F)};
    for (const Vec2f& at : u) {
        const Vec2f x = map * at;
        mesh.x.emplace_back(x.x(), 2.0F, x.y());
    }
    mesh.triangles = {{0, 1, 2}};
    mesh.u = {u};
    mesh.panel = {0};
    mesh.panel_grain_angles = {grain};
    return mesh;
}

TEST(MeshStrain, is_the_stretch_of_the_panels_own_threads) {
    Eigen::Matrix2f map;
    map << 1.02F, 0.05F, 0.0F, 0.97F;
    for (const float grain : {0.0F, 0.4F, -1.2F, 1.5707963F}) {
        const Vec2f warp(-std::sin(grain), std::cos(grain)), weft(std::cos(grain), std::sin(grain));
        const std::vector<MeshStrain> strain = measure_strain(mapped(map, grain));
        ASSERT_EQ(strain.size(), 1U);
        EXPECT_NEAR(strain[0].warp, (map * warp).norm() - 1, 1e-5F) << grain;
        EXPECT_NEAR(strain[0].weft, (map * weft).norm() - 1, 1e-5F) << grain;
    }
}

TEST(MeshStrain, a_triangle_without_area_in_the_material_has_none) {
    PlainMesh mesh = mapped(Eigen::Matrix2f::Identity(), 0);
    mesh.u[0] = {Vec2f(0, 0), Vec2f(1, 1), Vec2f(2, 2)};
    EXPECT_EQ(measure_strain(mesh)[0].warp, 0);
    EXPECT_EQ(smooth_in_panels(mesh, {0.5F})[0][0], 0);
}

TEST(MeshStrain, smoothing_keeps_what_is_even_weighs_by_area_and_stops_at_seams) {
    PlainMesh mesh;
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 3, 0}, {-1, 0, 0}};
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 2, 4}};
    for (const auto& t : mesh.triangles)
        mesh.u.push_back({mesh.x[t[0]].head<2>(), mesh.x[t[1]].head<2>(), mesh.x[t[2]].head<2>()});
    mesh.panel = {0, 0, 1};
    const auto even = smooth_in_panels(mesh, {2, 2, 2});
    for (const auto& corners : even)
        for (const float value : corners) EXPECT_FLOAT_EQ(value, 2);
    const auto corners = smooth_in_panels(mesh, {0, 4, 10});
    EXPECT_FLOAT_EQ(corners[0][0], 0) << "one triangle of its panel only";
    EXPECT_FLOAT_EQ(corners[0][1], 3) << "areas are as one to three";
    EXPECT_FLOAT_EQ(corners[1][0], 3);
    EXPECT_FLOAT_EQ(corners[2][0], 10) << "another panel";
}

}  // namespace
}  // namespace selvedge
