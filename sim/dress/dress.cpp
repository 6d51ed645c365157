#include "sim/dress/dress.h"

#include <sys/resource.h>

#include <chrono>

#include "sim/collide/body_collider.h"
#include "sim/core/math.h"
#include "sim/dress/drape.h"
#include "sim/dress/report.h"
#include "sim/dress/session_frame.h"
#include "sim/dress/sewing.h"
#include "sim/mannequin/mannequin.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sew.h"
#include "sim/place/placement.h"

namespace selvedge::sim {
namespace {

// Measures the wall time of each phase of a dressing.
class PhaseTimer {
 public:
    explicit PhaseTimer(DressTiming& timing) : timing_(timing) {}

    void done(const std::string& phase) {
        timing_.wall_s = since(start_);
        timing_.phases_s[phase] = since(phase_start_);
        phase_start_ = Clock::now();
    }

 private:
    using Clock = std::chrono::steady_clock;
    static double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

    DressTiming& timing_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point phase_start_ = start_;
};

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

Pattern anchored(const Pattern& pattern, const Body& body) {
    Pattern moved = pattern;
    anchor_panels(moved, placed_for(pattern), body);
    return moved;
}

// The unsewn garment, clear of the body and at a height at which its seams can close.
GarmentMesh place(const Pattern& pattern, const BodyCollider& collider, const DressOptions& options,
                  DressReport& report) {
    MeshOptions meshing = options.mesh;
    meshing.target_edge = options.edge_length.value_or(pattern.edge_length.value_or(meshing.target_edge));
    GarmentMesh unsewn = assemble(pattern, meshing);
    report.notes = make_sewable(unsewn, collider);
    return unsewn;
}

void record_drape(DressReport& report, const DrapeResult& result) {
    report.settled = result.settled;
    report.stopped_because = result.stopped_because;
    report.simulated_seconds = result.simulated_seconds;
    report.mesh.splits = result.splits;
    report.mesh.rejoins = result.rejoins;
    report.mesh.transitions = result.transitions;
    report.timing.ms_per_adaptation = quantile(result.adaptation_ms, 0.5);
    report.timing.ms_per_step = quantile(result.step_ms, 0.5);
    report.timing.ms_adapt_plus_4_steps = report.timing.ms_per_adaptation + 4 * report.timing.ms_per_step;
}

void record_mesh(DressReport& report, const Pattern& pattern, const GarmentMesh& unsewn, const GarmentMesh& sewn) {
    const MeshReport mesh = report_mesh(pattern, unsewn, sewn);
    report.mesh.base_triangles = mesh.triangles;
    report.mesh.min_angle_deg = mesh.min_angle_deg;
    report.seams.count = static_cast<int>(pattern.seams.size());
    report.seams.worst_length_mismatch = mesh.worst_mismatch ? mesh.worst_mismatch->ratio - 1 : 0;
}

}  // namespace

std::vector<Fabric> fabrics_of(const Pattern& pattern) {
    std::vector<Fabric> fabrics;
    for (const Panel& panel : pattern.panels)
        fabrics.push_back(find_fabric(panel.fabric.empty() ? pattern.fabric : panel.fabric));
    return fabrics;
}

Body placed_for(const Pattern& pattern) {
    if (!pattern.body.empty()) return make_mannequin(parse_mannequin(pattern.body)).body;
    // GarmentCode's mean body, by its published measurements.
    MannequinOptions mean;
    mean.measures.height = pattern.body_height;
    mean.measures.bust = 0.998;
    mean.measures.waist = 0.843;
    mean.measures.hip = 1.035;
    return make_mannequin(mean).body;
}

DressedGarment dress(const Pattern& pattern, const Body& body, const DressOptions& options, const Progress& progress) {
    DressedGarment dressed;
    DressReport& report = dressed.report;
    PhaseTimer timer(report.timing);
    report.garment = pattern.name;
    report.body = body.name;
    const std::vector<Fabric> fabrics =
        options.fabric ? std::vector(pattern.panels.size(), *options.fabric) : fabrics_of(pattern);

    selvedge::sim::report(progress, "reading the body", 0);
    const BodyCollider collider(body);
    timer.done("body");

    const Pattern moved = anchored(pattern, body);
    const GarmentMesh unsewn = place(moved, collider, options, report);
    timer.done("mesh");

    const SewingResult sewing = sew_on_body(unsewn, fabrics, collider, {}, progress);
    record_mesh(report, pattern, unsewn, sewing.sewn);
    timer.done("sewing");

    Cloth cloth = make_cloth(sewing.sewn, fabrics, {.max_level = options.max_level});
    DrapeOptions draping{.max_seconds = options.max_seconds};
    draping.adapt.criteria = options.criteria;
    draping.adapt.shortest_edge = static_cast<float>(options.shortest_edge);
    const DrapeResult draped = drape(cloth, collider, draping, progress);
    record_drape(report, draped);
    timer.done("draping");

    inspect(cloth, collider, moved, sewing, draped, report);
    dressed.mesh = plain_mesh(cloth, sewing.sewn.panel_names);
    dressed.hierarchy = triangle_hierarchy(cloth);
    timer.done("inspection");
    report.timing.peak_memory_mb = peak_memory_mb();
    return dressed;
}

}  // namespace selvedge::sim
