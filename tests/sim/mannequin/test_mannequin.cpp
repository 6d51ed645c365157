#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include "sim/body/section.h"
#include "sim/core/error.h"
#include "sim/core/parallel.h"
#include "sim/mannequin/base.h"
#include "sim/mannequin/cage.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mannequin/table.h"
#include "tests/support/body_checks.h"

namespace selvedge::sim {
namespace {

constexpr double kTapeTolerance = 0.003;

// Every requested measure is within 0.3 %, and none is reported as unmet.
void expect_as_asked(const Mannequin& mannequin) {
    for (const MeasureReading& reading : mannequin.report.readings) {
        if (!reading.requested) continue;
        EXPECT_NEAR(reading.measured / *reading.requested, 1, kTapeTolerance) << reading.name;
    }
    EXPECT_TRUE(mannequin.report.messages.empty()) << mannequin.report.messages.front();
}

// Independent measurement of the girth at y, from the surface alone and not from the report.
double tape(const Mannequin& mannequin, double y) {
    const Plane plane{.point = Vec3d(0, y, 0), .normal = Vec3d::UnitY()};
    const auto loop = nearest_loop(section(mannequin.body, plane), plane.point);
    return loop ? tape_length(*loop, plane) : 0;
}

// Triangular distribution around the middle: people rarely have extreme values in all measures.
MannequinMeasures random_measures(std::mt19937& random) {
    const auto between = [&](double least, double most) {
        const auto unit = [&] { return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()); };
        return least + (most - least) * (unit() + unit()) / 2;
    };
    MannequinMeasures measures;
    measures.height = between(1.50, 1.95);
    measures.bust = between(0.80, 1.20);
    measures.waist = *measures.bust * between(0.70, 1.00);
    measures.hip = *measures.bust * between(0.92, 1.14);
    return measures;
}

// Of a wrist of 16.5 cm, 5 cm above it: a person has 19 cm; the arm of the base body, scaled, had 21.4.
TEST(Mannequin, with_a_wide_wrist_has_a_lower_arm_that_tapers_to_it) {
    const Mannequin mannequin =
        make_mannequin({.measures = {.height = 1.66, .arm = 0.59, .bust = 0.925, .biceps = 0.27, .wrist = 0.165}});
    expect_as_asked(mannequin);
    Joints joints;
    for (std::size_t j = 0; j < kJointCount; ++j) joints.x[j] = mannequin.body.bones[j].joint;
    const EvenTable girths = lower_arm_girths(mannequin.body, joints);
    const double length = (joints[Joint::LeftHand] - joints[Joint::LeftLowerArm]).norm();
    EXPECT_NEAR(girths.at(kWristPosition), 0.165, 0.001);
    EXPECT_LT(girths.at(kWristPosition - 0.05 / length), 0.205);
    for (std::size_t i = 1; i < girths.values.size(); ++i) EXPECT_LT(girths.values[i], girths.values[i - 1]);
}

TEST(Mannequin, is_closed_manifold_and_faces_outward) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        const Mannequin mannequin = make_mannequin({.sex = sex});
        EXPECT_TRUE(is_closed_manifold(mannequin.body));
        EXPECT_GT(volume(mannequin.body), 0.04);
        EXPECT_LT(volume(mannequin.body), 0.10);
        EXPECT_EQ(count_self_intersections(mannequin.body), 0);
    }
}

TEST(Mannequin, has_the_counts_of_its_resolution) {
    constexpr std::array<std::size_t, 3> kTriangles{17184, 68736, 274944};
    for (int steps = 1; steps <= 3; ++steps) {
        const Mannequin mannequin = make_mannequin({.measures = {.bust = 0.92}, .subdivisions = steps});
        EXPECT_EQ(mannequin.body.triangles.size(), kTriangles[static_cast<std::size_t>(steps - 1)]);
        EXPECT_EQ(mannequin.body.x.size(), mannequin.body.triangles.size() / 2 + 2);
        expect_as_asked(mannequin);
    }
}

