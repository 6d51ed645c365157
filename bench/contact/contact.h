#pragma once
// Contact of cloth with itself: runs each scene with and without it, and compares crossings, order and cost.
#include <filesystem>
#include <vector>

#include "bench/contact/scenes.h"
#include "bench/support/table.h"
#include "sim/core/parallel.h"
#include "sim/selfcontact/self_contact.h"

namespace selvedge::bench {

struct ContactRun {
    int triangles = 0;
    int crossings_at_start = 0;  // pairs of triangles without a common vertex that cross each other
    int worst_crossings = 0;     // of the tests, one every ten steps
    int crossings_at_end = 0;
    int wrong_order = 0;  // vertices of a sheet that lie on the wrong side of the sheet below, within 20 mm
    int in_order = 0;
    double ms_per_step = 0;        // processor time
    double ms_at_end = 0;          // the same in the last quarter
    double rms_speed_at_end = 0;   // m/s, of the last step
    double rms_speed_at_rest = 0;  // m/s, after further steps
    int crossings_at_rest = 0;
    sim::SelfContactCounts counts{};
};

// with: whether the cloth meets itself. further_steps: after those of the scene.
ContactRun run_contact_scene(const ContactScene& scene, bool with, int further_steps = 0);

struct ContactExperiment {
    std::filesystem::path pattern = "patterns/tshirt.json";
    int rest_frames = 120;    // of four steps, after the drape; the second half is measured
    double rest_seconds = 0;  // by which scenes go on with contact, beyond the time that is measured
    std::string only{};       // the one scene to run, or "garments": the garment, once and twice; empty: all
};

// What was sewn, draped with and without contact of the cloth with itself, and then stepped on at rest.
struct GarmentContactRow {
    std::string name;
    int triangles = 0;
    int crossings_with = 0, crossings_without = 0;
    double drape_ms_with = 0, drape_ms_without = 0;  // processor time of the whole drape
    double rest_ms_with = 0, rest_ms_without = 0;    // per frame, median
};

struct ContactBenchReport {
    struct SceneRow {
        std::string name;
        ContactRun with, without;
    };
    std::vector<SceneRow> scenes;
    std::vector<GarmentContactRow> garments;
};

// Throws InputError for an unknown scene, and as load_pattern().
ContactBenchReport measure_contact(const ContactExperiment& experiment, const sim::Progress& progress = {});

std::vector<Table> tables_of(const ContactBenchReport& report);

}  // namespace selvedge::bench
