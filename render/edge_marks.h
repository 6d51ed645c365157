#pragma once
// Which edges of a garment's triangles are sewn or hemmed, and how far from them the cloth beside them is, so that both
// can be drawn.
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/core/vec.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge {

// Bit i is the edge opposite corner i.
struct TriangleMarks {
    std::uint32_t seam = 0;  // material coordinates jump
    std::uint32_t hem = 0;   // no triangle on the other side
};

std::vector<TriangleMarks> mark_edges(const PlainMesh& mesh);

// m, at one corner of a triangle that touches a seam or hem with a single vertex: to be interpolated, so that the
// distance goes on without a jump from the triangles that lie along it.
struct TouchDistance {
    static constexpr float kFar = 1e3F;
    float seam = kFar;
    float hem = kFar;
};

std::vector<std::array<TouchDistance, 3>> touch_distances(const PlainMesh& mesh,
                                                          const std::vector<TriangleMarks>& marks);

// Of each corner over the opposite edge, m.
std::array<float, 3> corner_heights(const std::array<Vec3f, 3>& x);

}  // namespace selvedge
