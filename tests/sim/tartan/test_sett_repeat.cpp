#include "sim/tartan/sett_repeat.h"

#include <gtest/gtest.h>

namespace selvedge {
namespace {

StripeRepeat repeat_of(const char* threadcount) {
    Sett sett = parse_threadcount(threadcount);
    sett.thread_spacing = 1e-3;
    return warp_repeat(sett);
}

TEST(SettRepeat, a_sett_with_pivots_mirrors_in_the_middle_of_one) {
    const StripeRepeat repeat = repeat_of("K/20 R6 W/4");
    EXPECT_DOUBLE_EQ(repeat.size, 0.036);
    ASSERT_TRUE(repeat.mirror);
    EXPECT_DOUBLE_EQ(*repeat.mirror, 0.010);
}

TEST(SettRepeat, a_sett_that_goes_one_way_has_no_mirror) {
    const StripeRepeat repeat = repeat_of("K20 R6 W4");
    EXPECT_DOUBLE_EQ(repeat.size, 0.030);
    EXPECT_FALSE(repeat.mirror);
}

TEST(SettRepeat, two_colours_mirror_without_a_pivot) {
    const StripeRepeat repeat = repeat_of("K8 W4");
    EXPECT_DOUBLE_EQ(repeat.size, 0.012);
    ASSERT_TRUE(repeat.mirror);
    EXPECT_DOUBLE_EQ(*repeat.mirror, 0.004);
}

TEST(SettRepeat, a_repeat_written_twice_is_found_once) {
    EXPECT_DOUBLE_EQ(repeat_of("K8 W4 R2 K8 W4 R2").size, 0.014);
    EXPECT_DOUBLE_EQ(repeat_of("K4 W4 R2 K8 W4 R2 K4").size, 0.014);  // and cut within a stripe
}

TEST(SettRepeat, neighbours_of_one_colour_are_one_stripe_across_the_end_too) {
    const StripeRepeat repeat = repeat_of("K3 W4 K5");
    EXPECT_DOUBLE_EQ(repeat.size, 0.012);
    ASSERT_TRUE(repeat.mirror);
    EXPECT_DOUBLE_EQ(*repeat.mirror, -0.001);
}

TEST(SettRepeat, one_colour_has_no_stripes) {
    EXPECT_EQ(repeat_of("K8").size, 0);
    EXPECT_EQ(repeat_of("K/8 K4 K/2").size, 0);
}

TEST(SettRepeat, the_weft_has_its_own) {
    Sett sett = parse_threadcount("K20 R6 W4 weft: K/8 W/4");
    sett.thread_spacing = 1e-3;
    EXPECT_DOUBLE_EQ(weft_repeat(sett).size, 0.012);
    EXPECT_TRUE(weft_repeat(sett).mirror);
    EXPECT_FALSE(warp_repeat(sett).mirror);
}

}  // namespace
}  // namespace selvedge
