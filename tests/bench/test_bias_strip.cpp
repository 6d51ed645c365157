// Stiffness on the bias: the theory, and a simulated strip.
#include "bench/drop/bias_strip.h"

#include <gtest/gtest.h>

#include "bench/drop/drop.h"
#include "bench/support/measured_mesh.h"

namespace selvedge::bench {
namespace {

TEST(BiasTheory, approaches_four_times_the_shear_stiffness_where_threads_hardly_stretch) {
    sim::Fabric fabric = drop_fabric();
    EXPECT_NEAR(bias_stiffness(fabric), 220.9, 0.1);
    fabric.stretch_warp = fabric.stretch_weft = 1e9;
    EXPECT_NEAR(bias_stiffness(fabric), 4 * fabric.shear, 1e-4);
}

TEST(BiasTheory, agrees_with_the_small_strain_formula_at_small_strains_and_is_stiffer_beyond) {
    const sim::Fabric fabric = drop_fabric();
    EXPECT_NEAR(bias_strain(fabric, 1e-3) * bias_stiffness(fabric) / 1e-3, 1, 1e-4);
    const double force = 0.05 * bias_stiffness(fabric);
    EXPECT_LT(bias_strain(fabric, force), 0.05);
    EXPECT_GT(bias_strain(fabric, force), 0.045);
}

TEST(BiasStrip, comes_to_rest_at_a_strain_of_the_right_size) {
    const BiasStrip strip = measure_bias(drop_fabric(), {.element = 1.0 / 6, .level = 1, .substeps = 16});
    EXPECT_TRUE(strip.is_at_rest);
    EXPECT_GT(strip.stiffness_ratio, 0.5);
    EXPECT_LT(strip.stiffness_ratio, 1.5);
}

TEST(BiasStrip, a_fabric_of_half_the_shear_stiffness_gives_the_same_ratio) {
    sim::Fabric soft = drop_fabric();
    soft.shear /= 2;
    const BiasStripOptions options{.element = 1.0 / 6, .level = 1, .substeps = 32};
    EXPECT_NEAR(measure_bias(soft, options).stiffness_ratio, measure_bias(drop_fabric(), options).stiffness_ratio,
                0.15);
}

}  // namespace
}  // namespace selvedge::bench
