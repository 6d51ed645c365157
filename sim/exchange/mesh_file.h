#pragma once
// Writes garments and bodies to mesh files for other programs, and reads garments. The extension selects the format.
// mesh_formats() is the table of the formats; a row is all that the program knows of one.
// The formats:
//   .obj  positions in metres, vn, one group per panel; vt = material coordinates in metres per corner, or with
//   textures
//         the packed panels, each with a comment that takes them back to metres; materials and textures in files
//         beside;
//   .glb  binary glTF 2.0: one primitive per panel, TEXCOORD_0 = the panels packed in the unit square (uv_atlas.h),
//         TEXCOORD_1 = material coordinates in metres (both as 1 - v, because v points down in glTF); a body's skeleton
//         and skin if it has them; textures inside;
//   .ply  binary: positions in metres, normals, both texture coordinates, panel and seam of each vertex (ply_file.h);
//         not read;
//   .stl  binary: triangles in millimetres (stl_file.h); not read.
// Output is byte-identical for the same mesh in any locale. Files are replaced atomically.
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"
#include "sim/exchange/garment_export.h"
#include "sim/exchange/uv_atlas.h"
#include "sim/mesh/draw_mesh.h"

namespace selvedge::sim {

// What a file says of its panels beyond the mesh, by panel name.
struct PanelData {
    std::vector<std::pair<std::string, float>> grain_angles;  // rad
    std::vector<std::pair<std::string, Vec2f>> sett_offsets;  // m, see Panel::sett_offset
    std::vector<std::pair<std::string, UvChart>> charts{};    // where the first texture coordinates are packed
};

struct MeshFormat {
    std::string_view extension;                                                            // lower case: ".obj"
    std::string (*garment)(const DrawMesh& mesh, const GarmentExport& content) = nullptr;  // the bytes of the file
    std::string (*body)(const Body& body) = nullptr;
    // The panel data in a file that assimp has accepted; nullptr: the format is written, but not read. file: its name
    // in error messages.
    PanelData (*panel_data)(std::string_view bytes, const std::string& file) = nullptr;
    // The files beside one with textures; nullptr: it holds everything.
    std::vector<FileBeside> (*files_beside)(const GarmentExport& content) = nullptr;
    bool takes_textures = false;       // GarmentExport::textures
    bool takes_body = false;           // GarmentExport::body
    bool has_panel_materials = false;  // a panel's name is that of its material, not of its mesh
};

const std::vector<MeshFormat>& mesh_formats();

// Their extensions, in the same order.
std::vector<std::string_view> mesh_extensions();

// The format of a file, by its extension in upper or lower case. Throws InputError if there is none.
const MeshFormat& mesh_format_of(const std::filesystem::path& path);

// The files that write_garment() may write beside this one.
std::vector<std::filesystem::path> paths_beside(const std::filesystem::path& path);

// Throw InputError if the extension is of no format, there are no triangles, a number is not finite, the panels do not
// fit in the texture, or the file cannot be written. Pre: indices are in range.
void write_garment(const DrawMesh& mesh, const std::filesystem::path& path, const GarmentExport& content = {});
void write_garment(const DrawMesh& mesh, const std::filesystem::path& path, const MeshFormat& format,
                   const GarmentExport& content = {});
void write_body(const Body& body, const std::filesystem::path& path);

// Reads a garment from a file of Selvedge or another program. Groups or primitives become panels, texture
// coordinates become material coordinates (m), and vertices within 1e-6 m are merged. Grain angles, sett offsets and
// charts from write_garment() are read separately, because assimp drops them. Throws InputError if the file cannot be
// read, is not a mesh or exceeds the limits of import (sim/repair/guarded_import.h).
DrawMesh read_garment(const std::filesystem::path& path);

// One panel of a garment in the layout of mesh files, with one texture coordinate per vertex. A vertex whose corners
// have different material coordinates (at a seam or dart) is duplicated.
struct PanelPart {
    std::string name;
    float grain_angle = 0;                // rad
    Vec2f sett_offset = Vec2f::Zero();    // m, see Panel::sett_offset
    std::vector<std::uint32_t> vertices;  // per vertex of the part: index in the mesh
    std::vector<Vec2f> u;                 // m, parallel to `vertices`; empty: none in the mesh
    std::vector<bool> is_turned;  // parallel to `vertices`: the mesh's normal looks to the part's wrong side there
    std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into `vertices`
    std::optional<UvChart> chart{};                       // from pack_panels()
};

// One part per panel that has triangles, in panel order.
std::vector<PanelPart> split_by_panel(const DrawMesh& mesh);

// Gives each part its chart, if there are material coordinates. Throws InputError if they do not fit.
void pack_panels(std::vector<PanelPart>& parts, const AtlasOptions& options);

// Texture coordinates in the unit square, v upward, parallel to `vertices`. Pre: the part has a chart.
std::vector<Vec2f> packed_uv(const PanelPart& part);

}  // namespace selvedge::sim
