// The mannequin's legs: how far apart they stand, and what must not change when they are turned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "sim/body/mannequin.h"
#include "sim/body/section.h"
#include "sim/core/error.h"
#include "tests/sim/body/body_checks.h"

namespace selvedge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUsual = 0.9 * kDegree;
constexpr double kLeastGap = 0.008;  // m
const MannequinMeasures kMeanBody{.height = 1.72, .bust = 0.9984, .waist = 0.8433, .hip = 1.0348};

Vec3d joint(const Body& body, std::string_view name) {
    for (const Bone& bone : body.bones) {
        if (bone.name == name) return bone.joint;
    }
    ADD_FAILURE() << "no bone " << name;
    return Vec3d::Zero();
}

double stance(const Body& body) {
    const Vec3d leg = joint(body, "left_foot") - joint(body, "left_upper_leg");
    return std::atan2(leg.x(), -leg.y());
}

double reading(const Mannequin& mannequin, std::string_view name) {
    for (const MeasureReading& line : mannequin.report.readings) {
        if (line.name == name) return line.measured;
    }
    ADD_FAILURE() << "no reading of " << name;
    return 0;
}

struct Extent {
    double inner = std::numeric_limits<double>::max();
    double outer = 0;
};

// Of the left leg at one height, from the cut surface, so that the report is not its own witness.
Extent left_leg_at(const Body& body, double y) {
    constexpr double kHands = 0.30;  // m: they hang farther out
    Extent extent;
    for (const SectionLoop& loop : section(body, {.point = Vec3d(0, y, 0)})) {
        if (loop.centre.x() < 0.01 || loop.centre.x() > kHands) continue;
        for (const Vec3d& x : loop.points) {
            extent.inner = std::min(extent.inner, x.x());
            extent.outer = std::max(extent.outer, x.x());
        }
    }
    return extent;
}

double least_gap(const Mannequin& mannequin) {
    double gap = std::numeric_limits<double>::max();
    for (double y = reading(mannequin, "inseam") - 0.041; y > 0.01; y -= 0.004) {
        gap = std::min(gap, 2 * left_leg_at(mannequin.body, y).inner);
    }
    return gap;
}

void expect_sound(const Mannequin& mannequin) {
    EXPECT_TRUE(is_closed_manifold(mannequin.body));
    EXPECT_EQ(count_self_intersections(mannequin.body), 0);
    EXPECT_NEAR(height_range(mannequin.body).low, 0, 1e-9);
    EXPECT_TRUE(mannequin.report.messages.empty()) << mannequin.report.messages.front();
}

// Of all edges within 15 cm of the crotch's height, between the normals of their triangles, degrees.
double sharpest_edge_at_crotch(const Mannequin& mannequin) {
    const Body& body = mannequin.body;
    const double crotch = reading(mannequin, "inseam");
    std::map<std::pair<int, int>, Vec3d> normals;
    double sharpest = 0;
    for (const auto& [a, b, c] : body.triangles) {
        const auto at = [&](int v) { return body.x[static_cast<std::size_t>(v)]; };
        if (std::abs(at(a).y() - crotch) > 0.15 || std::abs(at(a).x()) > 0.3) continue;
        const Vec3d normal = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
            if (const auto twin = normals.find({to, from}); twin != normals.end()) {
                sharpest = std::max(sharpest, std::acos(std::clamp(normal.dot(twin->second), -1.0, 1.0)));
            }
            normals[{from, to}] = normal;
        }
    }
    return sharpest / kDegree;
}

TEST(MannequinStance, is_nearly_parallel_unless_another_is_asked_for) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        const Mannequin mannequin = make_mannequin({.sex = sex});
        EXPECT_NEAR(stance(mannequin.body), kUsual, 1e-9);
        EXPECT_FALSE(mannequin.report.stance.asked.has_value());
        EXPECT_FALSE(mannequin.report.stance.is_opened);
        EXPECT_GT(least_gap(mannequin), kLeastGap);
        expect_sound(mannequin);
    }
}

TEST(MannequinStance, lets_a_straight_skirt_close_around_the_calves_of_a_mean_body) {
    const Mannequin mannequin = make_mannequin({.measures = kMeanBody});
    for (double y = 0.25; y < 0.351; y += 0.01) EXPECT_LE(left_leg_at(mannequin.body, y).outer, 0.19) << y;
    EXPECT_GT(least_gap(mannequin), kLeastGap);
    expect_sound(mannequin);
}

TEST(MannequinStance, is_as_asked_from_parallel_to_ten_degrees) {
    for (const double degrees : {0.0, 2.0, 5.0, 10.0}) {
        SCOPED_TRACE(degrees);
        const Mannequin mannequin = make_mannequin({.measures = kMeanBody, .stance = degrees * kDegree});
        EXPECT_NEAR(stance(mannequin.body), degrees * kDegree, 1e-9);
        EXPECT_DOUBLE_EQ(mannequin.report.stance.made, degrees * kDegree);
        EXPECT_FALSE(mannequin.report.stance.is_opened);
        expect_sound(mannequin);
    }
}

