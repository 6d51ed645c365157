// The heavy elastica against figures worked out elsewhere.
#include "bench/fabric/elastica.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace selvedge {
namespace {

double degrees(double angle) {
    return angle * 180 / std::numbers::pi;
}

TEST(Elastica, droops_as_the_table_says) {
    struct Row {
        double q, chord_deg, reach, drop;
    };
    constexpr std::array kTable{Row{1, 7.10, 0.9912, 0.1235},   Row{2, 13.86, 0.9669, 0.2385},
                                Row{4, 25.53, 0.8901, 0.4252},  Row{8, 41.49, 0.7244, 0.6406},
                                Row{15, 56.03, 0.5296, 0.7860}, Row{30, 68.57, 0.3428, 0.8731}};
    for (const Row& row : kTable) {
        const Droop d = droop(row.q);
        EXPECT_NEAR(degrees(chord_angle(d)), row.chord_deg, 0.006) << row.q;
        EXPECT_NEAR(d.reach, row.reach, 6e-5) << row.q;
        EXPECT_NEAR(d.drop, row.drop, 6e-5) << row.q;
    }
}

TEST(Elastica, dips_41_and_a_half_degrees_at_peirces_q) {
    EXPECT_NEAR(degrees(chord_angle(droop(kPeirceQ))), 41.5, 0.01);
}

TEST(Elastica, of_little_weight_droops_as_a_beam) {
    EXPECT_NEAR(droop(1e-3).drop, 1e-3 / 8, 1e-8);
}

TEST(Elastica, of_great_weight_hangs_plumb) {
    EXPECT_GT(droop(1e5).drop, 0.995);
    EXPECT_LT(droop(1e5).reach, 0.01);
}

TEST(Elastica, is_found_again_from_its_chord) {
    for (const double q : {0.1, 1.0, 8.004, 50.0, 400.0})
        EXPECT_NEAR(q_of_chord_angle(chord_angle(droop(q))) / q, 1, 1e-5) << q;
}

TEST(Elastica, a_sector_of_a_wide_support_is_a_strip) {
    EXPECT_NEAR(sector_droop(8, 1e6).reach, droop(8).reach, 1e-5);
    EXPECT_LT(sector_droop(8, 1.5).reach, droop(8).reach);  // what widens outward is heavier there
}

TEST(DrapeFloor, has_the_known_values) {
    EXPECT_NEAR(drape_floor(0.015), 14, 0.5);
    EXPECT_NEAR(drape_floor(0.020), 25, 0.5);
    EXPECT_NEAR(drape_floor(0.027), 48, 0.5);
    EXPECT_NEAR(drape_floor(0.035), 73, 0.6);
}

}  // namespace
}  // namespace selvedge
