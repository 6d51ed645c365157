// The weight that a band carries on a cone, against the formula of a belt.
#include "sim/inspection/hoop_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/mesh/sew.h"
#include "tests/sim/dress/shapes.h"

namespace selvedge::sim::test {
namespace {

constexpr double kSlope = 0.2, kFriction = 0.3;

// A band 0.6 m long and 5 cm high; its yarns are equally stiff.
struct Band {
    GarmentMesh mesh;
    std::vector<Fabric> fabrics;
    Opening upper;
};

Band band(double stiffness, double strain_limit) {
    Band band;
    band.mesh = assemble(tube(0.3, 0.05, 1.0, 0.1));
    merge_seams(band.mesh);
    const Fabric fabric{.area_density = 0.2,
                        .stretch_warp = stiffness,
                        .stretch_weft = stiffness,
                        .shear = stiffness / 2,
                        .strain_limit = strain_limit};
    band.fabrics.assign(2, fabric);
    for (const Opening& opening : find_openings(band.mesh)) {
        if (centre_of(opening, band.mesh.x).y() > 1.04) band.upper = opening;
    }
    return band;
}

// 0.66 m round at the height 1.
double cone(double y) {
    return 0.66 + 2 * std::numbers::pi * kSlope * (1 - y);
}

double support_of(const Band& band) {
    return largest_hoop_support(hoop_rows(band.mesh, band.upper, band.fabrics), cone, kFriction, 1.025, 1.025);
}

// Per newton of hoop force.
double belt() {
    return 2 * std::numbers::pi * (kSlope + kFriction) / (1 - kSlope * kFriction) *
           std::exp(kFriction * std::atan(kSlope));
}

TEST(HoopSupport, of_a_band_on_a_cone_is_that_of_a_belt) {
    const double force = 100 * 0.05 * (0.66 - 0.6) / 0.6;  // N, at its middle, which is at the height 1
    EXPECT_NEAR(support_of(band(100, 1)), force * belt(), 0.02 * force * belt());
}

TEST(HoopSupport, ends_at_the_strain_limit_of_the_fabric) {
    const double force = 100 * 0.05 * 0.01;  // N
    EXPECT_NEAR(support_of(band(100, 0.01)), force * belt(), 0.02 * force * belt());
}

TEST(HoopSupport, is_nothing_where_the_body_is_narrower_than_the_band) {
    const Band loose = band(100, 1);
    const auto column = [](double) { return 0.59; };
    EXPECT_EQ(largest_hoop_support(hoop_rows(loose.mesh, loose.upper, loose.fabrics), column, kFriction, 0.9, 1.1), 0);
}

TEST(HoopSupport, weighs_the_cloth_that_is_connected_with_the_edge) {
    const Band light = band(100, 1);
    EXPECT_NEAR(weight_below(light.mesh, light.upper, light.fabrics), 9.81 * 0.2 * 0.6 * 0.05, 1e-9);
}

}  // namespace
}  // namespace selvedge::sim::test
