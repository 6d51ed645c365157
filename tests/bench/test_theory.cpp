// The heavy elastica, compared with independently computed values.
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "bench/fabric/theory.h"

namespace selvedge::bench {
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
        const Deflection d = droop(row.q);
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
    EXPECT_LT(sector_droop(8, 1.5).reach, droop(8).reach);  // it widens outward, so more weight is far from the clamp
}

TEST(DrapeFloor, has_the_known_values) {
    EXPECT_NEAR(drape_floor(0.015), 14, 0.5);
    EXPECT_NEAR(drape_floor(0.020), 25, 0.5);
    EXPECT_NEAR(drape_floor(0.027), 48, 0.5);
    EXPECT_NEAR(drape_floor(0.035), 73, 0.6);
}

}  // namespace

// The shadow of a flat, a hanging and a folded disc, and its drape coefficient.

namespace {

constexpr double kSupport = 0.09;  // m
constexpr double kRadius = 0.15;
constexpr int kSectors = 720;

using Place = std::function<Vec3d(double radius, double angle)>;

Vec3d flat(double radius, double angle) {
    return {radius * std::cos(angle), 0, radius * std::sin(angle)};
}

// A disc of sectors and rings; `place` maps polar coordinates to positions.
Shadow shadow_of(const Place& place) {
    Shadow shadow;
    const auto angle = [](int i) { return 2 * std::numbers::pi * i / kSectors; };
    for (int i = 0; i < kSectors; ++i) {
        shadow.draw({Vec3d::Zero(), place(kSupport, angle(i)), place(kSupport, angle(i + 1))});
        shadow.draw({place(kSupport, angle(i)), place(kRadius, angle(i)), place(kRadius, angle(i + 1))});
        shadow.draw({place(kSupport, angle(i)), place(kRadius, angle(i + 1)), place(kSupport, angle(i + 1))});
    }
    return shadow;
}

double coefficient(const Shadow& shadow) {
    const double pi = std::numbers::pi;
    return drape_coefficient(shadow.area(), pi * kSupport * kSupport, pi * kRadius * kRadius);
}

TEST(Shadow, of_a_flat_disc_has_its_area_and_radius) {
    const Shadow shadow = shadow_of(flat);
    EXPECT_NEAR(shadow.area() / (std::numbers::pi * kRadius * kRadius), 1, 2e-3);
    for (const double r : shadow.outline()) EXPECT_NEAR(r, kRadius, 1e-3);
}

TEST(DrapeCoefficient, of_a_flat_disc_is_100) {
    EXPECT_NEAR(coefficient(shadow_of(flat)), 100, 0.3);
}

TEST(DrapeCoefficient, of_a_disc_that_hangs_straight_down_is_0) {
    const auto hanging = [](double radius, double angle) {
        return Vec3d(flat(std::min(radius, kSupport), angle) - Vec3d(0, std::max(0.0, radius - kSupport), 0));
    };
    EXPECT_NEAR(coefficient(shadow_of(hanging)), 0, 0.3);
}

TEST(DrapeCoefficient, does_not_depend_on_which_way_triangles_turn) {
    const auto mirrored = [](double radius, double angle) { return flat(radius, -angle); };
    EXPECT_NEAR(coefficient(shadow_of(mirrored)), 100, 0.3);
}

TEST(CountFolds, finds_as_many_as_were_laid) {
    for (const int folds : {2, 5, 8}) {
        const auto waved = [&](double radius, double angle) {
            return flat(radius * (radius > kSupport ? 0.8 + 0.1 * std::cos(folds * angle) : 1), angle);
        };
        EXPECT_EQ(count_folds(shadow_of(waved).outline()), folds);
    }
}

TEST(CountFolds, finds_none_in_a_circle_nor_in_ripples) {
    EXPECT_EQ(count_folds(shadow_of(flat).outline()), 0);
    std::vector<double> ripples;
    for (int i = 0; i < 360; ++i) ripples.push_back(0.12 + 0.0015 * std::sin(i));
    EXPECT_EQ(count_folds(ripples), 0);
    EXPECT_EQ(count_folds({}), 0);
}

}  // namespace

}  // namespace selvedge::bench
