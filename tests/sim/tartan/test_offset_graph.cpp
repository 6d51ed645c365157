#include <gtest/gtest.h>
#include <cmath>
#include <random>

#include "sim/tartan/offset_graph.h"

namespace selvedge::sim {
namespace {

double cost(const std::vector<ShiftTerm>& terms, double shift, double repeat) {
    double sum = 0;
    for (const ShiftTerm& term : terms) {
        sum += term.weight * std::abs(std::remainder(term.factor * shift + term.value, repeat));
    }
    return sum;
}

TEST(BestShift, one_term_goes_to_zero_by_the_shorter_way) {
    EXPECT_NEAR(best_shift({{0.02, 1, 1}}, 0.1), -0.02, 1e-12);
    EXPECT_NEAR(best_shift({{0.09, 1, 1}}, 0.1), 0.01, 1e-12);
    EXPECT_NEAR(best_shift({{0.02, 1, -1}}, 0.1), 0.02, 1e-12);
    EXPECT_NEAR(best_shift({{0.02, 1, 2}}, 0.1), -0.01, 1e-12);
}

TEST(BestShift, the_heavier_of_two_wins) {
    EXPECT_NEAR(best_shift({{0.02, 1, 1}, {0.03, 2, 1}}, 0.1), -0.03, 1e-12);
}

TEST(BestShift, stays_where_nothing_is_better) {
    EXPECT_EQ(best_shift({{0, 1, 1}}, 0.1), 0);
    EXPECT_EQ(best_shift({{0.05, 1, 1}, {0, 1, 1}}, 0.1), 0);
    EXPECT_EQ(best_shift({{0.02, 0, 1}}, 0.1), 0);
    EXPECT_EQ(best_shift({}, 0.1), 0);
}

TEST(BestShift, is_not_led_astray_by_what_rounding_leaves_of_nothing_or_of_half_a_repeat) {
    EXPECT_NEAR(best_shift({{1.7e-18, 1, 1}, {0.03, 2, 1}}, 0.2), -0.03, 1e-12);
    EXPECT_NEAR(best_shift({{std::nextafter(0.1, 1.0), 1, 1}, {0, 2, 1}}, 0.2), 0, 1e-12);
    EXPECT_NEAR(best_shift({{-1.7e-18, 1, 1}, {0.03, 2, -1}}, 0.2), 0.03, 1e-12);
}

TEST(BestShift, no_shift_on_a_fine_grid_is_better) {
    std::mt19937 random(5);
    const auto number = [&] { return double(random() % 100001) / 100000.0; };
    for (int trial = 0; trial < 300; ++trial) {
        const double repeat = 0.05 + 0.2 * number();
        std::vector<ShiftTerm> terms(1 + random() % 12);
        for (ShiftTerm& term : terms) {
            const int factor = random() % 3 == 0 ? 2 : 1;
            term = {3 * number() - 1.5, number(), random() % 2 == 0 ? factor : -factor};
        }
        const double shift = best_shift(terms, repeat);
        EXPECT_LE(std::abs(shift), repeat / 2 + 1e-12);
        for (int i = 0; i < 2000; ++i) {
            EXPECT_LE(cost(terms, shift, repeat), cost(terms, i * repeat / 2000, repeat) + 1e-8);
        }
    }
}

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
    EXPECT_DOUBLE_EQ(repeat_of("K4 W4 R2 K8 W4 R2 K4").size, 0.014);  // repeat that begins inside a stripe
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

}  // namespace selvedge::sim
