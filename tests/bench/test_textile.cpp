// The textile tests on coarse meshes: that they read what they say, not that the solver is right.
#include "bench/fabric/textile_test.h"

#include <gtest/gtest.h>

#include <cmath>

namespace selvedge {
namespace {

constexpr MeshSetting kCoarse{.angle = 0.3, .level = 0};
constexpr MeshSetting kFine{.angle = 0.3, .level = 1};  // an overhang of several triangles

TEST(Textile, a_cantilever_of_a_stiffer_fabric_reads_stiffer) {
    Fabric soft;
    Fabric stiff;
    stiff.bending_warp *= 4;
    const Reading a = test_cantilever(soft, ThreadDirection::Warp, kFine);
    const Reading b = test_cantilever(stiff, ThreadDirection::Warp, kFine);
    EXPECT_TRUE(a.is_at_rest);
    EXPECT_EQ(a.expected, soft.bending_warp);
    EXPECT_GT(a.measured, 0);
    EXPECT_NEAR(b.measured / a.measured, 4, 1);
}

TEST(Textile, a_hanging_strip_expects_what_theory_says) {
    Fabric wool;
    wool.area_density = 0.265;
    wool.stretch_warp = 1500;
    const Reading reading = test_own_weight(wool, ThreadDirection::Warp, kCoarse);
    EXPECT_NEAR(reading.expected, 0.265 * 9.81 * 0.5 / 2 / 1500, 1e-9);
    EXPECT_GT(reading.measured, 0);
    EXPECT_LT(reading.measured, 0.1);
}

TEST(Textile, a_load_never_strains_a_fabric_beyond_half_its_limit) {
    Fabric weak;
    weak.stretch_weft = 60;
    weak.strain_limit = 0.1;
    const Reading reading = test_load(weak, ThreadDirection::Weft, kCoarse);
    EXPECT_NEAR(reading.expected, 0.05, 0.01);
}

TEST(Textile, a_bias_strip_expects_about_1_percent) {
    EXPECT_NEAR(test_load({}, ThreadDirection::Bias, kCoarse).expected, 0.011, 0.002);
}

TEST(Textile, a_strip_swings_about_as_a_hanging_chain_does) {
    EXPECT_NEAR(swing_period({}, {.level = 1}), 0.914, 0.05);
}

TEST(Textile, a_strip_let_go_gains_no_energy) {
    EXPECT_LT(energy_growth({}, kCoarse), 1e-3);
}

TEST(Textile, a_disc_falls_from_its_support) {
    const DrapeReading reading = test_drape({}, {.angle = 0.3, .level = 0});
    EXPECT_GT(reading.coefficient, 5);
    EXPECT_LT(reading.coefficient, 99);
}

TEST(Textile, levels_have_names) {
    EXPECT_EQ(level_name({.level = 2}), "2");
    EXPECT_EQ(level_name({.level = 3, .is_adaptive = true}), "adaptive");
}

}  // namespace
}  // namespace selvedge
