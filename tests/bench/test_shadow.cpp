// The shadow of a disc, flat, hanging and folded, and its drape coefficient.
#include "bench/fabric/shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace selvedge {
namespace {

constexpr double kSupport = 0.09;  // m
constexpr double kRadius = 0.15;
constexpr int kSectors = 720;

using Place = std::function<Vec3d(double radius, double angle)>;

Vec3d flat(double radius, double angle) {
    return {radius * std::cos(angle), 0, radius * std::sin(angle)};
}

// A disc in sectors and rings, each point where `place` puts it.
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
}  // namespace selvedge
