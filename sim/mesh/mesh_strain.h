#pragma once
// How far a mesh is strained along its threads, from positions and material coordinates alone: the measure of
// sim/cloth/stretch.h for who has no cloth.
#include <vector>

#include "sim/mesh/plain_mesh.h"

namespace selvedge {

struct MeshStrain {
    float warp = 0;  // length of the deformed warp direction less 1: the root of the right Cauchy-Green tensor's entry
    float weft = 0;
};

// One per triangle; 0 where it has no area in the material. Pre: the mesh has material coordinates.
std::vector<MeshStrain> measure_strain(const PlainMesh& mesh);

// A figure of each triangle, carried to the corners: the mean, by material area, over the triangles of the same panel
// about the vertex, for warp and weft are others on the other side of a seam.
// Pre: one value per triangle; the mesh has material coordinates.
std::vector<std::array<float, 3>> smooth_in_panels(const PlainMesh& mesh, const std::vector<float>& values);

}  // namespace selvedge
