#pragma once
// Writes garments and bodies to mesh files for other programs, and reads garments. The extension selects the format:
//   .obj  positions in metres, vt = material coordinates in metres per corner, vn, one group per panel;
//   .glb  binary glTF 2.0: one primitive per panel, TEXCOORD_0 = material coordinates in metres (as 1 - v, because v
//         points down in glTF); a body's skeleton and skin if it has them.
// Output is byte-identical for the same mesh in any locale. Files are replaced atomically.
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::sim {

// Throw InputError if the extension is neither .obj nor .glb, there are no triangles, a number is not finite, or the
// file cannot be written. Pre: indices are in range.
void write_garment(const PlainMesh& mesh, const std::filesystem::path& path);
void write_body(const Body& body, const std::filesystem::path& path);

// Reads a garment from an .obj or .glb file of Selvedge or another program. Groups or primitives become panels, texture
// coordinates become material coordinates (m), and vertices within 1e-6 m are merged. Grain angles and sett offsets
// from write_garment() are read separately, because assimp drops them. Throws InputError if the file cannot be read, is
// not a mesh or exceeds the limits of import (sim/body/guarded_import.h).
PlainMesh read_garment(const std::filesystem::path& path);

// One panel of a garment in the layout of mesh files, with one texture coordinate per vertex. A vertex whose corners
// have different material coordinates (at a seam or dart) is duplicated.
struct PanelPart {
    std::string name;
    float grain_angle = 0;                                // rad
    Vec2f sett_offset = Vec2f::Zero();                    // m, see Panel::sett_offset
    std::vector<std::uint32_t> vertices;                  // per vertex of the part: index in the mesh
    std::vector<Vec2f> u;                                 // m, parallel to `vertices`; empty: none in the mesh
    std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into `vertices`
};

// One part per panel that has triangles, in panel order.
std::vector<PanelPart> split_by_panel(const PlainMesh& mesh);

}  // namespace selvedge::sim
