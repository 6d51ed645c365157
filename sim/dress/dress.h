#pragma once
// Facade for the batch program, tests and the editor: dresses a body in a pattern, drapes the garment until it is at
// rest, and reports every fault.
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
    std::optional<double> edge_length{};  // m, of the base mesh; overrides the pattern's
    int max_level = 3;
    double shortest_edge = 0.02;  // m, shorter edges are not split, regardless of max_level
    CriteriaOptions criteria{};
    double max_seconds = 12;         // of simulated time, without sewing
    std::optional<Fabric> fabric{};  // overrides the pattern's
};

// The draped garment: its leaf triangles, their refinement hierarchy, and the report.
struct DressedGarment {
    PlainMesh mesh;
    TriangleHierarchy hierarchy;
    DressReport report;
};

// Throws InputError for a pattern that cannot be meshed, or an unknown fabric or body. Later problems are faults in the
// report.
DressedGarment dress(const Pattern& pattern, const Body& body, const DressOptions& options = {},
                     const Progress& progress = {});

// The body that the pattern's panels were placed for: the one it names, or GarmentCode's mean body
// (patterns/FORMAT.md).
Body placed_for(const Pattern& pattern);

// One fabric per panel: the panel's own or else the pattern's. Throws InputError for an unknown fabric.
std::vector<Fabric> fabrics_of(const Pattern& pattern);

}  // namespace selvedge::sim
