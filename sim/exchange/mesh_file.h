#pragma once
// Garments and bodies as files that other programs open, and garments back in. The extension picks the format:
//   .obj  positions in metres, vt = material coordinates in metres per corner, vn, one group per panel;
//   .glb  binary glTF 2.0: one primitive per panel, TEXCOORD_0 = material coordinates in metres (v downward, as glTF
//         has it: 1 - v); a body's skeleton and skin go with it where they are known.
// Same mesh, same bytes, in any locale; a file is replaced only when the new one is whole.
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge::sim {

// Throw InputError when the extension is another, a number is not finite, or the file cannot be written.
// Pre: indices are in range.
void write_garment(const PlainMesh& mesh, const std::filesystem::path& path);
void write_body(const Body& body, const std::filesystem::path& path);

// A garment that was exported as .obj or .glb, by us or by others: groups or primitives become panels, texture
// coordinates become material coordinates (m), vertices at equal positions become one. What assimp cannot keep is read
// beside it: the grain angles and sett offsets that write_garment leaves. Throws InputError as load_body does.
PlainMesh read_garment(const std::filesystem::path& path);

// A garment as files want it: panel by panel, with one texture coordinate per vertex. A vertex on a seam, whose corners
// disagree about their material coordinate, becomes several.

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

}  // namespace selvedge::sim
