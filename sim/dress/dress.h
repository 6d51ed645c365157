#pragma once
// The facade that batch, tests and the editor share: a pattern and a body become a dressed, settled garment and a
// report that names every fault.
#include <optional>

#include "sim/body/body.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/core/parallel.h"
#include "sim/dress/report.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/mesh/sample_outline.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct DressOptions {
    MeshOptions mesh{};
    std::optional<double> edge_length{};  // m, of the base mesh, instead of the pattern's
    int max_level = 3;
    double shortest_edge = 0.02;  // m, an edge shorter than this is not split, whatever max_level says
    CriteriaOptions criteria{};
    double max_seconds = 12;         // of simulated time, sewing not counted
    std::optional<Fabric> fabric{};  // instead of the pattern's
};

// The garment as it hangs: its leaf triangles, and all that they came from.
struct DressedGarment {
    PlainMesh mesh;
    TriangleHierarchy hierarchy;
    DressReport report;
};

// Throws InputError for a pattern that cannot be meshed or names an unknown fabric or body; what goes wrong later is a
// fault in the report.
DressedGarment dress(const Pattern& pattern, const Body& body, const DressOptions& options = {},
                     const Progress& progress = {});

// The body that the pattern's panels were placed for. (SPEC 3.1)
Body placed_for(const Pattern& pattern);

// One per panel: its own or else the pattern's. Throws InputError for a fabric that is not known.
std::vector<Fabric> fabrics_of(const Pattern& pattern);

}  // namespace selvedge::sim
