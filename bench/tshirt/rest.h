#pragma once
// What a garment costs that has come to rest, against the same while its hem is pulled about: two copies side by side,
// of which one may rest (sim/cloth/resting.h).
#include <filesystem>

#include "bench/support/table.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

struct RestExperiment {
    std::filesystem::path pattern;
    int pulled_frames = 120;  // of 1/30 s
    int rest_frames = 60;
    int most_frames = 900;  // for it to come to rest
};

struct RestRow {
    double ms_always = 0;  // per frame, median: of the copy that is always stepped
    double ms_resting = 0;
};

struct RestReport {
    int leaf_triangles = 0;
    RestRow pulled;
    RestRow at_rest;
    int frames_to_rest = 0;  // from when the hand stood still
    bool has_rested = false;
};

RestReport measure_rest(const RestExperiment& experiment, const sim::Progress& progress = {});

Table table_of(const RestReport& report);

}  // namespace selvedge::bench