TEST(Mannequin, meets_the_measures_of_a_mean_body) {
    const Mannequin mannequin =
        make_mannequin({.measures = {.height = 1.7199, .bust = 0.9984, .waist = 0.8433, .hip = 1.0348}});
    expect_as_asked(mannequin);
    EXPECT_EQ(count_self_intersections(mannequin.body), 0);
    const HeightRange range = height_range(mannequin.body);
    EXPECT_NEAR(range.low, 0, 1e-9);
    EXPECT_NEAR(range.high, 1.7199, 1e-6);
}

TEST(Mannequin, has_the_asked_girth_where_its_surface_is_cut_at_the_reported_level) {
    const Mannequin mannequin = make_mannequin({.measures = {.bust = 0.96, .waist = 0.78, .hip = 1.02}});
    int levels = 0;
    for (const MeasureReading& reading : mannequin.report.readings) {
        if (!reading.requested || !reading.level) continue;
        EXPECT_NEAR(tape(mannequin, *reading.level) / *reading.requested, 1, kTapeTolerance) << reading.name;
        ++levels;
    }
    EXPECT_EQ(levels, 3);
}

TEST(Mannequin, lays_the_trunks_tapes_in_order_from_bust_to_hip) {
    const Mannequin mannequin = make_mannequin({.sex = Sex::Male});
    double above = mannequin.report.readings[0].measured;
    for (const MeasureReading& reading : mannequin.report.readings) {
        if (!reading.level) continue;
        EXPECT_LT(*reading.level, above) << reading.name;
        above = *reading.level;
        if (reading.name == "hip") return;
    }
    FAIL() << "no hip in the report";
}

TEST(Mannequin, meets_seeded_measures_without_cutting_itself) {
    std::mt19937 random(20260301);
    for (int i = 0; i < 12; ++i) {
        SCOPED_TRACE(i);
        const Mannequin mannequin =
            make_mannequin({.sex = i % 2 == 0 ? Sex::Female : Sex::Male, .measures = random_measures(random)});
        expect_as_asked(mannequin);
        EXPECT_TRUE(is_closed_manifold(mannequin.body));
        EXPECT_EQ(count_self_intersections(mannequin.body), 0);
    }
}

TEST(Mannequin, meets_every_single_measure_that_is_moved_from_its_default) {
    const Mannequin plain = make_mannequin();
    for (const MeasureReading& reading : plain.report.readings) {
        if (reading.name == "shoulder") continue;  // limited by the chest: see below
        SCOPED_TRACE(reading.name);
        MannequinOptions options;
        *find_measure(options.measures, reading.name) = reading.measured * 1.04;
        expect_as_asked(make_mannequin(options));
    }
}

TEST(Mannequin, meets_all_measures_at_once) {
    const MannequinMeasures measures{.height = 1.66,
                                     .inseam = 0.76,
                                     .shoulder = 0.37,
                                     .arm = 0.49,
                                     .bust = 0.90,
                                     .underbust = 0.77,
                                     .waist = 0.70,
                                     .high_hip = 0.86,
                                     .hip = 0.96,
                                     .neck = 0.34,
                                     .biceps = 0.27,
                                     .elbow = 0.235,
                                     .forearm = 0.24,
                                     .wrist = 0.15,
                                     .thigh = 0.55,
                                     .mid_thigh = 0.47,
                                     .knee = 0.355,
                                     .calf = 0.345,
                                     .ankle = 0.215};
    const Mannequin mannequin = make_mannequin({.measures = measures});
    expect_as_asked(mannequin);
    EXPECT_EQ(count_self_intersections(mannequin.body), 0);
}

TEST(Mannequin, says_when_the_shoulders_cannot_be_as_narrow_as_asked) {
    const Mannequin mannequin = make_mannequin({.measures = {.shoulder = 0.26, .bust = 1.10}});
    ASSERT_EQ(mannequin.report.messages.size(), 1U);
    EXPECT_NE(mannequin.report.messages[0].find("shoulder: asked 26.0 cm"), std::string::npos);
    EXPECT_NE(mannequin.report.messages[0].find("chest"), std::string::npos);
}

