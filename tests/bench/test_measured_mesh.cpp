// The measurements of measured_mesh.h, on hand-made positions.
#include "bench/support/measured_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bench/support/square.h"

namespace selvedge::bench {
namespace {

constexpr int kQuads = 10;

sim::GarmentMesh grid() {
    return make_square({.columns = kQuads, .rows = kQuads});
}

template <class Move>
std::vector<Vec3d> moved(const sim::GarmentMesh& mesh, Move&& move) {
    std::vector<Vec3d> x;
    for (const Vec3d& p : mesh.x) x.push_back(move(p));
    return x;
}

TEST(MeasuredMesh, takes_grid_edges_for_threads_and_leaves_diagonals_out) {
    const MeasuredMesh mesh = measured(grid());
    EXPECT_EQ(mesh.yarn_edges.size(), 2U * kQuads * (kQuads + 1));
    EXPECT_EQ(mesh.triangles.size(), 2U * kQuads * kQuads);
    EXPECT_EQ(mesh.vertices.size(), std::size_t((kQuads + 1) * (kQuads + 1)));
    EXPECT_NEAR(mesh.rest_area, 1, 1e-12);
    for (const YarnEdge& edge : mesh.yarn_edges) EXPECT_NEAR(edge.rest_length, 1.0 / kQuads, 1e-12);
}

TEST(MeasuredMesh, takes_diagonals_for_threads_where_the_grain_lies_at_45_degrees) {
    sim::GarmentMesh bias = grid();
    bias.panel_grain_angles = {std::numbers::pi / 4};
    EXPECT_EQ(measured(bias).yarn_edges.size(), std::size_t(kQuads * kQuads));
}

TEST(MeasuredMesh, cloth_stretched_by_3_percent_one_way_has_a_p99_of_3_percent) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    const std::vector<Vec3d> x = moved(square, [](const Vec3d& p) { return Vec3d(1.03 * p.x(), p.y(), p.z()); });
    const YarnStretch stretch = yarn_stretch(mesh, x);
    EXPECT_NEAR(stretch.p99, 0.03, 1e-12);
    EXPECT_NEAR(stretch.max, 0.03, 1e-12);
    EXPECT_NEAR(stretch.p1, 0, 1e-12);
    EXPECT_NEAR(area_ratio(mesh, x), 1.03, 1e-12);
}

TEST(MeasuredMesh, compression_shows_in_the_first_percentile_and_the_area) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    const std::vector<Vec3d> x = moved(square, [](const Vec3d& p) { return Vec3d(p.x(), p.y(), 0.9 * p.z()); });
    EXPECT_NEAR(yarn_stretch(mesh, x).p1, -0.1, 1e-12);
    EXPECT_NEAR(yarn_stretch(mesh, x).p99, 0, 1e-12);
    EXPECT_NEAR(area_ratio(mesh, x), 0.9, 1e-12);
}

TEST(MeasuredMesh, shear_stretches_no_thread) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    const double angle = 0.3;
    const std::vector<Vec3d> x = moved(
        square, [&](const Vec3d& p) { return Vec3d(p.x() + std::sin(angle) * p.z(), 0, std::cos(angle) * p.z()); });
    EXPECT_NEAR(yarn_stretch(mesh, x).max, 0, 1e-12);
    EXPECT_NEAR(yarn_stretch(mesh, x).p1, 0, 1e-12);
    EXPECT_NEAR(area_ratio(mesh, x), std::cos(angle), 1e-12);
}

TEST(MeasuredMesh, tells_numbers_that_are_none) {
    const sim::GarmentMesh square = grid();
    const MeasuredMesh mesh = measured(square);
    std::vector<Vec3d> x = square.x;
    EXPECT_TRUE(all_finite(mesh, x));
    x[5].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(all_finite(mesh, x));
}

TEST(MeasuredMesh, a_shift_is_its_own_mean_and_rms_distance) {
    const sim::GarmentMesh square = grid();
    const std::vector<Vec3d> x = moved(square, [](const Vec3d& p) { return Vec3d(p + Vec3d(0.003, 0, 0.004)); });
    const ShapeDistance distance = shape_distance(measured(square), square.x, x);
    EXPECT_NEAR(distance.mean, 0.005, 1e-12);
    EXPECT_NEAR(distance.rms, 0.005, 1e-12);
}

}  // namespace
}  // namespace selvedge::bench
