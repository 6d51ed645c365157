// Specimens are what they are said to be, however they lie on the mesher's grid.
#include "bench/fabric/specimen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bench/support/measured_mesh.h"

namespace selvedge {
namespace {

const std::vector<double> kAngles{0, 0.3, std::numbers::pi / 4};

double area_of(const GarmentMesh& mesh, int panel) {
    double area = 0;
    for (const GarmentTriangle& t : mesh.triangles)
        if (t.panel == panel) area += 0.5 * cross2(t.u[1] - t.u[0], t.u[2] - t.u[0]);
    return area;
}

TEST(Specimen, a_strip_hangs_from_its_clamp_and_has_its_size) {
    for (const double angle : kAngles) {
        const Specimen strip = cut_strip({}, {.width = 0.05, .length = 0.4, .weight = 9.81, .mesh_angle = angle}, {});
        EXPECT_NEAR(area_of(strip.mesh, Specimen::kCloth), 0.05 * 0.4, 1e-9);
        Eigen::AlignedBox3d box;
        for (const Vec3d& x : strip.mesh.x) box.extend(x);
        EXPECT_TRUE(box.max().isApprox(Vec3d(0.05, 0.04, 0), 1e-9)) << box.max();
        EXPECT_NEAR(box.min().y(), -0.45, 1e-9);
        EXPECT_TRUE(strip.mesh.links.empty());
        EXPECT_NEAR(strip.fabrics[2].area_density * area_of(strip.mesh, 2) * 9.81, 9.81 * 0.05, 1e-9);
    }
}

TEST(Specimen, a_strip_is_pinned_at_the_clamp_and_nowhere_below) {
    const Specimen strip = cut_strip({}, {.mesh_angle = 0.3}, {});
    int on_edge = 0;
    for (const int pin : strip.mesh.pins) {
        const double y = strip.mesh.x[static_cast<std::size_t>(pin)].y();
        EXPECT_GE(y, -1e-9);
        on_edge += std::abs(y) < 1e-9 ? 1 : 0;
    }
    EXPECT_GE(on_edge, 2);
}

TEST(Specimen, material_points_lie_where_the_frame_puts_them) {
    const Specimen strip = cut_strip({}, {.mesh_angle = 0.3}, {});
    for (const GarmentTriangle& t : strip.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& x = strip.mesh.x[static_cast<std::size_t>(t.vertices[k])];
            EXPECT_LT((strip.material(x.x(), -x.y()) - t.u[k]).norm(), 1e-9);
        }
    }
}

TEST(Specimen, the_warp_follows_the_strip_and_not_the_grid) {
    const Specimen strip = cut_strip({}, {.mesh_angle = 0.3, .warp_angle = 0.5}, {});
    for (const double grain : strip.mesh.panel_grain_angles) EXPECT_NEAR(grain, 0.8, 1e-12);
}

TEST(Specimen, a_ridge_strip_is_pinned_along_its_middle_alone) {
    const SpecimenFrame level{.across = Vec3d::UnitZ(), .along = Vec3d::UnitX()};
    const Specimen strip = cut_ridge_strip({}, {.length = 0.1, .mesh_angle = 0.3}, level);
    ASSERT_GE(strip.mesh.pins.size(), 2U);
    for (const int pin : strip.mesh.pins) EXPECT_NEAR(strip.mesh.x[static_cast<std::size_t>(pin)].x(), 0, 1e-9);
    EXPECT_NEAR(area_of(strip.mesh, 0) + area_of(strip.mesh, 1), 0.05 * 0.2, 1e-9);
}

TEST(Specimen, a_disc_is_held_within_its_support_and_continues_beyond_it_without_a_jump) {
    for (const double angle : kAngles) {
        const Specimen disc = cut_disc({}, {.mesh_angle = angle});
        const double pi = std::numbers::pi;
        EXPECT_NEAR(area_of(disc.mesh, 0) / (pi * 0.09 * 0.09), 1, 0.02);
        EXPECT_NEAR((area_of(disc.mesh, 1) + area_of(disc.mesh, 2)) / (pi * (0.15 * 0.15 - 0.09 * 0.09)), 1, 0.02);
        for (const int pin : disc.mesh.pins) EXPECT_LT(disc.mesh.x[static_cast<std::size_t>(pin)].norm(), 0.09 + 1e-9);
        for (const GarmentTriangle& t : disc.mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d& x = disc.mesh.x[static_cast<std::size_t>(t.vertices[k])];
                EXPECT_LT((disc.material(x.x(), -x.z()) - t.u[k]).norm(), 1e-9);
            }
        }
    }
}

}  // namespace
}  // namespace selvedge
