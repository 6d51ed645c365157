#pragma once
// A garment's mesh as the cloth shader reads it: three vertices to a triangle, for material coordinates, edges and
// levels belong to triangles and their corners.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/vec.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge {

// How open a point is to the room's light, 0..1, on the surface's two sides.
struct Openness {
    float front = 1;
    float back = 1;
};

struct ClothVertex {
    std::array<float, 3> position;  // m
    std::array<float, 3> normal;
    std::array<float, 2> place;    // (weft, warp), m: material coordinates turned by the panel's grain, and its offset
    std::array<float, 3> heights;  // m; at this corner: its height over the opposite edge, else 0
    std::array<float, 2> openness;
    std::array<float, 2> touch;  // m to a seam and a hem that the triangle touches with one corner only
    std::uint32_t marks;         // level | seam edges << 8 | hem edges << 11; edge i is opposite corner i
};

// normals: one per vertex of the mesh, also when the mesh has its own. Seam edges are those where material
// coordinates jump, hem edges those with one triangle. Pre: openness has one entry per vertex of the mesh.
std::vector<ClothVertex> make_cloth_vertices(const PlainMesh& mesh, const std::vector<Vec3f>& normals,
                                             const std::vector<Openness>& openness);

}  // namespace selvedge