TEST(Mannequin, is_symmetric) {
    const Mannequin mannequin = make_mannequin({.measures = {.bust = 1.0}});
    Vec3d moment = Vec3d::Zero();
    for (const Vec3d& x : mannequin.body.x) moment += x;
    EXPECT_NEAR(moment.x() / static_cast<double>(mannequin.body.x.size()), 0, 1e-9);
    for (std::size_t b = 0; b < mannequin.body.bones.size(); ++b) {
        const Bone& bone = mannequin.body.bones[b];
        if (!bone.name.starts_with("left_")) continue;
        const Bone& twin = mannequin.body.bones[b + 8];
        EXPECT_EQ(twin.name, "right_" + bone.name.substr(5));
        EXPECT_EQ(twin.joint, Vec3d(-bone.joint.x(), bone.joint.y(), bone.joint.z()));
    }
}

TEST(Mannequin, has_a_skeleton_inside_and_skin_weights_that_sum_to_one) {
    const Body body = make_mannequin({.sex = Sex::Male}).body;
    ASSERT_EQ(body.bones.size(), 21U);
    for (std::size_t b = 0; b < body.bones.size(); ++b) EXPECT_LT(body.bones[b].parent, static_cast<int>(b));
    ASSERT_EQ(body.skin.size(), body.x.size());
    std::vector<bool> is_used(body.bones.size(), false);
    for (const SkinWeights& skin : body.skin) {
        float sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_GE(skin.weights[k], 0);
            ASSERT_LT(skin.bones[k], body.bones.size());
            if (skin.weights[k] > 0.5F) is_used[skin.bones[k]] = true;
            sum += skin.weights[k];
        }
        EXPECT_NEAR(sum, 1, 1e-5);
    }
    for (std::size_t b = 0; b < body.bones.size(); ++b) EXPECT_TRUE(is_used[b]) << body.bones[b].name;
}

TEST(Mannequin, gives_equal_bits_for_equal_options_and_any_number_of_threads) {
    const MannequinOptions options{.measures = {.bust = 0.97, .waist = 0.81}};
    const Mannequin many = make_mannequin(options);
    const ThreadLimit one_thread(1);
    const Mannequin one = make_mannequin(options);
    EXPECT_EQ(many.body.x, one.body.x);
    EXPECT_EQ(many.body.triangles, one.body.triangles);
}

TEST(Mannequin, refuses_measures_that_no_body_has) {
    const auto expect_refused = [](const MannequinMeasures& measures, const char* name) {
        try {
            make_mannequin({.measures = measures});
            ADD_FAILURE() << name << " was taken";
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), name);
            EXPECT_NE(error.problem().find("between"), std::string::npos);
        }
    };
    expect_refused({.bust = 0.05}, "bust");
    expect_refused({.hip = std::numeric_limits<double>::quiet_NaN()}, "hip");
    expect_refused({.ankle = std::numeric_limits<double>::infinity()}, "ankle");
    expect_refused({.height = -1.7}, "height");
    expect_refused({.height = 1.5, .inseam = 0.95}, "inseam");
    expect_refused({.inseam = 1.0}, "inseam");
    EXPECT_THROW(make_mannequin({.subdivisions = 0}), InputError);
    EXPECT_THROW(make_mannequin({.subdivisions = 9}), InputError);
}

}  // namespace

// Stance of the legs: its limits, and what must not change with it.

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUsual = 0.9 * kDegree;
constexpr double kMinGap = 0.008;  // m
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

// Extent of the left leg at one height, from the cut surface and not from the report.
Extent left_leg_at(const Body& body, double y) {
    constexpr double kHands = 0.30;  // m: the hands are farther out
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

double min_gap(const Mannequin& mannequin) {
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

// Largest angle between the normals of two adjacent triangles, of all edges within 15 cm of the crotch's height,
// degrees.
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
        EXPECT_FALSE(mannequin.report.stance.requested.has_value());
        EXPECT_FALSE(mannequin.report.stance.is_opened);
        EXPECT_GT(min_gap(mannequin), kMinGap);
        expect_sound(mannequin);
    }
}

