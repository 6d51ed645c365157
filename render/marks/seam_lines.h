#pragma once
// A garment's seams and hems as polylines: connected edges are joined to the lines that a tailor would sew in one go.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh/plain_mesh.h"

namespace selvedge::render {

using VertexPath = std::vector<std::uint32_t>;  // vertices of a mesh; a closed path ends with its first vertex

// Connected marked edges between the same two panels, or within one panel (a dart, or a panel sewn to a tube).
struct SeamLine {
    std::array<std::uint16_t, 2> panels{};  // the smaller one first
    std::vector<VertexPath> paths;          // one path, or more if the line forks
    double length = 0;                      // m
};

struct SeamLines {
    std::vector<SeamLine> seams;  // sorted by panels, then by smallest vertex
    std::vector<SeamLine> hems;   // of one panel each
};

SeamLines find_seam_lines(const sim::PlainMesh& mesh);

}  // namespace selvedge::render
