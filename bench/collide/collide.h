#pragma once
// What it costs to keep cloth out of a dense body: the thesis' collision grid, a tree of boxes, and the distance field,
// with and without its kernels and the test of slack, on the same moving points.  (SPEC 3.3; thesis table 4.1)
#include <cstddef>
#include <vector>

#include "bench/collide/contact_pass.h"
#include "bench/support/table.h"
#include "sim/body/body.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

struct CollideOptions {
    std::vector<std::size_t> triangles{27000, 107000, 428000};  // of the body, each at least 17 184
    ClothPointOptions points{};
    int rounds = 7;  // figures are medians of so many
};

// One table of queries, one row for each structure and body; and one of what building them takes.
std::vector<Table> bench_collide(const CollideOptions& options, const sim::Progress& progress = {});

// The mannequin with as many triangles as an experiment wants.

// The standing mannequin, its longest edges split until it has about so many triangles (two fewer at most): closed, and
// as smooth as it was. Pre: triangles >= 17 184, what its coarsest form has.
sim::Body dense_body(std::size_t triangles);

}  // namespace selvedge::bench
