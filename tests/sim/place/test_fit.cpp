// Garments smaller than the body are distinguished from those that only hang close.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern_file.h"
#include "sim/place/fit.h"
#include "sim/session/dress.h"
#include "tests/support/bodies.h"
#include "tests/support/checkout.h"

namespace selvedge::sim::test {
namespace {

constexpr double kOffset = FitOptions{}.contact_offset;
constexpr double kOffsetGirth = 2 * std::numbers::pi * kOffset;
constexpr double kThicknessGirth = 2 * std::numbers::pi * 0.0003;

struct RoundOptions {
    double girth = 1;   // m, of the material
    double radius = 0;  // m, of the tube in 3D
    double low = 0;     // m
    double high = 1;    // m
    double x = 0;       // m, of the axis
    bool is_open = false;
};

// An upright tube of one panel, sewn to itself at the back, so that u is discontinuous there; is_open: not sewn.
DrawMesh round_garment(const RoundOptions& options) {
    constexpr unsigned kColumns = 48;
    constexpr unsigned kRows = 20;
    DrawMesh garment;
    const unsigned width = options.is_open ? kColumns + 1 : kColumns;
    for (unsigned row = 0; row <= kRows; ++row)
        for (unsigned column = 0; column < width; ++column) {
            const double angle = 2 * std::numbers::pi * column / kColumns;
            const double y = options.low + (options.high - options.low) * row / kRows;
            const Vec3d x(options.x - options.radius * std::sin(angle), y, -options.radius * std::cos(angle));
            garment.x.push_back(x.cast<float>());
        }
    const auto add = [&](const std::array<std::array<unsigned, 2>, 3>& corners) {
        auto& vertices = garment.triangles.emplace_back();
        auto& u = garment.u.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [row, column] = corners[k];
            vertices[k] = row * width + column % width;
            u[k] = Vec2d(options.girth * column / kColumns, (options.high - options.low) * row / kRows).cast<float>();
        }
    };
    for (unsigned row = 0; row < kRows; ++row)
        for (unsigned column = 0; column < kColumns; ++column) {
            add({{{row, column}, {row, column + 1}, {row + 1, column + 1}}});
            add({{{row, column}, {row + 1, column + 1}, {row + 1, column}}});
        }
    return garment;
}

DrawMesh together(const DrawMesh& first, const DrawMesh& second) {
    DrawMesh mesh = first;
    const auto offset = std::uint32_t(first.x.size());
    mesh.x.insert(mesh.x.end(), second.x.begin(), second.x.end());
    mesh.u.insert(mesh.u.end(), second.u.begin(), second.u.end());
    for (const auto& [a, b, c] : second.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
    return mesh;
}

// A column with a girth of 1 m, from the floor to 1.7 m.
Body column() {
    return shapes::box(Vec3d(-0.15, 0, -0.1), Vec3d(0.15, 1.7, 0.1), 8);
}

Body leg(double x) {
    return shapes::box(Vec3d(x - 0.06, 0, -0.07), Vec3d(x + 0.06, 0.8, 0.07), 6);
}

TEST(Fit, a_loop_that_passes_through_the_body_tells_nothing_of_its_size) {
    const DrawMesh round = round_garment({.girth = 0.8, .radius = 0.19, .low = 0.9, .high = 1.1});
    EXPECT_FALSE(tight_levels(round, column()).empty());
    const DrawMesh through = round_garment({.girth = 0.8, .radius = 0.12, .low = 0.9, .high = 1.1, .x = 0.08});
    EXPECT_TRUE(tight_levels(through, column()).empty()) << "it encloses the middle, and cuts the side";
}

TEST(Fit, a_tube_drafted_larger_than_the_body_is_not_tight) {
    const DrawMesh garment = round_garment({.girth = 1 + kOffsetGirth + 0.001, .radius = 0.2, .low = 0.5});
    EXPECT_TRUE(tight_levels(garment, column()).empty());
}

TEST(Fit, a_tube_drafted_smaller_is_tight_at_each_level_however_far_it_is_stretched) {
    for (const double radius : {0.2, 0.3}) {
        const auto levels =
            tight_levels(round_garment({.girth = 0.9, .radius = radius, .low = 0.51, .high = 0.91}), column());
        ASSERT_EQ(levels.size(), 20U);
        for (std::size_t i = 0; i < levels.size(); ++i) {
            EXPECT_NEAR(levels[i].y, 0.52 + 0.02 * double(i), 1e-9);
            EXPECT_NEAR(levels[i].garment_girth, 0.9, 1e-5);
            EXPECT_NEAR(levels[i].body_girth, 1 + kThicknessGirth, 1e-9);
            EXPECT_NEAR(levels[i].contact_girth, 1 + kOffsetGirth, 1e-9);
            EXPECT_NEAR(shortfall(levels[i]), 0.1 + kThicknessGirth, 1e-5);
        }
    }
}

TEST(Fit, a_garment_without_ease_is_not_too_small) {
    EXPECT_LT(kThicknessGirth, 0.002);
    for (const TightLevel& level : tight_levels(round_garment({.girth = 1, .radius = 0.2}), column()))
        EXPECT_EQ(shortfall(level), 0);
    for (const TightLevel& level : tight_levels(round_garment({.girth = 0.99, .radius = 0.2}), column()))
        EXPECT_NEAR(shortfall(level), 0.01 + kThicknessGirth, 1e-5);
}

TEST(Fit, each_panel_may_stretch_to_its_own_limit) {
    DrawMesh garment = round_garment({.girth = 0.9, .radius = 0.2, .low = 0.51, .high = 0.53});
    garment.panel.assign(garment.triangles.size(), 1);
    const auto levels = tight_levels(garment, column(), {.strain_limits = {0, 0.1}});
    ASSERT_EQ(levels.size(), 1U);
    EXPECT_NEAR(levels[0].limit_girth, 1.1 * 0.9, 1e-5);
    EXPECT_NEAR(tight_levels(garment, column()).at(0).limit_girth, 0.9, 1e-5);
}

TEST(Fit, a_tube_whose_left_half_shows_its_wrong_side_is_as_tight) {
    DrawMesh garment = round_garment({.girth = 0.9, .radius = 0.2, .low = 0.51, .high = 0.91});
    const auto expected = tight_levels(garment, column());
    for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
        if (garment.u[t][0].x() < 0.45F && garment.u[t][1].x() < 0.46F && garment.u[t][2].x() < 0.46F)
            std::swap(garment.triangles[t][1], garment.triangles[t][2]), std::swap(garment.u[t][1], garment.u[t][2]);
    }
    const auto levels = tight_levels(garment, column());
    ASSERT_EQ(levels.size(), expected.size());
    for (std::size_t i = 0; i < levels.size(); ++i)
        EXPECT_NEAR(levels[i].garment_girth, expected[i].garment_girth, 1e-6);
}

TEST(Fit, the_room_that_cloth_keeps_from_the_body_counts_but_half_a_percent_does_not) {
    const auto is_tight = [](double girth) {
        return !tight_levels(round_garment({.girth = girth, .radius = 0.2}), column()).empty();
    };
    EXPECT_TRUE(is_tight(0.994 * (1 + kOffsetGirth)));
    EXPECT_FALSE(is_tight(0.996 * (1 + kOffsetGirth)));
}

TEST(Fit, is_tight_only_where_the_body_bulges) {
    const Body ball = shapes::sphere(Vec3d(0, 1, 0), 0.15, 32);
    const double girth = 2 * std::numbers::pi * 0.12;
    const auto levels =
        tight_levels(round_garment({.girth = girth, .radius = 0.16, .low = 0.8, .high = 1.2}), ball, {.step = 0.01});
    ASSERT_FALSE(levels.empty());
    const double radius = girth / 0.995 / (2 * std::numbers::pi) - kOffset;
    const double half_height = std::sqrt(0.15 * 0.15 - radius * radius);
    EXPECT_NEAR(levels.front().y, 1 - half_height, 0.012);
    EXPECT_NEAR(levels.back().y, 1 + half_height, 0.012);
}

// A ball with a waist a little above its middle: radius 14.6 cm at y 1, 8.8 cm at y 1.06, 10.8 cm at y 1.08.
Body ball_with_waist() {
    Body body = shapes::sphere(Vec3d(0, 1, 0), 0.15, 96);
    for (Vec3d& x : body.x) {
        const double width = (x.y() - 1.05) / 0.03;
        const double factor = 1 - 0.4 * std::exp(-width * width);
        x.x() *= factor;
        x.z() *= factor;
    }
    return body;
}

TEST(Fit, a_loop_reaches_the_waist_above_it_but_not_what_lies_behind_a_bulge) {
    const Body body = ball_with_waist();
    const auto levels = tight_levels(round_garment({.girth = 0.4, .radius = 0.2, .low = 0.9, .high = 1.1}), body);
    const LevelSections sections(body);
    const auto reach_from = [&](double y) {
        for (const TightLevel& level : levels)
            if (std::abs(level.y - y) < 1e-6)
                return slid_to_narrowest(level, sections).body_girth / (2 * std::numbers::pi);
        ADD_FAILURE() << "no tight level at " << y;
        return 0.0;
    };
    EXPECT_NEAR(reach_from(1.0), 0.0883, 0.001);
    EXPECT_NEAR(reach_from(1.04), 0.0883, 0.001);
    EXPECT_LT(reach_from(0.94), 0.06) << "it slides off at the bottom";
}

TEST(Fit, a_loop_reaches_what_both_legs_need_together) {
    const Body legs = shapes::together(leg(-0.1), leg(0.1));
    const auto levels = tight_levels(round_garment({.girth = 0.8, .radius = 0.2, .low = 0.3, .high = 0.7}), legs);
    ASSERT_FALSE(levels.empty());
    EXPECT_NEAR(slid_to_narrowest(levels[0], LevelSections(legs)).body_girth, 2 * (0.32 + 0.14) + kThicknessGirth,
                1e-9);
}

TEST(Fit, a_skirt_has_one_tape_round_both_legs) {
    const Body legs = shapes::together(leg(-0.1), leg(0.1));
    const double tape = 2 * (0.32 + 0.14) + kOffsetGirth;
    const auto tight = tight_levels(round_garment({.girth = 0.91, .radius = 0.2, .low = 0.3, .high = 0.7}), legs);
    ASSERT_FALSE(tight.empty());
    for (const TightLevel& level : tight) EXPECT_NEAR(level.contact_girth, tape, 1e-9);
    EXPECT_TRUE(tight_levels(round_garment({.girth = tape, .radius = 0.2, .low = 0.3, .high = 0.7}), legs).empty());
}

TEST(Fit, each_trouser_leg_is_compared_with_its_own_leg) {
    const Body legs = shapes::together(leg(-0.1), leg(0.1));
    const double tape = 2 * (0.12 + 0.14) + kOffsetGirth;
    const DrawMesh trousers = together(round_garment({.girth = tape, .radius = 0.095, .high = 0.7, .x = -0.1}),
                                       round_garment({.girth = 0.9 * tape, .radius = 0.095, .high = 0.7, .x = 0.1}));
    const auto levels = tight_levels(trousers, legs);
    ASSERT_FALSE(levels.empty());
    for (const TightLevel& level : levels) {
        EXPECT_NEAR(level.contact_girth, tape, 1e-9);
        EXPECT_NEAR(level.low.x(), 0.005, 1e-3);
        EXPECT_NEAR(level.high.x(), 0.195, 1e-3);
    }
    EXPECT_NEAR(explained_strain(levels, Vec3d(0.1, 0.4, 0.07)), 1 / 0.9 - 1, 1e-4);
    EXPECT_EQ(explained_strain(levels, Vec3d(-0.1, 0.4, 0.07)), 0);
}

// Along x, at a height of 1.4 m, with a girth of 40 cm, and the limbs of a body that has it and a trunk beside it.
Body level_arm() {
    return shapes::box({0, 1.35, -0.05}, {0.6, 1.45, 0.05}, 8);
}

BodyLimbs limbs_of_level_arm() {
    BodyLimbs limbs;
    limbs.torso = {{{-1, 1, 0}, 0.1}, {{-1, 1.5, 0}, 0.1}};
    limbs.limbs[index_of(LimbKind::LeftArm)] = {
        .is_found = true,
        .joints = {{{0.01, 1.4, 0}, 0.06}, {{0.3, 1.4, 0}, 0.06}, {{0.59, 1.4, 0}, 0.06}},
        .line = {}};
    return limbs;
}

DrawMesh level_sleeve(double girth) {
    DrawMesh sleeve = round_garment({.girth = girth, .radius = 0.08, .low = 0.1, .high = 0.25});
    for (Vec3f& x : sleeve.x) x = Vec3f(x.y(), 1.4F - x.x(), x.z());
    return sleeve;
}

TEST(Fit, a_sleeve_on_a_level_arm_is_compared_with_the_arm_in_it) {
    const Body arm = level_arm();
    const DrawMesh sleeve = level_sleeve(0.37);
    EXPECT_TRUE(tight_levels(sleeve, arm).empty()) << "level planes cut it open";
    const std::vector<TightLevel> tight = tight_round_level_limbs(sleeve, arm, limbs_of_level_arm());
    ASSERT_GE(tight.size(), 6U) << "one in 2 cm";
    for (const TightLevel& level : tight) {
        EXPECT_NEAR(level.garment_girth, 0.37, 1e-4);
        EXPECT_NEAR(shortfall(level), 0.03 + kThicknessGirth, 1e-3);
    }
    EXPECT_NEAR(explained_strain(tight, Vec3d(0.2, 1.45, 0)), (0.4 + kOffsetGirth) / 0.37 - 1, 1e-3);
    EXPECT_EQ(explained_strain(tight, Vec3d(0.5, 1.4, 0)), 0) << "beyond the cuff";
    EXPECT_TRUE(tight_round_level_limbs(level_sleeve(0.42), arm, limbs_of_level_arm()).empty());
}

TEST(Fit, a_sleeve_that_cuts_a_limb_is_too_small_for_it_only_if_it_cannot_go_round) {
    const Body arm = level_arm();
    const BodyLimbs limbs = limbs_of_level_arm();
    const Vec3d on_arm(0.2, 1.44, 0);
    const auto small = too_small_for_limb(level_sleeve(0.37), arm, limbs, on_arm);
    ASSERT_TRUE(small);
    EXPECT_NEAR(shortfall(*small), 0.03 + kThicknessGirth, 1e-3);
    EXPECT_FALSE(too_small_for_limb(level_sleeve(0.45), arm, limbs, on_arm)) << "it passes through for another reason";
    EXPECT_FALSE(too_small_for_limb(level_sleeve(0.39), arm, limbs, on_arm, {.strain_limits = {0.05}}))
        << "it stretches";
    EXPECT_FALSE(too_small_for_limb(level_sleeve(0.37), arm, limbs, Vec3d(0.5, 1.44, 0))) << "beyond the cuff";
}

TEST(Fit, a_garment_that_hangs_open_or_beside_the_body_has_no_girth) {
    EXPECT_TRUE(tight_levels(round_garment({.girth = 0.5, .radius = 0.2, .is_open = true}), column()).empty());
    EXPECT_TRUE(tight_levels(round_garment({.girth = 0.5, .radius = 0.2, .x = 0.5}), column()).empty());
    EXPECT_TRUE(tight_levels(DrawMesh{}, column()).empty());
}

TEST(Fit, a_tight_level_explains_strain_a_little_above_and_below) {
    TightLevel level{.y = 1.2, .garment_girth = 0.9, .low = {-0.2, 1.2, -0.1}, .high = {0.2, 1.2, 0.1}};
    level.contact_girth = 0.99;
    TightLevel tighter = level;
    tighter.contact_girth = 1.08;
    tighter.low.y() = tighter.high.y() = 1.22;
    const std::vector<TightLevel> levels{level, tighter};
    EXPECT_NEAR(explained_strain(levels, Vec3d(0, 1.16, 0.1)), 0.1, 1e-9) << "only the lower one is near";
    EXPECT_NEAR(explained_strain(levels, Vec3d(0, 1.21, 0.1)), 0.2, 1e-9) << "the tighter one counts";
    EXPECT_EQ(explained_strain(levels, Vec3d(0, 1.149, 0.1)), 0);
    EXPECT_EQ(explained_strain(levels, Vec3d(0.251, 1.2, 0)), 0);
    EXPECT_EQ(explained_strain({}, Vec3d(0, 1.2, 0)), 0);
}

// The shipped T-shirt at its base mesh, on a mannequin with this bust.
class FitOfTheTshirt : public testing::Test {
 protected:
    static Mannequin mannequin(std::optional<double> bust) {
        MannequinOptions options{.subdivisions = 1};
        options.measures.bust = bust;
        return make_mannequin(options);
    }
    static std::vector<TightLevel> levels_on(const Body& body) {
        const Pattern pattern =
            load_pattern(std::filesystem::path(source_folder()) / "patterns" / "tshirt.json").pattern;
        DressOptions options;
        options.max_level = 0;
        return tight_levels(dress(pattern, body, options).mesh, body);
    }
    static std::string list(const std::vector<TightLevel>& levels) {
        std::string text;
        for (const TightLevel& level : levels) {
            text += "y " + std::to_string(level.y) + ": " + std::to_string(level.garment_girth) + " round " +
                    std::to_string(level.body_girth) + ", x " + std::to_string(level.low.x()) + " to " +
                    std::to_string(level.high.x()) + "\n";
        }
        return text;
    }
};

TEST_F(FitOfTheTshirt, is_loose_on_its_own_mannequin) {
    const auto levels = levels_on(mannequin({}).body);
    EXPECT_TRUE(levels.empty()) << list(levels);
}

TEST_F(FitOfTheTshirt, is_tight_round_a_bust_of_110_cm) {
    const Mannequin wide = mannequin(1.10);
    const auto bust = std::find_if(wide.report.readings.begin(), wide.report.readings.end(),
                                   [](const MeasureReading& reading) { return reading.name == "bust"; });
    ASSERT_NE(bust, wide.report.readings.end());
    const auto levels = levels_on(wide.body);
    EXPECT_GT(explained_strain(levels, Vec3d(0, bust->level.value(), 0)), 0) << list(levels);
    const auto widest = std::max_element(levels.begin(), levels.end(),
                                         [](const auto& a, const auto& b) { return a.body_girth < b.body_girth; });
    ASSERT_NE(widest, levels.end());
    EXPECT_NEAR(widest->body_girth, 1.10 + kThicknessGirth, 0.02) << list(levels);
    EXPECT_NEAR(widest->y, *bust->level, 0.03);
}

}  // namespace
}  // namespace selvedge::sim::test
