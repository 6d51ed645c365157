#pragma once
// A dressed garment on a body that moves: the time of a frame against the same garment on the body at rest, and the
// quality of every frame. (thesis tables 5.2 to 5.4)
#include <memory>
#include <vector>

#include "bench/support/table.h"
#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/core/parallel.h"
#include "sim/dress/motion_run.h"
#include "sim/inspection/motion_quality.h"
#include "sim/pattern/pattern.h"

namespace selvedge::bench {

struct MotionExperiment {
    sim::Pattern pattern;
    std::shared_ptr<const sim::Body> body{};  // with a skin
    sim::Clip clip{};                         // of that body
    double from = 0;                          // s of the motion; it is measured from here, after a blend into it
    double seconds = 4;
    double speed = 1;  // of the motion
    int min_leaves = 6000;
    int substeps = sim::MotionOptions{}.substeps;  // per 1/120 s, in motion and at rest
    bool self_contact = true;
};

// CPU times of one frame of 1/60 s, ms: medians over the frames.
struct MotionStatistics {
    double rest_ms = 0;  // on the body at rest
    double motion_ms = 0, body_ms = 0, p95_ms = 0;
    double leaves = 0;
    sim::MotionQuality quality{};
};

// One thread. Throws InputError as dress() does.
MotionStatistics measure_motion(const MotionExperiment& experiment, const sim::Progress& progress = {});
Table table_of(const MotionStatistics& statistics);

// The same garment and motion in the editor's session, with its options: CPU times of one frame of the session, which
// simulates kLiveFrameSeconds, ms. The frame that is shown is part of it.
struct LiveStatistics {
    double ms = 0, p95_ms = 0, max_ms = 0;
    double leaves = 0;
};
LiveStatistics measure_live(const MotionExperiment& experiment, const sim::Progress& progress = {});
Table table_of(const LiveStatistics& statistics);

}  // namespace selvedge::bench
