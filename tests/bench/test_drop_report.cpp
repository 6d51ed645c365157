// The drop experiment as a whole, on a grid of 72 triangles, and its JSON.
#include "bench/drop/report.h"

#include <gtest/gtest.h>

namespace selvedge {
namespace {

DropExperiment coarse_experiment() {
    DropExperiment experiment;
    experiment.triangles = 72;
    experiment.most_substeps = 16;
    experiment.repetitions = 1;
    experiment.scene.level = 1;
    experiment.gates = {.max_stretch = 0.2, .max_area_error = 0.5, .max_bias_error = 5};
    return experiment;
}

TEST(DropReport, has_every_figure_that_was_promised) {
    DropExperiment experiment = coarse_experiment();
    experiment.scene.frames = 30;
    experiment.substeps = 4;
    const Json json = to_json(measure_drop(experiment));
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
    experiment.is_honest = false;
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
    experiment.is_honest = false;
    experiment.most_substeps = 2;
    experiment.gates.max_stretch = 1e-9;
    const DropReport report = measure_drop(experiment);
    EXPECT_FALSE(report.chosen.passes());
    EXPECT_EQ(report.chosen.missed, std::vector<std::string>{"stretch"});
    EXPECT_FALSE(to_json(report).find("meets_gates")->boolean());
    EXPECT_NE(to_markdown(tables_of(report)[0]).find("missed: stretch"), std::string::npos);
}

}  // namespace
}  // namespace selvedge
