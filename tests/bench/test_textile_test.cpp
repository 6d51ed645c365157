// The textile tests on coarse meshes. Checks that the tests measure correctly, not that the solver is accurate.
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "bench/fabric/report.h"
#include "bench/fabric/textile_test.h"
#include "bench/fabric/theory.h"
#include "bench/support/measured_mesh.h"
#include "sim/core/error.h"

namespace selvedge::bench {
namespace {

constexpr MeshSetting kCoarse{.angle = 0.3, .level = 0};
constexpr MeshSetting kFine{.angle = 0.3, .level = 1};  // the overhang is several triangles long

TEST(Textile, a_cantilever_of_a_stiffer_fabric_reads_stiffer) {
    sim::Fabric soft;
    sim::Fabric stiff;
    stiff.bending_warp *= 4;
    const Reading a = test_cantilever(soft, YarnDirection::Warp, kFine);
    const Reading b = test_cantilever(stiff, YarnDirection::Warp, kFine);
    EXPECT_TRUE(a.is_at_rest);
    EXPECT_EQ(a.expected, soft.bending_warp);
    EXPECT_GT(a.measured, 0);
    EXPECT_NEAR(b.measured / a.measured, 4, 1);
}

TEST(Textile, a_hanging_strip_expects_what_theory_says) {
    sim::Fabric wool;
    wool.area_density = 0.265;
    wool.stretch_warp = 1500;
    const Reading reading = test_own_weight(wool, YarnDirection::Warp, kCoarse);
    EXPECT_NEAR(reading.expected, 0.265 * 9.81 * 0.5 / 2 / 1500, 1e-9);
    EXPECT_GT(reading.measured, 0);
    EXPECT_LT(reading.measured, 0.1);
}

TEST(Textile, a_load_never_strains_a_fabric_beyond_half_its_limit) {
    sim::Fabric weak;
    weak.stretch_weft = 60;
    weak.strain_limit = 0.1;
    const Reading reading = test_load(weak, YarnDirection::Weft, kCoarse);
    EXPECT_NEAR(reading.expected, 0.05, 0.01);
}

TEST(Textile, a_bias_strip_expects_about_1_percent) {
    EXPECT_NEAR(test_load({}, YarnDirection::Bias, kCoarse).expected, 0.011, 0.002);
}

TEST(Textile, a_strip_swings_about_as_a_hanging_chain_does) {
    EXPECT_NEAR(swing_period({}, {.level = 1}), 0.914, 0.05);
}

TEST(Textile, a_strip_let_go_gains_no_energy) {
    EXPECT_LT(energy_growth({}, kCoarse), 1e-3);
}

TEST(Textile, a_disc_falls_from_its_support) {
    const DrapeReading reading = test_drape({}, {.angle = 0.3, .level = 0});
    EXPECT_GT(reading.coefficient, 5);
    EXPECT_LT(reading.coefficient, 99);
}

TEST(Textile, levels_have_names) {
    EXPECT_EQ(level_name({.level = 2}), "2");
    EXPECT_EQ(level_name({.level = 3, .is_adaptive = true}), "adaptive");
}

}  // namespace

// Specimens have the specified shape at every angle on the mesher's grid.

namespace {

const std::vector<double> kAngles{0, 0.3, std::numbers::pi / 4};

double area_of(const sim::GarmentMesh& mesh, int panel) {
    double area = 0;
    for (const sim::GarmentTriangle& t : mesh.triangles)
        if (t.panel == panel) area += 0.5 * sim::cross2(t.u[1] - t.u[0], t.u[2] - t.u[0]);
    return area;
}

TEST(Specimen, a_strip_hangs_from_its_clamp_and_has_its_size) {
    for (const double angle : kAngles) {
        const Specimen strip = cut_strip({}, {.width = 0.05, .length = 0.4, .weight = 9.81, .mesh_angle = angle}, {});
        EXPECT_NEAR(area_of(strip.mesh, Specimen::kCloth), 0.05 * 0.4, 1e-9);
        Eigen::AlignedBox3d box;
        for (const Vec3d& x : strip.mesh.x) box.extend(x);
        EXPECT_TRUE(box.max().isApprox(Vec3d(0.05, 0.04, 0), 1e-9)) << box.max();
        EXPECT_NEAR(box.min().y(), -0.45, 1e-9);
        EXPECT_TRUE(strip.mesh.links.empty());
        EXPECT_NEAR(strip.fabrics[2].area_density * area_of(strip.mesh, 2) * 9.81, 9.81 * 0.05, 1e-9);
    }
}

TEST(Specimen, a_strip_is_pinned_at_the_clamp_and_nowhere_below) {
    const Specimen strip = cut_strip({}, {.mesh_angle = 0.3}, {});
    int on_edge = 0;
    for (const int pin : strip.mesh.pins) {
        const double y = strip.mesh.x[static_cast<std::size_t>(pin)].y();
        EXPECT_GE(y, -1e-9);
        on_edge += std::abs(y) < 1e-9 ? 1 : 0;
    }
    EXPECT_GE(on_edge, 2);
}

TEST(Specimen, material_points_lie_where_the_frame_puts_them) {
    const Specimen strip = cut_strip({}, {.mesh_angle = 0.3}, {});
    for (const sim::GarmentTriangle& t : strip.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& x = strip.mesh.x[static_cast<std::size_t>(t.vertices[k])];
            EXPECT_LT((strip.material(x.x(), -x.y()) - t.u[k]).norm(), 1e-9);
        }
    }
}

TEST(Specimen, the_warp_follows_the_strip_and_not_the_grid) {
    const Specimen strip = cut_strip({}, {.mesh_angle = 0.3, .warp_angle = 0.5}, {});
    EXPECT_EQ(strip.mesh.panel_grain_angles.size(), strip.mesh.panel_names.size());
    for (const double grain : strip.mesh.panel_grain_angles) EXPECT_NEAR(grain, 0.8, 1e-12);
}

TEST(Specimen, a_ridge_strip_is_pinned_along_its_middle_alone) {
    const SpecimenFrame level{.across = Vec3d::UnitZ(), .along = Vec3d::UnitX()};
    const Specimen strip = cut_ridge_strip({}, {.length = 0.1, .mesh_angle = 0.3}, level);
    ASSERT_GE(strip.mesh.pins.size(), 2U);
    for (const int pin : strip.mesh.pins) EXPECT_NEAR(strip.mesh.x[static_cast<std::size_t>(pin)].x(), 0, 1e-9);
    EXPECT_NEAR(area_of(strip.mesh, 0) + area_of(strip.mesh, 1), 0.05 * 0.2, 1e-9);
}

TEST(Specimen, a_disc_is_held_within_its_support_and_continues_beyond_it_without_a_jump) {
    for (const double angle : kAngles) {
        const Specimen disc = cut_disc({}, {.mesh_angle = angle});
        const double pi = std::numbers::pi;
        EXPECT_NEAR(area_of(disc.mesh, 0) / (pi * 0.09 * 0.09), 1, 0.02);
        EXPECT_NEAR((area_of(disc.mesh, 1) + area_of(disc.mesh, 2)) / (pi * (0.15 * 0.15 - 0.09 * 0.09)), 1, 0.02);
        EXPECT_FALSE(disc.mesh.pins.empty());
        for (const int pin : disc.mesh.pins) EXPECT_LT(disc.mesh.x[static_cast<std::size_t>(pin)].norm(), 0.09 + 1e-9);
        for (const sim::GarmentTriangle& t : disc.mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d& x = disc.mesh.x[static_cast<std::size_t>(t.vertices[k])];
                EXPECT_LT((disc.material(x.x(), -x.z()) - t.u[k]).norm(), 1e-9);
            }
        }
    }
}

}  // namespace