TEST(MannequinStance, changes_no_measure) {
    MannequinMeasures measures = kMeanBody;
    measures.inseam = 0.80;
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        const Mannequin closed = make_mannequin({.sex = sex, .measures = measures, .stance = 0.0});
        const Mannequin open = make_mannequin({.sex = sex, .measures = measures, .stance = 6 * kDegree});
        for (const MeasureReading& line : closed.report.readings) {
            EXPECT_NEAR(line.measured / reading(open, line.name), 1, 0.003) << line.name;
        }
    }
}

TEST(MannequinStance, only_shifts_the_feet_sideways) {
    MannequinMeasures measures = kMeanBody;
    measures.inseam = 0.80;
    const Body closed = make_mannequin({.measures = measures, .stance = 0.0}).body;
    const Body open = make_mannequin({.measures = measures, .stance = 6 * kDegree}).body;
    const Vec3d shift = joint(open, "left_foot") - joint(closed, "left_foot");
    EXPECT_GT(shift.x(), 0.07);
    EXPECT_NEAR((joint(open, "left_toe") - joint(closed, "left_toe") - shift).norm(), 0, 1e-3);
    int sole = 0;
    for (std::size_t v = 0; v < closed.x.size(); ++v) {
        if (closed.x[v].x() < 0 || closed.x[v].y() > 0.004) continue;
        const Vec3d moved = open.x[v] - closed.x[v];
        EXPECT_NEAR(moved.x(), shift.x(), 1e-3);
        EXPECT_NEAR(moved.y(), 0, 3e-4);
        ++sole;
    }
    EXPECT_GT(sole, 100);
}

TEST(MannequinStance, leaves_left_and_right_alike) {
    const Body body = make_mannequin({.measures = kMeanBody, .stance = 0.5 * kDegree}).body;
    Vec3d moment = Vec3d::Zero();  // of x with 1, with y and with z: an odd one would show
    for (const Vec3d& x : body.x) moment += x.x() * Vec3d(1, x.y(), x.z());
    EXPECT_NEAR(moment.norm() / static_cast<double>(body.x.size()), 0, 1e-9);
    EXPECT_EQ(joint(body, "right_foot"), Vec3d(-joint(body, "left_foot").cwiseProduct(Vec3d(1, -1, -1))));
}

TEST(MannequinStance, makes_the_groin_hardly_sharper) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        const Mannequin usual = make_mannequin({.sex = sex});
        const Mannequin spread = make_mannequin({.sex = sex, .stance = 5.4 * kDegree});
        EXPECT_LT(sharpest_edge_at_crotch(usual), sharpest_edge_at_crotch(spread) + 10);
    }
}

TEST(MannequinStance, opens_until_thick_thighs_are_apart) {
    const Mannequin mannequin = make_mannequin({.measures = {.thigh = 0.58}});
    EXPECT_TRUE(mannequin.report.stance.is_opened);
    EXPECT_GT(stance(mannequin.body), 2 * kDegree);
    EXPECT_NEAR(stance(mannequin.body), mannequin.report.stance.made, 1e-9);
    const double gap = least_gap(mannequin);
    EXPECT_GE(gap, kLeastGap);
    EXPECT_LT(gap, kLeastGap + 0.002);
    EXPECT_NEAR(gap, mannequin.report.stance.gap, 2e-4);
    EXPECT_NEAR(reading(mannequin, "thigh") / 0.58, 1, 0.003);
    expect_sound(mannequin);
}

TEST(MannequinStance, says_when_thighs_open_it_beyond_what_was_asked) {
    const Mannequin mannequin = make_mannequin({.measures = {.thigh = 0.58}, .stance = 1 * kDegree});
    ASSERT_EQ(mannequin.report.messages.size(), 1U);
    EXPECT_NE(mannequin.report.messages[0].find("stance: asked 1.0 degrees, made "), std::string::npos);
}

TEST(MannequinStance, says_when_no_stance_keeps_the_thighs_apart) {
    const Mannequin mannequin = make_mannequin({.measures = {.thigh = 0.68}});
    ASSERT_EQ(mannequin.report.messages.size(), 1U);
    EXPECT_NE(mannequin.report.messages[0].find("the thighs are only"), std::string::npos);
}

TEST(MannequinStance, is_refused_outside_its_range) {
    for (const double degrees : {-1.0, 10.1, std::numeric_limits<double>::quiet_NaN()}) {
        try {
            make_mannequin({.stance = degrees * kDegree});
            ADD_FAILURE() << degrees << " was taken";
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), "stance");
        }
    }
}

}  // namespace
}  // namespace selvedge
