#include "bench/contact/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bench/support/cloth_run.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/contact_surface.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/error.h"
#include "sim/dress/dressing.h"
#include "sim/pattern/garments.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::bench {
namespace {

// The fabric of all sheets: a cotton of 1 mm, so that thickness is easy to see.
sim::Fabric sheet_fabric() {
    return {.name = "sheet",
            .area_density = 0.18,
            .stretch_warp = 8000,
            .stretch_weft = 8000,
            .shear = 56,
            .bending_warp = 1e-5,
            .bending_weft = 1e-5,
            .thickness = 0.001,
            .friction = 0.3,
            .damping = 0.6};
}

int crossings_of(const sim::Cloth& cloth) {
    const sim::ContactSurface surface = contact_surface(cloth);
    return static_cast<int>(find_crossing_triangles(surface, cloth.x.front().data()).size());
}

// Where a point is nearest to a triangle, if its foot is inside: the signed distance, m.
std::optional<float> height_above(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3f normal = (b - a).cross(c - a).normalized();
    const float height = normal.dot(p - a);
    const Vec3f foot = p - normal * height;
    const auto is_left = [&](const Vec3f& from, const Vec3f& to) {
        return (to - from).cross(foot - from).dot(normal) >= 0;
    };
    if (!is_left(a, b) || !is_left(b, c) || !is_left(c, a)) return std::nullopt;
    return height;
}

// Counts the vertices of the sheet above `lower` by the side of its nearest triangle.
void count_order(const sim::Cloth& cloth, int lower, ContactRun& run) {
    constexpr float kNear = 0.02F;  // m
    std::vector<bool> is_upper(cloth.x.size(), false);
    std::vector<std::array<Vec3f, 3>> below;
    for (const sim::LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        const auto at = [&](std::size_t k) -> Vec3f { return cloth.x[leaf.v[k].value].head<3>(); };
        if (leaf.panel == lower) below.push_back({at(0), at(1), at(2)});
        if (leaf.panel != lower + 1) continue;
        for (const sim::VertexId v : leaf.v) is_upper[v.value] = true;
    }
    for (std::size_t v = 0; v < cloth.x.size(); ++v) {
        if (!is_upper[v]) continue;
        float nearest = kNear;
        for (const auto& [a, b, c] : below) {
            const std::optional<float> height = height_above(cloth.x[v].head<3>(), a, b, c);
            if (height && std::abs(*height) < std::abs(nearest)) nearest = *height;
        }
        if (nearest < 0) ++run.wrong_order;
        if (nearest >= 0 && nearest < kNear) ++run.in_order;
    }
}

sim::Cloth start_of(const ContactScene& scene) {
    const std::vector<sim::Fabric> fabrics(static_cast<std::size_t>(scene.mesh.panel_names.size()), sheet_fabric());
    sim::Cloth cloth = make_cloth(scene.mesh, fabrics, {.max_level = scene.is_adaptive ? 3 : 0});
    for (int i = 0; i < scene.sheets; ++i) cloth.material.layers.push_back(i);
    for (const sim::LeafTriangle& leaf : cloth.mesh.leaf_triangles()) {
        if (leaf.panel + 1 != scene.sheets) continue;
        for (const sim::VertexId v : leaf.v) {
            cloth.x_prev[v.value] =
                cloth.x[v.value] -
                sim::with_zero_w(scene.last_velocity * (cloth.inverse_mass[v.value] > 0 ? cloth.substep : 0));
        }
    }
    return cloth;
}

// A scene in progress.
class SceneRun {
 public:
    SceneRun(const ContactScene& scene, bool with) : scene_(scene), with_(with), cloth_(start_of(scene)) {
        contact_ = {.offset = 0.001F, .floor = scene.floor};
        refresh_contacts(cloth_, contact_);
    }
    const sim::Cloth& cloth() const { return cloth_; }
    float rms_speed() const { return rms_speed_; }  // m/s, of the last step
    // One step. Returns the processor time that it took, s.
    double advance() {
        sim::StepOptions stepping{.gravity = scene_.gravity, .contact = contact_};
        const float time = static_cast<float>(steps_) * step_seconds(cloth_, stepping);
        stepping.extra_damping = scene_.damping + 4 * time;  // as a drape, so that it comes to rest
        if (with_) stepping.self_contact.emplace();
        std::vector<sim::KinematicVertex> kinematic;
        if (scene_.kinematic) kinematic = scene_.kinematic(cloth_, time + step_seconds(cloth_, stepping));
        stepping.kinematic = kinematic;
        double start = thread_seconds(), taken = 0;
        if (scene_.is_adaptive && steps_ % 4 == 0) {
            adapt_cloth(cloth_, *scene_.body, {.shortest_edge = 0.012F}, contact_);
            taken = thread_seconds() - start;
        }
        const std::vector<Vec4f> before = cloth_.x;  // of the mesh that the step moves
        start = thread_seconds();
        step(cloth_, *scene_.body, stepping);
        ++steps_;
        taken += thread_seconds() - start;
        rms_speed_ = sim::rms_speed(cloth_, before, static_cast<double>(step_seconds(cloth_, stepping)));
        return taken;
    }

