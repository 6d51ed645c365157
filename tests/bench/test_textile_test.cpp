// The textile tests on coarse meshes. Checks that the tests measure correctly, not that the solver is accurate.
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "bench/fabric/report.h"
#include "bench/fabric/specimen.h"
#include "bench/fabric/textile_test.h"
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

}  // namespace selvedge::bench
