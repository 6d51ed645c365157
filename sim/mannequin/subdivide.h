#pragma once
// Catmull-Clark subdivision of closed quad meshes with any number of values per vertex, so that positions and skin
// weights are subdivided together. (Catmull and Clark 1978; limit positions: Halstead, Kass, DeRose 1993)
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

// Pre: closed, every edge belongs to two quads. Post: four quads per quad; old vertices keep their indices, followed by
// the edges' vertices and the quads' vertices.
QuadMesh subdivide(const QuadMesh& mesh);

// Moves every vertex to its limit position under infinite subdivision.
void move_to_limit(QuadMesh& mesh);

// Two triangles per quad, split along the shorter diagonal.
std::vector<std::array<int, 3>> split_quads(const QuadMesh& mesh);

// Edges as vertex pairs, each once, in the order in which the quads first use them.
std::vector<std::array<int, 2>> quad_edges(const std::vector<Quad>& quads, int vertex_count);

}  // namespace selvedge::sim
