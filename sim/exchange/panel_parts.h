#pragma once
// A garment as files want it: panel by panel, with one texture coordinate per vertex. A vertex on a seam, whose corners
// disagree about their material coordinate, becomes several.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/core/vec.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge {

struct PanelPart {
    std::string name;
    float grain_angle = 0;                                // rad
    Vec2f sett_offset = Vec2f::Zero();                    // m, see Panel::sett_offset
    std::vector<std::uint32_t> vertices;                  // of the mesh, one per vertex of the part
    std::vector<Vec2f> u;                                 // m, beside `vertices`; empty when the mesh has none
    std::vector<std::array<std::uint32_t, 3>> triangles;  // of the part's vertices
};

// One part per panel that has triangles, in the order of the panels.
std::vector<PanelPart> split_by_panel(const PlainMesh& mesh);

}  // namespace selvedge
