#pragma once
// Which edges of a garment's triangles are seams or hems, and how far the cloth beside them is from them. The shader
// uses both to darken seams and hems.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::render {

// Bit i is the edge opposite corner i.
struct TriangleMarks {
    std::uint32_t seam = 0;  // the edge lies between two panels, or material coordinates jump
    std::uint32_t hem = 0;   // no triangle on the other side
};

std::vector<TriangleMarks> mark_edges(const sim::DrawMesh& mesh);

// m, at one corner of a triangle that touches a seam or hem with a single vertex. The shader interpolates it, so that
// the distance continues without a jump from the triangles that have an edge on the seam or hem.
struct TouchDistance {
    static constexpr float kFar = 1e3F;
    float seam = kFar;
    float hem = kFar;
};

std::vector<std::array<TouchDistance, 3>> touch_distances(const sim::DrawMesh& mesh,
                                                          const std::vector<TriangleMarks>& marks);

// m, height of each corner over the opposite edge.
std::array<float, 3> corner_heights(const std::array<Vec3f, 3>& x);

}  // namespace selvedge::render
