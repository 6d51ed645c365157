#pragma once
// Cost of a garment at rest, compared with the same garment while its hem is dragged. Two copies run side by side; one
// of them is allowed to rest (sim/cloth/resting.h).
#include <filesystem>

#include "bench/support/table.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

struct RestExperiment {
    std::filesystem::path pattern;
    int pulled_frames = 120;  // of 1/30 s
    int rest_frames = 60;
    int max_frames = 900;  // limit, counted from the start, for coming to rest
};

struct RestRow {
    double ms_always = 0;   // per frame, median, of the copy that may not rest
    double ms_resting = 0;  // per frame, median, of the copy that may rest
};

struct RestReport {
    int leaf_triangles = 0;
    RestRow pulled;
    RestRow at_rest;
    int frames_to_rest = 0;  // after the dragged vertex stopped
    bool has_rested = false;
};

RestReport measure_rest(const RestExperiment& experiment, const sim::Progress& progress = {});

Table table_of(const RestReport& report);

}  // namespace selvedge::bench
