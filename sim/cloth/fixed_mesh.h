#pragma once
// The cloth sampled on one mesh of fixed topology, for animation caches: other programs read animations whose vertices
// keep their number and order, but the cloth's adaptive mesh changes from frame to frame. The fixed mesh is the base
// mesh with each triangle divided `level` times into four; here once and twice:
//
//         /\                /\          Each of its vertices is a fixed point of the material. sample() descends from
//        /  \              /__\         the vertex' base triangle to the leaf that contains the point, with barycentric
//       /____\            /\  /\        coordinates as integers, and interpolates the positions of the leaf's corners.
//      /\    /\          /__\/__\       So a point at which the cloth has a vertex has that vertex' position to the
//     /  \  /  \        /\  /\  /\      bit. Leaves meet without T-junctions, so the samples are continuous, and
//    /____\/____\      /__\/__\/__\     vertices on a seam are one as in the cloth.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

inline constexpr int kFinestFixedLevel = 4;  // 256 triangles for each of the base mesh

// A vertex of the fixed mesh: the base triangle that it belongs to, one of several on an edge of it, and its
// barycentric coordinates there times 2^level.
struct FixedSample {
    TriangleId triangle;
    std::array<std::uint8_t, 3> weights{};
};

struct FixedMesh {
    int level = 0;
    // One per vertex: those of the base mesh with the same numbers, then those on base edges, then those in triangles.
    std::vector<FixedSample> samples;
    // Positions and normals as of make_fixed_mesh(), material coordinates and panels as in draw_mesh(). Base triangle i
    // has the triangles i * 4^level to (i + 1) * 4^level - 1. turned_corners as find_turned_corners() finds them.
    DrawMesh mesh;
};

// Pre: 0 <= level <= kFinestFixedLevel. With the cloth's max_level no vertex of the cloth is left out.
FixedMesh make_fixed_mesh(const Cloth& cloth, const std::vector<std::string>& panel_names, int level);

// The finest level, 0..kFinestFixedLevel, at which the fixed mesh has at most that many triangles; 0 if none has.
int fixed_level_for(const Cloth& cloth, std::size_t max_triangles);

// Positions of the fixed mesh's vertices, m. Time is proportional to their number.
// Pre: the cloth has the base mesh of which the fixed mesh was made, adapted in any way.
void sample(const FixedMesh& fixed, const Cloth& cloth, std::vector<Vec3f>& x);

}  // namespace selvedge::sim
