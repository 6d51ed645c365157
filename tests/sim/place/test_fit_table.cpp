// The fit table measures what a tailor would: on the mannequin its own measures, on tubes their girths.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <string_view>

#include "sim/body/landmarks.h"
#include "sim/mannequin/mannequin.h"
#include "sim/place/fit_table.h"
#include "sim/place/limbs.h"
#include "sim/repair/outer_hull.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"
#include "tests/support/posed_body.h"
#include "tests/support/touching_thighs.h"

namespace selvedge::sim::test {
namespace {

std::vector<FitRow> fit_on(const DrawMesh& garment, const Body& body) {
    return measure_fit(garment, MeasuredBody(body));
}

const FitRow& row(const std::vector<FitRow>& rows, std::string_view measure) {
    for (const FitRow& one : rows) {
        if (one.measure == measure) return one;
    }
    ADD_FAILURE() << "no row " << measure;
    return rows.front();
}

struct Tube {
    Vec3d from = Vec3d::Zero();  // m, on its axis
    Vec3d to = Vec3d::Zero();
    double radius = 0;  // m
    double girth = 0;   // m, of the cloth, which may be stretched
};

// A tube with open ends round an axis.
DrawMesh worn_tube(const Tube& tube) {
    constexpr unsigned kRound = 32;
    const Vec3d axis = (tube.to - tube.from).normalized();
    const Vec3d first = axis.unitOrthogonal(), second = axis.cross(first);
    DrawMesh mesh;
    for (const Vec3d& end : {tube.from, tube.to}) {
        for (unsigned i = 0; i < kRound; ++i) {
            const double angle = 2 * std::numbers::pi * i / kRound;
            mesh.x.push_back((end + tube.radius * (std::cos(angle) * first + std::sin(angle) * second)).cast<float>());
        }
    }
    const auto add = [&](unsigned column, std::array<unsigned, 3> columns, std::array<unsigned, 3> rows) {
        auto& vertices = mesh.triangles.emplace_back();
        auto& u = mesh.u.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            vertices[k] = rows[k] * kRound + (column + columns[k]) % kRound;
            u[k] = Vec2d(tube.girth * (column + columns[k]) / kRound, rows[k] * (tube.to - tube.from).norm())
                       .cast<float>();
        }
    };
    for (unsigned i = 0; i < kRound; ++i) {
        add(i, {0, 1, 1}, {0, 0, 1});
        add(i, {0, 1, 0}, {0, 1, 1});
    }
    return mesh;
}

TEST(FitTable, measures_the_mannequin_as_it_was_asked_for) {
    for (const double more : {0.0, 0.12}) {
        const Mannequin asked =
            make_mannequin({.measures = {.bust = 0.9 + more, .waist = 0.7 + more, .hip = 0.96 + more, .neck = 0.36},
                            .subdivisions = 1});
        const std::vector<FitRow> rows = fit_on({}, asked.body);
        ASSERT_EQ(rows.size(), 8U);
        EXPECT_NEAR(row(rows, "bust").body_girth.value(), 0.9 + more, 0.02);
        EXPECT_NEAR(row(rows, "waist").body_girth.value(), 0.7 + more, 0.01);
        EXPECT_NEAR(row(rows, "hip").body_girth.value(), 0.96 + more, 0.01);
        EXPECT_NEAR(row(rows, "neck").body_girth.value(), 0.36, 0.02);
        for (const MeasureReading& reading : asked.report.readings) {
            if (reading.name == "biceps") {
                EXPECT_NEAR(row(rows, "left_sleeve").body_girth.value(), reading.measured, 0.01);
            }
            if (reading.name == "thigh") {
                EXPECT_NEAR(row(rows, "right_thigh").body_girth.value(), reading.measured, 0.01);
            }
        }
        for (const FitRow& one : rows) EXPECT_FALSE(one.garment_girth || one.ease()) << one.measure;
    }
}

// Of drafts for large sizes: legs of 41 % of the stature, so that the hip is fullest at 42 % of it.
TEST(FitTable, finds_waist_and_hip_of_a_body_of_other_proportions) {
    MannequinMeasures measures{.height = 1.967, .inseam = 0.801, .bust = 1.105, .waist = 0.882, .hip = 1.084};
    for (const auto& waist_height : {std::optional<double>(), std::optional(1.209)}) {
        measures.waist_height = waist_height;
        const Mannequin asked = make_mannequin({.sex = Sex::Male, .measures = measures, .subdivisions = 1});
        const std::vector<FitRow> rows = fit_on({}, asked.body);
        EXPECT_NEAR(row(rows, "waist").body_girth.value(), 0.882, 0.003);
        EXPECT_NEAR(row(rows, "hip").body_girth.value(), 1.084, 0.003);
    }
}

TEST(FitTable, measures_a_tube_round_the_trunk_in_its_cloth) {
    const std::vector<FitRow> rows =
        fit_on(worn_tube({.from = {0, 0.9, 0}, .to = {0, 1.2, 0}, .radius = 0.19, .girth = 0.9}), mannequin());
    const FitRow& waist = row(rows, "waist");
    EXPECT_NEAR(waist.garment_girth.value(), 0.9, 1e-6);
    EXPECT_NEAR(waist.ease().value(), 0.9 - *waist.body_girth, 1e-6);
    EXPECT_FALSE(row(rows, "neck").garment_girth);
    EXPECT_FALSE(row(rows, "left_sleeve").garment_girth);
}

TEST(FitTable, the_waist_of_a_skirt_that_hangs_lower_is_at_its_upper_edge) {
    const Body& body = mannequin();
    const double height = find_stature(body).height(), waist = torso_heights(body, find_stature(body)).waist;
    const DrawMesh skirt = worn_tube({Vec3d(0, 0.4, 0), Vec3d(0, waist - 0.02 * height, 0), 0.25, 0.9});
    const FitRow lower = row(fit_on(skirt, body), "waist");
    ASSERT_TRUE(lower.garment_girth.has_value());
    EXPECT_NEAR(*lower.garment_girth, 0.9, 1e-6);
    EXPECT_EQ(*lower.body_girth, *row(fit_on({}, body), "waist").body_girth) << "a body has one waist";
    const DrawMesh stocking = worn_tube({Vec3d(0, 0.1, 0), Vec3d(0, 0.5 * height, 0), 0.25, 0.9});
    EXPECT_FALSE(row(fit_on(stocking, body), "waist").garment_girth.has_value());
}

TEST(FitTable, the_chest_of_a_garment_is_under_its_armholes) {
    const Body& body = mannequin();
    const double waist = torso_heights(body, find_stature(body)).waist;
    const DrawMesh under_the_bust = worn_tube({Vec3d(0, waist - 0.2, 0), Vec3d(0, waist + 0.12, 0), 0.22, 0.98});
    const FitRow bust = row(fit_on(under_the_bust, body), "bust");
    EXPECT_EQ(*bust.body_girth, *row(fit_on({}, body), "bust").body_girth);
    EXPECT_NEAR(bust.garment_girth.value(), 0.98, 1e-6);
    for (const double above : {-0.05, 0.04, 0.06}) {  // also of trousers with a high waistband
        const DrawMesh trousers = worn_tube({Vec3d(0, waist - 0.3, 0), Vec3d(0, waist + above, 0), 0.22, 0.98});
        EXPECT_FALSE(row(fit_on(trousers, body), "bust").garment_girth.has_value()) << above;
    }
}

TEST(FitTable, a_cape_round_the_arms_has_no_girth_of_the_trunk) {
    const std::vector<FitRow> rows =
        fit_on(worn_tube({.from = {0, 0.8, 0}, .to = {0, 1.35, 0}, .radius = 0.9, .girth = 5.6}), mannequin());
    for (const FitRow& one : rows) EXPECT_FALSE(one.garment_girth) << one.measure;
}

TEST(FitTable, a_sleeve_is_measured_square_to_the_arm_and_a_skirt_has_no_thigh) {
    const BodyLimbs limbs = find_limbs(mannequin());
    const Limb& arm = limbs[LimbKind::LeftArm];
    const std::vector<FitRow> sleeve =
        fit_on(worn_tube({.from = arm.joints[0].centre, .to = arm.joints[1].centre, .radius = 0.06, .girth = 0.38}),
               mannequin());
    EXPECT_NEAR(row(sleeve, "left_sleeve").garment_girth.value(), 0.38, 1e-6);
    EXPECT_FALSE(row(sleeve, "right_sleeve").garment_girth);
    EXPECT_FALSE(row(sleeve, "bust").garment_girth);

    const std::vector<FitRow> skirt =
        fit_on(worn_tube({.from = {0, 0.4, 0}, .to = {0, 1.0, 0}, .radius = 0.25, .girth = 1.6}), mannequin());
    EXPECT_FALSE(row(skirt, "left_thigh").garment_girth);
    EXPECT_NEAR(row(skirt, "hip").garment_girth.value(), 1.6, 1e-6);

    const Limb& leg = limbs[LimbKind::RightLeg];
    const std::vector<FitRow> trouser =
        fit_on(worn_tube({.from = leg.joints[0].centre, .to = leg.joints[1].centre, .radius = 0.1, .girth = 0.66}),
               mannequin());
    EXPECT_NEAR(row(trouser, "right_thigh").garment_girth.value(), 0.66, 0.002) << "level, and the leg leans";
    EXPECT_FALSE(row(trouser, "left_thigh").garment_girth);
}

// The mannequin in a stiff coat that is one with its arms down to the elbows.
Body in_a_stiff_coat() {
    Body body = mannequin();
    const Vec3d elbow = find_limbs(body)[LimbKind::LeftArm].joints[1].centre;
    const Body coat = shapes::box({-elbow.x(), elbow.y() - 0.4, -0.14}, {elbow.x(), 1.35, 0.14}, 4);
    Surface pieces{.x = body.x, .triangles = body.triangles, .origin = {}};
    const int first = static_cast<int>(body.x.size());
    pieces.x.insert(pieces.x.end(), coat.x.begin(), coat.x.end());
    for (const auto& [a, b, c] : coat.triangles) pieces.triangles.push_back({first + a, first + b, first + c});
    pieces.origin.resize(pieces.x.size());
    std::iota(pieces.origin.begin(), pieces.origin.end(), 0);
    const Surface hull = outer_hull(pieces, {.cell = 0.015});
    body.skin.resize(pieces.x.size(), body.skin.front());
    body.skin = hull_skin(hull, body.skin);
    body.x = hull.x;
    body.triangles = hull.triangles;
    body.made_from.clear();
    return body;
}

TEST(FitTable, an_arm_that_is_one_with_a_coat_has_no_sleeve) {
    const std::vector<FitRow> rows = fit_on({}, in_a_stiff_coat());
    EXPECT_FALSE(row(rows, "left_sleeve").body_girth) << *row(rows, "left_sleeve").body_girth;
    EXPECT_FALSE(row(rows, "right_sleeve").body_girth);
    EXPECT_TRUE(row(rows, "left_thigh").body_girth);
}

double crotch_of(const Body& body) {
    return find_landmarks(body).crotch.value();
}

TEST(FitTable, a_thigh_is_measured_under_the_crotch_whatever_the_skeleton_says) {
    Body surface = mannequin();
    const FitRow with_bones = row(fit_on({}, surface), "left_thigh");
    surface.bones.clear();
    surface.skin.clear();
    for (const char* thigh : {"left_thigh", "right_thigh"}) {
        const FitRow found = row(fit_on({}, surface), thigh);
        EXPECT_NEAR(found.body_girth.value(), with_bones.body_girth.value(), 1e-4) << thigh;
        EXPECT_NEAR(found.plane.value().point.y(), crotch_of(surface) - 0.03, 0.01) << thigh;
        EXPECT_EQ(found.plane->normal.cwiseAbs(), Vec3d::UnitY()) << thigh;
    }
}

TEST(FitTable, thighs_that_touch_or_overlap_are_measured_one_by_one) {
    Body apart = mannequin();
    apart.bones.clear();
    apart.skin.clear();
    const double girth = row(fit_on({}, apart), "left_thigh").body_girth.value();
    for (const double overlap : {0.0, 0.005}) {
        const Body touching = with_touching_thighs(apart, crotch_of(apart), overlap);
        const std::vector<FitRow> rows = fit_on({}, touching);
        EXPECT_NEAR(row(rows, "left_thigh").body_girth.value(), girth, 0.01) << overlap;
        EXPECT_NEAR(row(rows, "right_thigh").body_girth.value(), girth, 0.01) << overlap;
    }
}

TEST(FitTable, the_thighs_of_a_body_that_sits_are_measured_square_to_them) {
    const Body sits = shapes::in_seat(mannequin());
    const FitRow thigh = row(fit_on({}, sits), "left_thigh");
    ASSERT_TRUE(thigh.body_girth.has_value());
    EXPECT_LT(std::abs(thigh.plane->normal.y()), 0.5);
    EXPECT_NEAR(*thigh.body_girth, row(fit_on({}, mannequin()), "left_thigh").body_girth.value(), 0.08)
        << "skinning loses volume";
}

TEST(FitTable, legs_that_never_part_have_no_thighs) {
    Body skirted = mannequin();
    const double crotch = crotch_of(skirted);
    std::erase_if(skirted.triangles, [&](const std::array<int, 3>& t) {
        return std::ranges::any_of(t,
                                   [&](int v) { return skirted.x[static_cast<std::size_t>(v)].y() < crotch + 0.05; });
    });
    const std::vector<FitRow> rows = fit_on({}, skirted);
    EXPECT_FALSE(row(rows, "left_thigh").body_girth.has_value());
    EXPECT_TRUE(row(rows, "waist").body_girth.has_value());
}

TEST(FitTable, the_neck_of_a_large_head_is_below_it) {
    Body body = mannequin();
    const FitRow usual = row(fit_on({}, body), "neck");
    const double chin = 0.88 * find_stature(body).height();
    for (Vec3d& x : body.x) {
        const double share = smoothstep(x.y(), usual.plane->point.y(), chin);
        x.y() -= 0.05 * share;
        x.x() *= 1 + 0.8 * share;
    }
    body.bones.clear();
    body.skin.clear();
    EXPECT_NEAR(row(fit_on({}, body), "neck").body_girth.value(), *usual.body_girth, 0.04);
}

}  // namespace
}  // namespace selvedge::sim::test