 private:
    const ContactScene& scene_;
    bool with_;
    sim::Cloth cloth_;
    sim::ContactOptions contact_;
    int steps_ = 0;
    float rms_speed_ = 0;
};

}  // namespace

ContactRun run_contact_scene(const ContactScene& scene, bool with, int further_steps) {
    ContactRun run;
    SceneRun running(scene, with);
    const sim::Cloth& cloth = running.cloth();
    run.crossings_at_start = crossings_of(cloth);
    double seconds = 0, seconds_at_end = 0;
    const int last_quarter = scene.steps - scene.steps / 4;
    for (int i = 0; i < scene.steps; ++i) {
        const double taken = running.advance();
        seconds += taken;
        if (i >= last_quarter) seconds_at_end += taken;
        if (i % 10 == 9 || i + 1 == scene.steps) {
            run.crossings_at_end = crossings_of(cloth);
            run.worst_crossings = std::max(run.worst_crossings, run.crossings_at_end);
        }
    }
    run.rms_speed_at_end = static_cast<double>(running.rms_speed());
    run.triangles = static_cast<int>(cloth.mesh.leaf_triangles().size());
    run.counts = cloth.solver->self_contact->contact.counts();
    run.ms_per_step = 1e3 * seconds / scene.steps;
    run.ms_at_end = 1e3 * seconds_at_end / (scene.steps - last_quarter);
    for (int i = 0; i + 1 < scene.sheets; ++i) count_order(cloth, i, run);
    for (int i = 0; i < further_steps; ++i) running.advance();
    run.rms_speed_at_rest = static_cast<double>(running.rms_speed());
    run.crossings_at_rest = crossings_of(cloth);
    return run;
}

namespace {

struct GarmentTimes {
    double drape = 0, rest = 0;  // ms: in all; per frame
    int crossings = 0, triangles = 0;
};

// Drapes what has just been sewn, and goes on with it at rest.
GarmentTimes run_garment(sim::Dressing& sewn, bool with, int rest_frames) {
    sim::Dressing::Drape drape = sewn.drape();
    sim::SimulationOptions common = drape.simulation.options();
    if (!with) common.self_contact.reset();
    drape.simulation.set_options(common);
    GarmentTimes times;
    const double start = thread_seconds();
    while (drape.run->advance(drape.simulation, sewn.collider())) {
    }
    times.drape = 1e3 * (thread_seconds() - start);
    times.crossings = crossings_of(drape.simulation.cloth());
    times.triangles = static_cast<int>(drape.simulation.cloth().mesh.leaf_triangles().size());
    const sim::DrapeOptions hanging{.max_seconds = std::numeric_limits<double>::infinity(),
                                    .rest_time = std::numeric_limits<double>::infinity(),
                                    .relax_time = 0};
    sim::DrapeRun run(drape.simulation, hanging);
    std::vector<double> frames;
    for (int i = 0; i < rest_frames; ++i) {
        const double frame_start = thread_seconds();
        run.advance(drape.simulation, sewn.collider());
        frames.push_back(1e3 * (thread_seconds() - frame_start));
    }
    frames.erase(frames.begin(), frames.begin() + rest_frames / 2);  // until then the mesh still adapts
    times.rest = sim::quantile(frames, 0.5);
    return times;
}

GarmentContactRow measure_garment(const std::string& name, const sim::Pattern& pattern,
                                  const std::shared_ptr<const sim::Body>& body, int rest_frames) {
    sim::Dressing sewn;
    sewn.set_body(body);
    sewn.set_pattern(pattern);
    while (!sewn.is_hanging()) sewn.advance();
    const GarmentTimes with = run_garment(sewn, true, rest_frames);
    const GarmentTimes without = run_garment(sewn, false, rest_frames);
    return {.name = name,
            .triangles = with.triangles,
            .crossings_with = with.crossings,
            .crossings_without = without.crossings,
            .drape_ms_with = with.drape,
            .drape_ms_without = without.drape,
            .rest_ms_with = with.rest,
            .rest_ms_without = without.rest};
}

constexpr const char* kGarments = "garments";  // as the name of a scene

std::string names_of(const std::vector<ContactScene>& scenes) {
    std::string names;
    for (const ContactScene& scene : scenes) names += scene.name + "; ";
    return names + kGarments;
}

}  // namespace

