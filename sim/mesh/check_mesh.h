#pragma once
// Whether a garment mesh is sound.  (SPEC 3.1)
#include <string>
#include <vector>

#include "sim/mesh/garment_mesh.h"

namespace selvedge {

// Every fault of the mesh, each with its place ("triangle 12 (front): ..."); empty when it is sound: indices in range,
// numbers finite, no triangle of zero area or given twice, no edge with three triangles or with two that run the same
// way along it, no vertex without a triangle or that joins two fans of triangles.
std::vector<std::string> check_mesh(const GarmentMesh& mesh);

}  // namespace selvedge
