#include "sim/tartan/best_shift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace selvedge {
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

}  // namespace
}  // namespace selvedge
