#pragma once
// Catmull-Clark subdivision of closed quad meshes, of any values per vertex at once: positions and skin weights stay
// together. (Catmull and Clark 1978; limit positions: Halstead, Kass, DeRose 1993)
#include <array>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

using Quad = std::array<int, 4>;

// One row per vertex; the first three columns are its position.
using VertexRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct QuadMesh {
    VertexRows values;
    std::vector<Quad> quads;  // counter-clockwise seen from outside
};

// Pre: closed, every edge between two quads. Post: four quads for each; old vertices keep their numbers, then follow
// the edges' and the quads' vertices.
QuadMesh subdivide(const QuadMesh& mesh);

// Moves every vertex to where endless subdivision would take it.
void move_to_limit(QuadMesh& mesh);

// Two triangles for each quad, divided along the shorter diagonal.
std::vector<std::array<int, 3>> split_quads(const QuadMesh& mesh);

// Vertices joined by an edge, each pair once, in the order of their first quad.
std::vector<std::array<int, 2>> quad_edges(const std::vector<Quad>& quads, int vertex_count);

}  // namespace selvedge::sim
