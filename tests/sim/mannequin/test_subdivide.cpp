#include <gtest/gtest.h>
#include <cmath>

#include "sim/mannequin/curves.h"
#include "sim/mannequin/subdivide.h"

namespace selvedge::sim {
namespace {

// A cube of 6 quads and 8 vertices; the fourth column marks its top.
QuadMesh cube() {
    QuadMesh mesh;
    mesh.values.resize(8, 4);
    for (int v = 0; v < 8; ++v) {
        const int x = v & 1;
        const int y = (v >> 1) & 1;
        const int z = (v >> 2) & 1;
        mesh.values.row(v) << 2 * x - 1, 2 * y - 1, 2 * z - 1, y;
    }
    mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return mesh;
}

double volume(const QuadMesh& mesh) {
    double six = 0;
    for (const auto& [a, b, c] : split_quads(mesh)) {
        const Vec3d x = mesh.values.row(a).head<3>();
        const Vec3d y = mesh.values.row(b).head<3>();
        const Vec3d z = mesh.values.row(c).head<3>();
        six += x.dot(y.cross(z));
    }
    return six / 6;
}

TEST(Subdivide, of_a_cube_gives_the_known_vertices) {
    const QuadMesh fine = subdivide(cube());
    ASSERT_EQ(fine.values.rows(), 8 + 12 + 6);
    ASSERT_EQ(fine.quads.size(), 24U);
    // Old corner: (mean of centres 1/3 + 2 mean of midpoints 2/3 + 0) / 3 = 5/9.
    EXPECT_NEAR(fine.values(7, 0), 5.0 / 9, 1e-14);
    // Edge: mean of the midpoint (1, 1) and of two centres (1, 0), (0, 1).
    for (Eigen::Index v = 8; v < 20; ++v) EXPECT_NEAR(fine.values.row(v).head<3>().norm(), std::sqrt(2) * 0.75, 1e-14);
    for (Eigen::Index v = 20; v < 26; ++v) EXPECT_NEAR(fine.values.row(v).head<3>().norm(), 1, 1e-14);
}

TEST(Subdivide, keeps_quads_facing_outward) {
    QuadMesh mesh = cube();
    EXPECT_NEAR(volume(mesh), 8, 1e-12);
    for (int step = 0; step < 3; ++step) {
        const double before = volume(mesh);
        mesh = subdivide(mesh);
        EXPECT_GT(volume(mesh), 0.4 * before);
        EXPECT_LT(volume(mesh), before);
    }
}

TEST(Subdivide, carries_other_values_as_it_carries_positions) {
    const QuadMesh fine = subdivide(subdivide(cube()));
    for (Eigen::Index v = 0; v < fine.values.rows(); ++v) {
        EXPECT_NEAR(fine.values(v, 3), (fine.values(v, 1) + 1) / 2, 1e-14);
    }
}

TEST(MoveToLimit, agrees_with_many_steps) {
    QuadMesh limit = cube();
    move_to_limit(limit);
    QuadMesh fine = cube();
    for (int step = 0; step < 6; ++step) fine = subdivide(fine);
    for (Eigen::Index v = 0; v < 8; ++v) {
        EXPECT_NEAR((fine.values.row(v) - limit.values.row(v)).norm(), 0, 1e-3);
    }
}

TEST(MoveToLimit, gives_the_same_place_at_every_step) {
    QuadMesh early = subdivide(cube());
    QuadMesh late = subdivide(subdivide(early));
    move_to_limit(early);
    move_to_limit(late);
    const Eigen::Index count = early.values.rows();
    EXPECT_LT((late.values.topRows(count) - early.values).norm(), 1e-12);
}

TEST(SplitQuads, cuts_the_shorter_diagonal) {
    QuadMesh kite;
    kite.values.resize(4, 3);
    kite.values << 0, 0, 0, 1, 0, 0, 3, 3, 0, 0, 1, 0;
    kite.quads = {{0, 1, 2, 3}};
    const auto triangles = split_quads(kite);
    EXPECT_EQ(triangles.size(), 2U);
    for (const auto& triangle : triangles) {
        EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 1), 1);
        EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 3), 1);
    }
}

TEST(Pchip, passes_through_its_points_without_overshoot) {
    const Pchip curve({0, 1, 2, 4, 5}, {1, 1, 3, 3.5, 0});
    EXPECT_DOUBLE_EQ(curve(0), 1);
    EXPECT_DOUBLE_EQ(curve(2), 3);
    EXPECT_DOUBLE_EQ(curve(5), 0);
    for (double x = 0; x <= 5; x += 0.01) {
        EXPECT_GE(curve(x), -1e-12);
        EXPECT_LE(curve(x), 3.5 + 1e-12);
    }
    for (double x = 0; x <= 1; x += 0.01) EXPECT_NEAR(curve(x), 1, 1e-12);
}

TEST(Pchip, draws_a_line_through_points_on_a_line) {
    const Pchip line({-1, 0.5, 2, 3}, {-2, 1, 4, 6});
    for (double x = -2; x <= 4; x += 0.1) EXPECT_NEAR(line(x), 2 * x, 1e-12);
}

}  // namespace

}  // namespace selvedge::sim
