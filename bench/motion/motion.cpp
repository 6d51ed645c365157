#include "bench/motion/motion.h"

#include <algorithm>
#include <cmath>

#include "bench/support/cloth_run.h"
#include "bench/tshirt/dressing.h"
#include "bench/tshirt/tshirt.h"
#include "sim/body/tented.h"
#include "sim/body/yielding_flesh.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/standoff.h"
#include "sim/collide/body_collider.h"
#include "sim/dress/dressing_pose.h"
#include "sim/dress/motion_run.h"
#include "sim/session/animation.h"
#include "sim/session/live_motion.h"
#include "sim/session/session.h"

namespace selvedge::bench {
namespace {

constexpr double kFrame = 1.0 / 60;  // s

sim::SimulationOptions options_of(const MotionExperiment& experiment, float shortest_edge) {
    return sim::simulation_options(
        {.shortest_edge = static_cast<double>(shortest_edge), .self_collision = experiment.self_contact});
}

// Median CPU time of a frame on the body at rest, with the steps and adaptations of MotionRun. Gravity leans by 5
// degrees and goes round, so that the cloth does not rest.
double rest_ms(sim::Cloth cloth, const sim::Collider& body, sim::SimulationOptions common,
               const sim::MotionOptions& options) {
    constexpr int kFrames = 60;
    const auto steps = static_cast<int>(std::lround(2 * kFrame / options.step_seconds));
    sim::forget_contacts(cloth);
    set_substep(cloth, static_cast<float>(options.step_seconds / options.substeps));
    sim::Simulation simulation(std::move(cloth), common);
    sim::Schedule schedule = sim::moving(options.air_damping);
    schedule.substeps = options.substeps;
    std::vector<double> ms;
    for (int frame = 0; frame < kFrames; frame += 2) {
        const double seconds = time_once([&] {
            simulation.adapt(body, schedule);
            update_standoffs(simulation.cloth(), body, {.free = options.free_standoff});
            for (int i = 0; i < steps; ++i) {
                common.gravity = leaning_gravity(frame * kFrame + i * options.step_seconds);
                simulation.set_options(common);
                simulation.step(body, schedule);
            }
        });
        ms.push_back(seconds * 1e3 / 2);
    }
    return timing_of(ms).median;
}

}  // namespace

MotionStatistics measure_motion(const MotionExperiment& experiment, const sim::Progress& progress) {
    const auto met = std::make_shared<const sim::Body>(sim::tented(*experiment.body));
    const sim::Body& body = *met;
    sim::BodyTimeline timeline(met, sim::dressing_pose(body), experiment.clip,
                               {.from = experiment.from, .seconds = experiment.seconds, .speed = experiment.speed});
    const sim::Body start = posed(body, timeline.pose(0));
    const DressedCloth dressed =
        dress_cloth(experiment.pattern, start, {.min_leaves = experiment.min_leaves}, progress);
    const sim::SimulationOptions common = options_of(experiment, dressed.shortest_edge);
    const sim::MotionOptions options{.substeps = experiment.substeps};
    MotionStatistics statistics;
    {
        const sim::BodyCollider at_rest(start);
        statistics.rest_ms = rest_ms(dressed.cloth, at_rest, common, options);
    }
    sim::Simulation simulation(dressed.cloth, common);
    const sim::Cloth& cloth = simulation.cloth();
    double body_seconds = 0;
    const auto body_at = [&](double seconds, const sim::Region& region, std::vector<Vec3f>& x) {
        body_seconds += time_once([&] { timeline.positions(seconds, region, x); });
    };
    sim::MotionRun run(simulation, start, body_at, options);
    const double blend = timeline.seconds() - experiment.seconds;
    run.advance_to(simulation, blend);
    std::vector<double> motion_ms, body_ms, leaves;
    const int frames = static_cast<int>(std::lround(experiment.seconds / kFrame));
    for (int frame = 1; frame <= frames; ++frame) {
        body_seconds = 0;
        motion_ms.push_back(1e3 * time_once([&] { run.advance_to(simulation, blend + frame * kFrame); }));
        body_ms.push_back(1e3 * body_seconds);
        leaves.push_back(static_cast<double>(cloth.mesh.leaf_triangles().size()));
        statistics.quality.note(cloth, run.collider(), kFrame);
        if (statistics.quality.has_bad_number) break;
        sim::report(progress, "moving", static_cast<double>(frame) / frames);
    }
    statistics.motion_ms = timing_of(motion_ms).median;
    statistics.p95_ms = sim::quantile(motion_ms, 0.95);
    statistics.body_ms = timing_of(body_ms).median;
    statistics.leaves = timing_of(leaves).median;
    return statistics;
}

LiveStatistics measure_live(const MotionExperiment& experiment, const sim::Progress& progress) {
    constexpr int kMostFrames = 900;  // until it hangs, and until the body is in the motion
    sim::Session session(sim::SessionDrive::Caller);
    sim::SessionOptions options;
    options.keeps_real_time = false;
    options.self_collision = experiment.self_contact;
    session.set_options(options);
    session.set_body(experiment.body);
    session.set_pattern(experiment.pattern);
    session.set_clip(experiment.body, std::make_shared<const sim::Clip>(experiment.clip));
    session.set_playback({.speed = experiment.speed});
    session.start();
    const auto advance_until = [&](const auto& is_done) {
        for (int i = 0; i < kMostFrames && !is_done(*session.frame()); ++i) session.advance(1);
    };
    advance_until([](const sim::SessionFrame& frame) { return frame.stage == sim::SessionStage::Settled; });
    session.play();
    session.advance(1);
    advance_until([](const sim::SessionFrame& frame) { return !frame.motion.is_blending; });
    std::vector<double> ms, leaves;
    const int frames = static_cast<int>(std::lround(experiment.seconds / sim::kLiveFrameSeconds));
    for (int frame = 1; frame <= frames; ++frame) {
        ms.push_back(1e3 * time_once([&] { session.advance(1); }));
        leaves.push_back(static_cast<double>(session.frame()->statistics.leaf_triangles));
        sim::report(progress, "moving live", static_cast<double>(frame) / frames);
    }
    return {.ms = sim::quantile(ms, 0.5),
            .p95_ms = sim::quantile(ms, 0.95),
            .max_ms = sim::quantile(ms, 1),
            .leaves = sim::quantile(leaves, 0.5)};
}

Table table_of(const LiveStatistics& s) {
    Table table{.name = "live", .title = "A frame of 1/30 s of the same in the editor's session, CPU time"};
    table.columns = {"leaves", "median, ms", "p95, ms", "largest, ms", "of real time, %"};
    table.add_row({Cell(s.leaves, 0), Cell(s.ms, 2), Cell(s.p95_ms, 2), Cell(s.max_ms, 2),
                   Cell(100 * s.ms / (1e3 * sim::kLiveFrameSeconds), 0)});
    return table;
}

Table table_of(const MotionStatistics& s) {
    Table table{.name = "motion", .title = "A frame of 1/60 s of a garment on a moving body, CPU time"};
    table.columns = {
        "leaves",         "at rest, ms", "moving, ms",   "of it body, ms",     "p95, ms",          "ratio",
        "p99 stretch, %", "largest, %",  "over 15 %, s", "deepest vertex, mm", "deepest face, mm", "vertices > 1 mm",
        "faces > 1 mm",   "pinched"};
    const sim::MotionQuality& q = s.quality;
    table.add_row({Cell(s.leaves, 0), Cell(s.rest_ms, 2), Cell(s.motion_ms, 2), Cell(s.body_ms, 2), Cell(s.p95_ms, 2),
                   Cell(s.motion_ms / s.rest_ms, 2), Cell(100 * q.p99_stretch, 1), Cell(100 * q.max_stretch, 1),
                   Cell(q.overstretched_seconds, 2), Cell(1e3 * q.deepest_vertex, 2), Cell(1e3 * q.deepest_face, 2),
                   Cell(q.deep_vertices), Cell(q.deep_faces), Cell(q.pinched)});
    return table;
}

}  // namespace selvedge::bench
