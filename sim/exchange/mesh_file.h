#pragma once
// Garments and bodies as files that other programs open, and garments back in. The extension picks the format:
//   .obj  positions in metres, vt = material coordinates in metres per corner, vn, one group per panel;
//   .glb  binary glTF 2.0: one primitive per panel, TEXCOORD_0 = material coordinates in metres (v downward, as glTF
//         has it: 1 - v); a body's skeleton and skin go with it where they are known.
// Same mesh, same bytes, in any locale; a file is replaced only when the new one is whole.
#include <filesystem>

#include "sim/body/body.h"
#include "sim/mesh/plain_mesh.h"

namespace selvedge {

// Throw InputError when the extension is another, a number is not finite, or the file cannot be written.
// Pre: indices are in range.
void write_garment(const PlainMesh& mesh, const std::filesystem::path& path);
void write_body(const Body& body, const std::filesystem::path& path);

// A garment that was exported as .obj or .glb, by us or by others: groups or primitives become panels, texture
// coordinates become material coordinates (m), vertices at equal positions become one. What assimp cannot keep is read
// beside it: the grain angles and sett offsets that write_garment leaves. Throws InputError as load_body does.
PlainMesh read_garment(const std::filesystem::path& path);

}  // namespace selvedge
