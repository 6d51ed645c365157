#include "bench/tshirt/rest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bench/support/cloth_run.h"
#include "bench/tshirt/dressing.h"
#include "sim/cloth/resting.h"
#include "sim/core/math.h"
#include "sim/dress/drape.h"
#include "sim/dress/dressing.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::bench {
namespace {

sim::VertexId lowest_vertex(const sim::Cloth& cloth) {
    const std::span<const sim::VertexId> all = cloth.mesh.leaf_vertices();
    return *std::ranges::min_element(all, {}, [&](sim::VertexId v) { return cloth.x[v.value].y(); });
}

// A garment that hangs on a body and is dragged at one vertex. The drape has no time limit and never ends.
class HeldGarment {
 public:
    HeldGarment(const sim::Cloth& cloth, const sim::Collider& body, sim::VertexId hand, bool may_rest)
        : simulation_(cloth), body_(body), led_{.vertex = hand.value}, run_(simulation_, options(may_rest)) {
        simulation_.keep({&hand, 1});
        simulation_.lead([this](const sim::Cloth& of, float seconds) { return kinematic_vertices(of, seconds); });
    }
    HeldGarment(const HeldGarment&) = delete;
    HeldGarment& operator=(const HeldGarment&) = delete;

    // Runs one frame in which the dragged vertex moves towards `to`. Returns the CPU time, s.
    double advance(const Vec3f& to) {
        goal_ = to;
        const double start = thread_seconds();
        run_.advance(simulation_, body_);
        run_.clear_times();
        return thread_seconds() - start;
    }
    const sim::Cloth& cloth() const { return simulation_.cloth(); }

 private:
    static sim::DrapeOptions options(bool may_rest) {
        return {.max_seconds = std::numeric_limits<double>::infinity(),
                .rest_time = std::numeric_limits<double>::infinity(),
                .relax_time = 0,
                .may_rest = may_rest};
    }

    std::span<const sim::KinematicVertex> kinematic_vertices(const sim::Cloth& cloth, float seconds) {
        constexpr float kApproach = 12;  // 1/s, as in sim/dress/drag_constraint.cpp
        const Vec3f x = cloth.x[led_.vertex].head<3>();
        led_.to = x + (goal_ - x) * (kApproach * seconds);
        return {&led_, 1};
    }

    sim::Simulation simulation_;
    const sim::Collider& body_;
    sim::KinematicVertex led_;
    Vec3f goal_ = Vec3f::Zero();
    sim::DrapeRun run_;
};

struct Times {
    std::vector<double> always, resting;  // s

    RestRow medians() const { return {1e3 * sim::quantile(always, 0.5), 1e3 * sim::quantile(resting, 0.5)}; }
};

// A circle of radius 2 cm, once in 60 frames (2 s), about a point 3 cm above and 5 cm in front of the start.
Vec3f pulled_to(const Vec3f& start, int frame) {
    const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(frame) / 60;
    return start + Vec3f(0.02F * std::sin(turn), 0.03F + 0.02F * std::cos(turn), 0.05F);
}

}  // namespace

RestReport measure_rest(const RestExperiment& experiment, const sim::Progress& progress) {
    const sim::Pattern pattern = sim::load_pattern(experiment.pattern).pattern;
    const sim::Body body = placed_for(pattern);
    const sim::BodyCollider collider(body);
    sim::Cloth dressed = dress_cloth(pattern, body, {}, progress).cloth;
    const sim::VertexId hand = lowest_vertex(dressed);
    const Vec3f start = dressed.x[hand.value].head<3>();
    dressed.is_pinned[hand.value] = true;
    refresh_solver(dressed);

    HeldGarment always(dressed, collider, hand, false);
    HeldGarment resting(dressed, collider, hand, true);
    const auto advance = [&](int frame, Times& times) {
        const Vec3f to = pulled_to(start, std::min(frame, experiment.pulled_frames));
        times.always.push_back(always.advance(to));
        times.resting.push_back(resting.advance(to));
    };
    int frame = 0;
    Times pulled, coming, at_rest;
    while (frame < experiment.pulled_frames) advance(frame++, pulled);
    while (frame < experiment.max_frames && !is_at_rest(resting.cloth())) advance(frame++, coming);
    RestReport report;
    report.leaf_triangles = static_cast<int>(resting.cloth().mesh.leaf_triangles().size());
    report.pulled = pulled.medians();
    report.frames_to_rest = static_cast<int>(coming.always.size());
    report.has_rested = is_at_rest(resting.cloth());
    for (int i = 0; i < experiment.rest_frames; ++i) advance(frame++, at_rest);
    report.at_rest = at_rest.medians();
    return report;
}

Table table_of(const RestReport& report) {
    Table table{.name = "rest",
                .title = "A frame of 1/30 s (one adaptation, four steps) of a garment of " +
                         std::to_string(report.leaf_triangles) + " leaf triangles, by processor time",
                .note = "Pulled about at its hem, then held still: it came to rest after " +
                        std::to_string(report.frames_to_rest) +
                        " frames. Two copies side by side; share: of the same copy pulled."};
    if (!report.has_rested) table.note = "Pulled about at its hem, then held still: it did not come to rest.";
    table.columns = {"copy", "pulled, ms", "at rest, ms", "share, %"};
    const auto add = [&](const char* name, double RestRow::*ms) {
        const double pulled = report.pulled.*ms, at_rest = report.at_rest.*ms;
        table.add_row({name, Cell(pulled, 3), Cell(at_rest, 3), Cell(100 * at_rest / pulled, 2)});
    };
    add("always stepped", &RestRow::ms_always);
    add("may rest", &RestRow::ms_resting);
    return table;
}

}  // namespace selvedge::bench