// The gates, settings and tables of the fabric experiment.

namespace {

TEST(FabricReport, asks_more_of_finer_levels) {
    EXPECT_LT(allowed_error({.level = 0}), 0);
    EXPECT_EQ(allowed_error({.level = 1}), 0.1);
    EXPECT_EQ(allowed_error({.level = 2}), 0.05);
    EXPECT_EQ(allowed_error({.level = 3, .is_adaptive = true}), 0.05);
}

TEST(FabricReport, covers_all_levels_and_angles_unless_it_is_quick) {
    EXPECT_EQ(level_settings({}).size(), 5U);
    EXPECT_EQ(mesh_angles({}).size(), 3U);
    EXPECT_EQ(level_settings({.is_quick = true}).size(), 2U);
    EXPECT_EQ(mesh_angles({.is_quick = true}).size(), 1U);
}

TEST(FabricReport, knows_the_published_ranges_of_the_shipped_fabrics) {
    for (const std::string& name : sim::fabric_names()) {
        EXPECT_GT(published_drape(name).low, 0) << name;
        EXPECT_GT(published_drape(name).high, published_drape(name).low) << name;
    }
    EXPECT_EQ(published_drape("sackcloth").high, 0);
}

TEST(FabricReport, gives_each_row_its_expected_value_error_gate_and_verdict) {
    const FabricTables made = measure_fabrics("cantilever", {.fabrics = {"silk"}, .is_quick = true});
    ASSERT_EQ(made.tables.size(), 1U);
    const std::vector<std::string> columns{"fabric", "direction",      "level",   "expected",
                                           "17 deg", "worst error, %", "gate, %", "verdict"};
    EXPECT_EQ(made.tables[0].columns, columns);
    EXPECT_EQ(made.tables[0].rows.size(), 4U);
    EXPECT_EQ(made.rows, 4);
    EXPECT_LE(made.missed, made.rows);
}

TEST(FabricReport, names_a_fabric_that_it_does_not_know) {
    EXPECT_THROW(measure_fabrics("energy", {.fabrics = {"sackcloth"}}), sim::InputError);
}

}  // namespace

// The heavy elastica, compared with independently computed values.

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
        const Deflection d = deflection(row.q);
        EXPECT_NEAR(degrees(chord_angle(d)), row.chord_deg, 0.006) << row.q;
        EXPECT_NEAR(d.reach, row.reach, 6e-5) << row.q;
        EXPECT_NEAR(d.drop, row.drop, 6e-5) << row.q;
    }
}

TEST(Elastica, dips_41_and_a_half_degrees_at_peirces_q) {
    EXPECT_NEAR(degrees(chord_angle(deflection(kPeirceQ))), 41.5, 0.01);
}

TEST(Elastica, of_little_weight_droops_as_a_beam) {
    EXPECT_NEAR(deflection(1e-3).drop, 1e-3 / 8, 1e-8);
}

TEST(Elastica, of_great_weight_hangs_plumb) {
    EXPECT_GT(deflection(1e5).drop, 0.995);
    EXPECT_LT(deflection(1e5).reach, 0.01);
}

TEST(Elastica, is_found_again_from_its_chord) {
    for (const double q : {0.1, 1.0, 8.004, 50.0, 400.0})
        EXPECT_NEAR(q_of_chord_angle(chord_angle(deflection(q))) / q, 1, 1e-5) << q;
}

TEST(Elastica, a_sector_of_a_wide_support_is_a_strip) {
    EXPECT_NEAR(sector_deflection(8, 1e6).reach, deflection(8).reach, 1e-5);
    EXPECT_LT(sector_deflection(8, 1.5).reach,
              deflection(8).reach);  // it widens outward, so more weight is far from the clamp
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