ContactBenchReport measure_contact(const ContactExperiment& experiment, const sim::Progress& progress) {
    ContactBenchReport report;
    const std::vector<ContactScene> scenes = all_contact_scenes();
    const double parts = static_cast<double>(scenes.size()) + 2;  // and two garments
    for (const ContactScene& scene : scenes) {
        if (!experiment.only.empty() && experiment.only != scene.name) continue;
        sim::report(progress, scene.name, static_cast<double>(report.scenes.size()) / parts);
        const int further = static_cast<int>(std::lround(120 * experiment.rest_seconds));
        report.scenes.push_back({scene.name, run_contact_scene(scene, true, further), run_contact_scene(scene, false)});
    }
    if (!experiment.only.empty() && experiment.only != kGarments) {
        if (report.scenes.empty())
            throw sim::InputError("--scene " + experiment.only, "", "is not one of: " + names_of(scenes));
        return report;
    }
    const sim::Pattern pattern = sim::load_pattern(experiment.pattern).pattern;
    sim::Pattern twice = pattern;
    put_over(twice, pattern);
    const auto body = std::make_shared<const sim::Body>(placed_for(pattern));
    sim::report(progress, pattern.name, static_cast<double>(scenes.size()) / parts);
    report.garments.push_back(measure_garment(pattern.name, pattern, body, experiment.rest_frames));
    sim::report(progress, pattern.name, static_cast<double>(scenes.size() + 1) / parts);
    report.garments.push_back(measure_garment(pattern.name + ", two of them", twice, body, experiment.rest_frames));
    return report;
}

std::vector<Table> tables_of(const ContactBenchReport& report) {
    Table scenes{.name = "contact",
                 .title = "Cloth against itself: scenes of sheets, by processor time of one thread",
                 .note =
                     "Crossings: pairs of triangles without a common vertex, by an exact test of all pairs. Cost: of "
                     "self-contact, as a share of the same scene without it, over the whole run and in its last "
                     "quarter. Wrong: vertices of a sheet on the wrong side of the sheet below."};
    scenes.columns = {"scene", "triangles", "crossings at start", "worst", "at end",      "without: at end",
                      "wrong", "right",     "ms per step",        "cost",  "cost at end", "rms at end, mm/s"};
    for (const ContactBenchReport::SceneRow& row : report.scenes) {
        const ContactRun &with = row.with, &without = row.without;
        scenes.add_row({row.name, with.triangles, with.crossings_at_start, with.worst_crossings, with.crossings_at_end,
                        without.crossings_at_end, with.wrong_order, with.in_order, Cell(with.ms_per_step, 2),
                        Cell(with.ms_per_step / without.ms_per_step - 1, 2),
                        Cell(with.ms_at_end / without.ms_at_end - 1, 2), Cell(1e3 * with.rms_speed_at_end, 1)});
    }
    Table rest{.name = "rest",
               .title = "Cloth against itself: the scenes later",
               .note = "After the further time that was asked for; 0: at the end of the scenes."};
    rest.columns = {"scene", "crossings", "rms, mm/s"};
    for (const ContactBenchReport::SceneRow& row : report.scenes)
        rest.add_row({row.name, row.with.crossings_at_rest, Cell(1e3 * row.with.rms_speed_at_rest, 1)});
    Table garments{
        .name = "garments",
        .title = "Cloth against itself: garments, by processor time of one thread",
        .note = "The whole drape after sewing, and a frame (one adaptation, four steps) after one second at rest."};
    garments.columns = {"garment", "triangles", "crossings", "without", "drape, ms", "cost", "at rest, ms", "cost"};
    for (const GarmentContactRow& row : report.garments) {
        garments.add_row({row.name, row.triangles, row.crossings_with, row.crossings_without,
                          Cell(row.drape_ms_with, 0), Cell(row.drape_ms_with / row.drape_ms_without - 1, 2),
                          Cell(row.rest_ms_with, 2), Cell(row.rest_ms_with / row.rest_ms_without - 1, 2)});
    }
    Table counts{.name = "counts",
                 .title = "What self-contact did in these scenes",
                 .note =
                     "Per step of 12 sub-steps. Asked: share of the cloth that was asked, summed over all detections; "
                     "candidates per detection, contacts per refresh."};
    counts.columns = {"scene",      "detections", "local", "asked",  "tests",     "local tests", "triangle pairs",
                      "candidates", "contacts",   "acted", "parted", "truncated", "iterations"};
    for (const ContactBenchReport::SceneRow& row : report.scenes) {
        const sim::SelfContactCounts& c = row.with.counts;
        const auto per = [](long count, long of) {
            return static_cast<double>(count) / static_cast<double>(std::max(1L, of));
        };
        const long detections = c.detections + c.local_detections;
        counts.add_row({row.name, Cell(per(c.detections, c.steps), 2), Cell(per(c.local_detections, c.steps), 2),
                        Cell(c.asked / static_cast<double>(std::max(1L, c.steps)), 2),
                        Cell(per(c.exact_tests, c.steps), 2), Cell(per(c.local_tests, c.steps), 2),
                        Cell(per(c.triangle_pairs, c.steps), 0), Cell(per(c.pairs, detections), 0),
                        Cell(per(c.contacts, c.refreshes), 0), Cell(per(c.acted, c.steps), 0),
                        Cell(per(c.parted, c.steps), 1), Cell(per(c.truncated, c.steps), 1),
                        Cell(per(c.untangling_iterations, c.steps), 1)});
    }
    return {scenes, counts, rest, garments};
}

}  // namespace selvedge::bench
