#pragma once
// Whether a garment mesh is sound, and what it measures.  (SPEC 3.1)
#include <string>
#include <vector>

#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// Every fault of the mesh, each with its place ("triangle 12 (front): ..."); empty when it is sound: indices in range,
// numbers finite, no triangle of zero area or given twice, no edge with three triangles or with two that run the same
// way along it, no vertex without a triangle or that joins two fans of triangles.
std::vector<std::string> check_mesh(const GarmentMesh& mesh);

struct MeshReport {
    int triangles = 0;
    int vertices = 0;                  // of the sewn mesh
    double min_angle_deg = 0;          // in material coordinates
    std::string min_angle_panel;
    int seam_edges = 0;                // of the sewn mesh
    double worst_length_mismatch = 0;  // longer side of a seam over the shorter, less 1
    double worst_length_difference = 0;  // m, of that seam
    int worst_seam = -1;               // index into Pattern::seams; -1: there are no seams
};

MeshReport report_mesh(const Pattern& pattern, const GarmentMesh& unsewn, const GarmentMesh& sewn);

}  // namespace selvedge
