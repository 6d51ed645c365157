#pragma once
// Compares the cost of contact queries against a dense body on the same moving points: the collision grid of the thesis
// (4.4.1), a bounding volume hierarchy (BVH) and the distance field, the last with and without its SIMD kernels and
// with and without cached slack distances (see ContactWay).
#include <cstddef>
#include <vector>

#include "bench/collide/contact_pass.h"
#include "bench/support/table.h"
#include "sim/body/body.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

struct CollideOptions {
    std::vector<std::size_t> triangles{27000, 107000, 428000};  // of the body, each at least 17,184
    ClothPointOptions points{};
    int rounds = 7;  // repetitions; times are medians over them
};

// Two tables, with one row for each structure and body: the cost and errors of queries, and the cost of building.
std::vector<Table> bench_collide(const CollideOptions& options, const sim::Progress& progress = {});

// The standing mannequin with `triangles` triangles, or one fewer: its longest edges are split until it has that many.
// The surface stays closed, and new vertices follow its curvature. No bones. Pre: triangles >= 17,184, the count of the
// coarsest mannequin.
sim::Body dense_body(std::size_t triangles);

}  // namespace selvedge::bench
