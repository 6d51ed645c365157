// The drop on a sphere: its scene, and the quality measures of a run. The meshes are coarser than in the benchmark.
#include <gtest/gtest.h>
#include <algorithm>

#include "bench/drop/drop.h"
#include "bench/drop/report.h"
#include "bench/support/measured_mesh.h"
#include "sim/cloth/solver_state.h"

namespace selvedge::bench {
namespace {

constexpr DropScene kCoarseScene{.level = 1};

SphereDropOptions coarse(int substeps) {
    return {.base_quads = 3, .substeps = substeps, .scene = kCoarseScene};
}

TEST(Drop, has_the_four_sizes_of_the_comparison) {
    EXPECT_EQ(base_quads_for(1152), 3);
    EXPECT_EQ(base_quads_for(4608), 6);
    EXPECT_EQ(base_quads_for(15488), 11);
    EXPECT_EQ(base_quads_for(61952), 22);
    EXPECT_EQ(base_quads_for(1), 3);
    EXPECT_EQ(base_quads_for(16000), 11);
    EXPECT_EQ(base_quads_for(1000000), 22);
    for (const int quads : {3, 6, 11, 22}) EXPECT_EQ(base_quads_for(triangle_count(quads, 3)), quads);
    EXPECT_EQ(triangle_count(11, 3), 15488);
}

TEST(Drop, starts_as_a_level_square_of_a_metre_just_above_the_sphere) {
    const sim::GarmentMesh square = drop_square(6);
    Eigen::AlignedBox3d box;
    for (const Vec3d& x : square.x) box.extend(x);
    EXPECT_TRUE(box.min().isApprox(Vec3d(-0.5, 0.256, -0.5)));
    EXPECT_TRUE(box.max().isApprox(Vec3d(0.5, 0.256, 0.5)));
    EXPECT_EQ(square.triangles.size(), 72U);
}

TEST(Drop, is_looked_at_seven_times) {
    int samples = 0;
    for (int frame = 1; frame <= 90; ++frame) samples += is_sampled(frame) ? 1 : 0;
    EXPECT_EQ(samples, 7);
    EXPECT_TRUE(is_sampled(30));
    EXPECT_TRUE(is_sampled(90));
    EXPECT_FALSE(is_sampled(20));
}

TEST(Drop, holds_vertices_alone_unless_samples_are_asked_for) {
    SphereDropOptions options = coarse(4);
    options.scene.frames = 1;
    EXPECT_EQ(sample_count(run_sphere_drop(options).run.cloth.solver->contacts), 0U);
    options.has_contact_samples = true;
    EXPECT_EQ(sample_count(run_sphere_drop(options).run.cloth.solver->contacts), 72U);
}

TEST(Drop, pins_the_middle_of_even_and_of_odd_grids_and_nothing_else) {
    for (const int quads : {2, 3}) {
        SphereDropOptions options = coarse(4);
        options.base_quads = quads;
        options.scene.frames = 1;
        const SphereDrop drop = run_sphere_drop(options);
        std::vector<Vec3d> pinned;
        for (const sim::VertexId v : drop.run.cloth.mesh.leaf_vertices())
            if (drop.run.cloth.is_pinned[v.value]) pinned.push_back(positions(drop.run)[v.value]);
        ASSERT_EQ(pinned.size(), 1U);
        EXPECT_LT((pinned[0] - Vec3d(0, 0.256, 0)).norm(), 1e-6);
    }
}

TEST(Drop, hangs_over_the_sphere_and_no_vertex_is_inside) {
    const SphereDrop drop = run_sphere_drop(coarse(16));
    EXPECT_TRUE(drop.quality.is_finite);
    EXPECT_GE(drop.quality.min_gap, 0);
    EXPECT_LT(drop.quality.min_gap, 0.01);
    double lowest = 1;
    for (const int v : measured(drop.run).vertices)
        lowest = std::min(lowest, positions(drop.run)[static_cast<std::size_t>(v)].y());
    EXPECT_LT(lowest, 0);
}

TEST(Drop, more_substeps_stretch_less) {
    EXPECT_LT(run_sphere_drop(coarse(32)).quality.p99_stretch, run_sphere_drop(coarse(1)).quality.p99_stretch);
}

TEST(DropEvaluator, finds_a_vertex_inside_the_sphere_and_means_the_samples) {
    const sim::GarmentMesh square = flat_grid(10);
    DropEvaluator judge(measured(square));
    judge.sample(square.x);
    std::vector<Vec3d> x = square.x;
    for (Vec3d& p : x) p *= 1.02;
    judge.sample(x);
    EXPECT_NEAR(judge.quality().p99_stretch, 0.01, 1e-12);
    EXPECT_NEAR(judge.quality().max_stretch, 0.02, 1e-12);
    EXPECT_NEAR(judge.quality().area_error, (1.02 * 1.02 - 1) / 2, 1e-12);
    EXPECT_NEAR(judge.quality().min_gap, 0.006, 1e-9);
    x[60] = Vec3d(0, 0.24, 0);
    judge.sample(x);
    EXPECT_NEAR(judge.quality().min_gap, -0.01, 1e-9);
}

TEST(DropHonesty, a_weightless_cloth_at_rest_keeps_no_energy) {
    SphereDropOptions options = coarse(8);
    options.scene.frames = 30;
    SphereDrop drop = run_sphere_drop(options);
    const double kinetic = energy(drop.run).kinetic;
    ASSERT_GT(kinetic, 0);
    const EnergyStatistics statistics = weightless(drop.run, options.scene, 1);
    EXPECT_LT(statistics.energy_growth, 0.01);
    EXPECT_GT(statistics.kinetic_end, 0);
    EXPECT_LT(statistics.kinetic_end, kinetic);
}

TEST(DropHonesty, the_same_run_lies_no_distance_from_itself) {
    SphereDropOptions options = coarse(8);
    options.scene.frames = 30;
    const SphereDrop drop = run_sphere_drop(options);
    const ConvergenceStatistics figures = compare_converged(drop, options, options.substeps);
    EXPECT_EQ(figures.distance.rms, 0);
    EXPECT_GE(figures.noise_floor.mean, 0.0003);  // the pinned vertex and its neighbourhood start shifted by 1 mm
}

}  // namespace

// The complete drop experiment on a grid of 72 triangles, and its JSON.

namespace {

DropExperiment coarse_experiment() {
    DropExperiment experiment;
    experiment.triangles = 72;
    experiment.max_substeps = 16;
    experiment.repetitions = 1;
    experiment.scene.level = 1;
    experiment.gates = {.max_stretch = 0.2, .max_area_error = 0.5, .max_bias_error = 5};
    return experiment;
}

TEST(DropReport, has_every_figure_that_was_promised) {
    DropExperiment experiment = coarse_experiment();
    experiment.scene.frames = 30;
    experiment.substeps = 4;
    const sim::Json json = to_json(measure_drop(experiment));
    for (const char* key :
         {"us_per_triangle_frame", "ms_per_frame", "ms_with_samples", "p99_stretch", "max_stretch", "area_error",
          "substeps", "p1_compression", "bias_stiffness_ratio", "rest_kinetic_energy_j", "rest_rms_speed",
          "weightless_energy_growth", "distance_mean_m", "distance_rms_m", "noise_floor_mean_m", "noise_floor_rms_m"}) {
        ASSERT_NE(json.find(key), nullptr) << key;
        EXPECT_TRUE(json.find(key)->is_number()) << key;
    }
    EXPECT_EQ(json.find("substeps")->number(), 4);
    EXPECT_EQ(json.find("trials")->elements().size(), 1U);
}

TEST(DropReport, takes_the_least_substeps_that_pass_and_keeps_all_that_were_tried) {
    DropExperiment experiment = coarse_experiment();
    experiment.passes_quality_checks = false;
    const DropReport report = measure_drop(experiment);
    ASSERT_TRUE(report.chosen.passes());
    for (std::size_t i = 1; i < report.trials.size(); ++i)
        EXPECT_LT(report.trials[i - 1].substeps, report.trials[i].substeps);
    for (const DropTrial& trial : report.trials) {
        const bool is_less = trial.substeps < report.chosen.substeps;
        EXPECT_FALSE(is_less && trial.passes()) << trial.substeps;
    }
    EXPECT_EQ(to_json(report).find("rest_rms_speed"), nullptr);
    EXPECT_EQ(report.triangles, 72);
}

TEST(DropReport, says_which_gates_the_last_setting_missed_when_none_meets_them) {
    DropExperiment experiment = coarse_experiment();
    experiment.passes_quality_checks = false;
    experiment.max_substeps = 2;
    experiment.gates.max_stretch = 1e-9;
    const DropReport report = measure_drop(experiment);
    EXPECT_FALSE(report.chosen.passes());
    EXPECT_EQ(report.chosen.missed, std::vector<std::string>{"stretch"});
    EXPECT_FALSE(to_json(report).find("meets_gates")->boolean());
    EXPECT_NE(to_markdown(tables_of(report)[0]).find("missed: stretch"), std::string::npos);
}

}  // namespace

// The search for the smallest number of sub-steps that passes.

namespace {

struct LeastSearch {
    std::optional<int> found;
    std::vector<int> asked;
};

LeastSearch search_for(int least, int most) {
    LeastSearch search;
    search.found = find_least(most, [&](int n) {
        search.asked.push_back(n);
        return n >= least;
    });
    return search;
}

TEST(FindLeast, finds_every_least_number_and_asks_none_twice) {
    for (int least = 1; least <= 64; ++least) {
        LeastSearch search = search_for(least, 64);
        EXPECT_EQ(search.found, least);
        std::ranges::sort(search.asked);
        EXPECT_EQ(std::ranges::adjacent_find(search.asked), search.asked.end()) << least;
        EXPECT_LE(search.asked.size(), 12U);
    }
}

TEST(FindLeast, gives_up_where_it_should) {
    const LeastSearch search = search_for(101, 100);
    EXPECT_FALSE(search.found);
    EXPECT_EQ(*std::ranges::max_element(search.asked), 100);
}

TEST(FindLeast, reaches_its_most_also_when_that_is_no_power_of_two) {
    EXPECT_EQ(search_for(100, 100).found, 100);
    EXPECT_EQ(search_for(1, 1).found, 1);
}

}  // namespace

// Stiffness on the bias: the theory, and a simulated strip.

namespace {

TEST(BiasTheory, approaches_four_times_the_shear_stiffness_where_threads_hardly_stretch) {
    sim::Fabric fabric = drop_fabric();
    EXPECT_NEAR(bias_stiffness(fabric), 220.9, 0.1);
    fabric.stretch_warp = fabric.stretch_weft = 1e9;
    EXPECT_NEAR(bias_stiffness(fabric), 4 * fabric.shear, 1e-4);
}

TEST(BiasTheory, agrees_with_the_small_strain_formula_at_small_strains_and_is_stiffer_beyond) {
    const sim::Fabric fabric = drop_fabric();
    EXPECT_NEAR(bias_strain(fabric, 1e-3) * bias_stiffness(fabric) / 1e-3, 1, 1e-4);
    const double force = 0.05 * bias_stiffness(fabric);
    EXPECT_LT(bias_strain(fabric, force), 0.05);
    EXPECT_GT(bias_strain(fabric, force), 0.045);
}

TEST(BiasStrip, comes_to_rest_at_a_strain_of_the_right_size) {
    const BiasStrip strip = measure_bias(drop_fabric(), {.element = 1.0 / 6, .level = 1, .substeps = 16});
    EXPECT_TRUE(strip.is_at_rest);
    EXPECT_GT(strip.stiffness_ratio, 0.5);
    EXPECT_LT(strip.stiffness_ratio, 1.5);
}

TEST(BiasStrip, a_fabric_of_half_the_shear_stiffness_gives_the_same_ratio) {
    sim::Fabric soft = drop_fabric();
    soft.shear /= 2;
    const BiasStripOptions options{.element = 1.0 / 6, .level = 1, .substeps = 32};
    EXPECT_NEAR(measure_bias(soft, options).stiffness_ratio, measure_bias(drop_fabric(), options).stiffness_ratio,
                0.15);
}

}  // namespace

}  // namespace selvedge::bench
