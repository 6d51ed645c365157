#pragma once
// What a garment mesh measures.  (SPEC 3.1)
#include <optional>
#include <string>

#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// The seam whose sides differ most in length.
struct SeamMismatch {
    int seam = 0;           // index into Pattern::seams
    double ratio = 1;       // longer side over the shorter
    double difference = 0;  // m
};

struct MeshReport {
    int triangles = 0;
    int vertices = 0;                            // sewn
    double min_angle_deg = 0;                    // in material coordinates
    std::string min_angle_panel;                 // where that is
    int seam_edges = 0;                          // sewn edges whose two sides came from different outline edges
    std::optional<SeamMismatch> worst_mismatch;  // none where there are no seams
};

// Pre: `sewn` is merge_seams(unsewn).mesh and `unsewn` is assemble(pattern).
MeshReport report_mesh(const Pattern& pattern, const GarmentMesh& unsewn, const GarmentMesh& sewn);

}  // namespace selvedge