TEST(MannequinStance, lets_a_straight_skirt_close_around_the_calves_of_a_mean_body) {
    const Mannequin mannequin = make_mannequin({.measures = kMeanBody});
    for (double y = 0.25; y < 0.351; y += 0.01) EXPECT_LE(left_leg_at(mannequin.body, y).outer, 0.19) << y;
    EXPECT_GT(min_gap(mannequin), kMinGap);
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
            if (line.name == "waist_height") continue;  // none was asked for: it follows the crotch
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
    Vec3d moment = Vec3d::Zero();  // of x with 1, y and z: not 0 if one side differed
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
    const double gap = min_gap(mannequin);
    EXPECT_GE(gap, kMinGap);
    EXPECT_LT(gap, kMinGap + 0.002);
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

// The message of the error that `text` causes; empty when it is accepted.
std::string refusal(const char* text) {
    try {
        parse_mannequin(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ParseMannequin, reads_centimetres) {
    const MannequinOptions options = parse_mannequin("mannequin:sex=male,height=178.5,bust=100,hip=98,resolution=1");
    EXPECT_EQ(options.sex, Sex::Male);
    EXPECT_EQ(options.subdivisions, 1);
    EXPECT_DOUBLE_EQ(options.measures.height.value(), 1.785);
    EXPECT_DOUBLE_EQ(options.measures.bust.value(), 1.0);
    EXPECT_DOUBLE_EQ(options.measures.hip.value(), 0.98);
    EXPECT_FALSE(options.measures.waist.has_value());
}

TEST(ParseMannequin, reads_the_stance_in_degrees) {
    EXPECT_FALSE(parse_mannequin("mannequin").stance.has_value());
    EXPECT_NEAR(parse_mannequin("mannequin:stance=1.5").stance.value(), 0.0261799, 1e-7);
    EXPECT_EQ(parse_mannequin("mannequin:stance=0").stance.value(), 0);
    EXPECT_EQ(parse_mannequin("mannequin:stance=10").stance.value(), 10 * std::numbers::pi / 180);
    EXPECT_EQ(refusal("mannequin:stance=12"), "mannequin: stance: 12 degrees is not between 0 and 10 degrees");
    EXPECT_EQ(refusal("mannequin:stance=wide"), "mannequin: stance: 'wide' is not a number");
    EXPECT_NE(refusal("mannequin:stance=1,stance=2").find("given twice"), std::string::npos);
}

TEST(ParseMannequin, takes_nothing_for_the_default_body) {
    for (const char* text : {"mannequin", "mannequin:"}) {
        const MannequinOptions options = parse_mannequin(text);
        EXPECT_EQ(options.sex, Sex::Female);
        EXPECT_EQ(options.subdivisions, 2);
        EXPECT_FALSE(options.measures.bust.has_value());
    }
}

// Of a draft: the waist is 41 cm over a low crotch.
TEST(Mannequin, has_its_waist_at_the_height_that_is_asked_for) {
    for (const double waist_height : {1.10, 1.209, 1.235}) {
        const Mannequin made = make_mannequin({.sex = Sex::Male,
                                               .measures = {.height = 1.967,
                                                            .inseam = 0.801,
                                                            .waist_height = waist_height,
                                                            .bust = 1.105,
                                                            .waist = 0.882,
                                                            .hip = 1.084},
                                               .subdivisions = 1});
        EXPECT_TRUE(made.report.messages.empty()) << made.report.messages.front();
        EXPECT_NEAR(reading(made, "waist_height"), waist_height, 1e-6);
        EXPECT_NEAR(reading(made, "waist"), 0.882, 0.003);
        EXPECT_NEAR(reading(made, "hip"), 1.084, 0.003);
        EXPECT_NEAR(reading(made, "inseam"), 0.801, 0.003);
        for (const MeasureReading& one : made.report.readings) {
            if (one.name == "waist") {
                EXPECT_NEAR(one.level.value(), waist_height, 1e-6);
            }
        }
    }
    EXPECT_THROW(make_mannequin({.measures = {.height = 1.7, .waist_height = 1.25}}), InputError);
    EXPECT_THROW(make_mannequin({.measures = {.height = 1.7, .inseam = 0.72, .waist_height = 1.14}}), InputError);
}

TEST(ParseMannequin, knows_hips_as_hip) {
    EXPECT_DOUBLE_EQ(parse_mannequin("mannequin:hips=103.5").measures.hip.value(), 1.035);
    EXPECT_NE(refusal("mannequin:hip=100,hips=101").find("given twice"), std::string::npos);
}

TEST(ParseMannequin, knows_every_measure_by_its_name) {
    EXPECT_EQ(measure_names().size(), 20U);
    MannequinMeasures measures;
    for (const std::string_view name : measure_names()) {
        std::optional<double>* measure = find_measure(measures, name);
        ASSERT_NE(measure, nullptr);
        EXPECT_FALSE(measure->has_value()) << name << " stands for the same measure as another name";
        *measure = 1;
    }
    EXPECT_EQ(find_measure(measures, "cup"), nullptr);
}

TEST(ParseMannequin, says_what_is_wrong) {
    EXPECT_EQ(refusal("mannequin:bust=5"), "mannequin: bust: 5 cm is not between 70 cm and 150 cm");
    EXPECT_EQ(refusal("mannequin:bust=big"), "mannequin: bust: 'big' is not a number");
    EXPECT_EQ(refusal("mannequin:bust=92cm"), "mannequin: bust: '92cm' is not a number");
    EXPECT_EQ(refusal("mannequin:bust=nan"), "mannequin: bust: 'nan' is not a number");
    EXPECT_EQ(refusal("mannequin:bust="), "mannequin: bust: '' is not a number");
    EXPECT_EQ(refusal("mannequin:sex=woman"), "mannequin: sex: 'woman' is neither female nor male");
    EXPECT_EQ(refusal("mannequin:bust"), "mannequin: bust: 'name=value' expected");
    EXPECT_EQ(refusal("mannequin:resolution=2.5"), "mannequin: resolution: '2.5' is not a number of steps");
    EXPECT_EQ(refusal("mannequin:resolution=7"),
              "mannequin: resolution: 7 is not between 1 and 4 steps of subdivision");
    EXPECT_NE(refusal("mannequin:busst=92").find("busst: no such measure; known are sex, resolution, stance, height"),
              std::string::npos);
    EXPECT_NE(refusal("mannequin:bust=90,,").find("'name=value' expected"), std::string::npos);
    EXPECT_NE(refusal("mannequins").find("':' expected"), std::string::npos);
    EXPECT_NE(refusal("body.glb").find("expected"), std::string::npos);
}

}  // namespace

namespace {

// A cube of 6 quads and 8 vertices; the fourth column marks its top.
QuadMesh cube() {
    QuadMesh mesh;
    mesh.values.resize(8, 4);
    for (int v = 0; v < 8; ++v) {
        const int x = v & 1;
        const int y = (v >> 1) & 1;
        const int z = (v >> 2) & 1;
        mesh.values.row(v) << 2 * x - 1, 2 * y - 1, 2 * z - 1, y;
    }
    mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return mesh;
}

double volume(const QuadMesh& mesh) {
    double six = 0;
    for (const auto& [a, b, c] : split_quads(mesh)) {
        const Vec3d x = mesh.values.row(a).head<3>();
        const Vec3d y = mesh.values.row(b).head<3>();
        const Vec3d z = mesh.values.row(c).head<3>();
        six += x.dot(y.cross(z));
    }
    return six / 6;
}

TEST(Subdivide, of_a_cube_gives_the_known_vertices) {
    const QuadMesh fine = subdivide(cube());
    ASSERT_EQ(fine.values.rows(), 8 + 12 + 6);
    ASSERT_EQ(fine.quads.size(), 24U);
    // Old corner: (mean of centres 1/3 + 2 mean of midpoints 2/3 + 0) / 3 = 5/9.
    EXPECT_NEAR(fine.values(7, 0), 5.0 / 9, 1e-14);
    // Edge: mean of the midpoint (1, 1) and of two centres (1, 0), (0, 1).
    for (Eigen::Index v = 8; v < 20; ++v) EXPECT_NEAR(fine.values.row(v).head<3>().norm(), std::sqrt(2) * 0.75, 1e-14);
    for (Eigen::Index v = 20; v < 26; ++v) EXPECT_NEAR(fine.values.row(v).head<3>().norm(), 1, 1e-14);
}

TEST(Subdivide, keeps_quads_facing_outward) {
    QuadMesh mesh = cube();
    EXPECT_NEAR(volume(mesh), 8, 1e-12);
    for (int step = 0; step < 3; ++step) {
        const double before = volume(mesh);
        mesh = subdivide(mesh);
        EXPECT_GT(volume(mesh), 0.4 * before);
        EXPECT_LT(volume(mesh), before);
    }
}

TEST(Subdivide, carries_other_values_as_it_carries_positions) {
    const QuadMesh fine = subdivide(subdivide(cube()));
    for (Eigen::Index v = 0; v < fine.values.rows(); ++v) {
        EXPECT_NEAR(fine.values(v, 3), (fine.values(v, 1) + 1) / 2, 1e-14);
    }
}

TEST(MoveToLimit, agrees_with_many_steps) {
    QuadMesh limit = cube();
    move_to_limit(limit);
    QuadMesh fine = cube();
    for (int step = 0; step < 6; ++step) fine = subdivide(fine);
    for (Eigen::Index v = 0; v < 8; ++v) {
        EXPECT_NEAR((fine.values.row(v) - limit.values.row(v)).norm(), 0, 1e-3);
    }
}

TEST(MoveToLimit, gives_the_same_place_at_every_step) {
    QuadMesh early = subdivide(cube());
    QuadMesh late = subdivide(subdivide(early));
    move_to_limit(early);
    move_to_limit(late);
    const Eigen::Index count = early.values.rows();
    EXPECT_LT((late.values.topRows(count) - early.values).norm(), 1e-12);
}

TEST(SplitQuads, cuts_the_shorter_diagonal) {
    QuadMesh kite;
    kite.values.resize(4, 3);
    kite.values << 0, 0, 0, 1, 0, 0, 3, 3, 0, 0, 1, 0;
    kite.quads = {{0, 1, 2, 3}};
    const auto triangles = split_quads(kite);
    EXPECT_EQ(triangles.size(), 2U);
    for (const auto& triangle : triangles) {
        EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 1), 1);
        EXPECT_EQ(std::count(triangle.begin(), triangle.end(), 3), 1);
    }
}

TEST(Pchip, passes_through_its_points_without_overshoot) {
    const Pchip curve({0, 1, 2, 4, 5}, {1, 1, 3, 3.5, 0});
    EXPECT_DOUBLE_EQ(curve(0), 1);
    EXPECT_DOUBLE_EQ(curve(2), 3);
    EXPECT_DOUBLE_EQ(curve(5), 0);
    for (double x = 0; x <= 5; x += 0.01) {
        EXPECT_GE(curve(x), -1e-12);
        EXPECT_LE(curve(x), 3.5 + 1e-12);
    }
    for (double x = 0; x <= 1; x += 0.01) EXPECT_NEAR(curve(x), 1, 1e-12);
}

TEST(Pchip, draws_a_line_through_points_on_a_line) {
    const Pchip line({-1, 0.5, 2, 3}, {-2, 1, 4, 6});
    for (double x = -2; x <= 4; x += 0.1) EXPECT_NEAR(line(x), 2 * x, 1e-12);
}

}  // namespace

}  // namespace selvedge::sim
