#pragma once
// A garment's seams and hems as lines: edges that are sewn, put together to those that a tailor would sew in one go.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh/plain_mesh.h"

namespace selvedge::render {

using VertexPath = std::vector<std::uint32_t>;  // vertices of a mesh; a closed one ends with its first

// Connected edges between the same two panels, or within one: a dart, or a tube that is closed.
struct SeamLine {
    std::array<std::uint16_t, 2> panels{};  // the lesser first
    std::vector<VertexPath> paths;          // one, but where the line forks
    double length = 0;                      // m
};

struct SeamLines {
    std::vector<SeamLine> seams;  // by their panels, then by their least vertex
    std::vector<SeamLine> hems;   // of one panel each
};

SeamLines find_seam_lines(const sim::PlainMesh& mesh);

}  // namespace selvedge::render
