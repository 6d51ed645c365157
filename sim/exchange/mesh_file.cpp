#include "sim/exchange/mesh_file.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_extension.h"
#include "sim/exchange/glb_file.h"
#include "sim/exchange/obj_text.h"
#include "sim/exchange/ply_file.h"
#include "sim/exchange/stl_file.h"
#include "sim/repair/guarded_import.h"
#include "sim/repair/surface_repair.h"

namespace selvedge::sim {
namespace {

PanelData data_in_obj(std::string_view text, const std::string&) {
    return {grain_angles_in_obj(text), sett_offsets_in_obj(text), charts_in_obj(text)};
}

PanelData data_in_glb(std::string_view bytes, const std::string& file) {
    return {grain_angles_in_glb(bytes, file), sett_offsets_in_glb(bytes, file), charts_in_glb(bytes, file)};
}

const std::vector<MeshFormat> kFormats{
    {.extension = ".obj",
     .garment = garment_obj,
     .body = body_obj,
     .panel_data = data_in_obj,
     .files_beside = files_beside_obj,
     .takes_textures = true,
     .takes_body = true},
    {.extension = ".glb",
     .garment = garment_glb,
     .body = body_glb,
     .panel_data = data_in_glb,
     .takes_textures = true,
     .takes_body = true,
     .has_panel_materials = true},  // a primitive of glTF has no name of its own
    {.extension = ".ply", .garment = garment_ply, .body = body_ply, .takes_body = true},
    {.extension = ".stl", .garment = garment_stl, .body = body_stl, .takes_body = true},
};

// "use .obj or .glb"
std::string usable_extensions() {
    std::string text = "use ";
    for (std::size_t i = 0; i < kFormats.size(); ++i) {
        if (i > 0) text += i + 1 < kFormats.size() ? ", " : " or ";
        text += kFormats[i].extension;
    }
    return text;
}

template <class Vector>
void check_finite(const std::vector<Vector>& x, const std::filesystem::path& path) {
    for (std::size_t v = 0; v < x.size(); ++v)
        if (!x[v].allFinite())
            throw InputError(path.string(), "vertex " + std::to_string(v), "not written: it is not finite");
}

void check_corners(const DrawMesh& mesh, const std::filesystem::path& path) {
    for (std::size_t t = 0; t < mesh.u.size(); ++t)
        for (const Vec2f& u : mesh.u[t])
            if (!u.allFinite())
                throw InputError(path.string(), "triangle " + std::to_string(t),
                                 "not written: a material coordinate is not finite");
}

void check_some(std::size_t triangles, const std::filesystem::path& path) {
    if (triangles == 0) throw InputError(path.string(), "", "not written: there are no triangles");
}

std::string panel_name(const ImportedMesh& mesh, const MeshFormat& format) {
    if (format.has_panel_materials && !mesh.material.empty()) return mesh.material;
    return mesh.name;
}

void add_panel(const ImportedMesh& part, DrawMesh& mesh, std::vector<Vec3d>& corners) {
    const std::uint32_t first = std::uint32_t(corners.size());
    const std::uint16_t panel = std::uint16_t(mesh.panel_names.size());
    for (const Vec3f& p : part.x) corners.push_back(p.cast<double>());
    for (const auto& [a, b, c] : part.triangles) {
        mesh.triangles.push_back({first + a, first + b, first + c});
        mesh.panel.push_back(panel);
        if (!part.u.empty()) mesh.u.push_back({part.u[a], part.u[b], part.u[c]});
    }
}

// Merges corners at equal positions into vertices. Files duplicate vertices where texture coordinates are
// discontinuous; a DrawMesh stores them per corner.
void merge_positions(const std::vector<Vec3d>& corners, DrawMesh& mesh) {
    constexpr double kSame = 1e-6;  // m
    const std::vector<int> same = weld(corners, kSame);
    std::vector<std::uint32_t> place(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (same[i] == int(i)) {
            place[i] = std::uint32_t(mesh.x.size());
            mesh.x.push_back(corners[i].cast<float>());
        } else {
            place[i] = place[std::size_t(same[i])];
        }
    }
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& v : triangle) v = place[v];
}

// Of several values for one name, the last. A file may name as many panels and values as it has lines.
template <class T>
std::vector<T> by_panel(const std::vector<std::pair<std::string, T>>& named, const DrawMesh& mesh, const T& usual) {
    std::map<std::string_view, const T*> last;
    for (const auto& [name, value] : named) last[name] = &value;
    std::vector<T> values(mesh.panel_names.size(), usual);
    for (std::size_t panel = 0; panel < mesh.panel_names.size(); ++panel) {
        const auto found = last.find(mesh.panel_names[panel]);
        if (found != last.end()) values[panel] = *found->second;
    }
    return values;
}

void add_panel_data(const PanelData& data, DrawMesh& mesh) {
    mesh.panel_grain_angles = by_panel(data.grain_angles, mesh, 0.0F);
    mesh.panel_sett_offsets = by_panel(data.sett_offsets, mesh, Vec2f(0, 0));
    const std::vector<UvChart> charts = by_panel(data.charts, mesh, UvChart{});  // by default, u is metric as it is
    for (std::size_t t = 0; t < mesh.u.size(); ++t)
        for (Vec2f& u : mesh.u[t]) u = charts[mesh.panel[t]].material(u.cast<double>()).cast<float>();
}

}  // namespace

const std::vector<MeshFormat>& mesh_formats() {
    return kFormats;
}

std::vector<std::string_view> mesh_extensions() {
    std::vector<std::string_view> extensions;
    extensions.reserve(kFormats.size());
    for (const MeshFormat& format : kFormats) extensions.push_back(format.extension);
    return extensions;
}

const MeshFormat& mesh_format_of(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    const auto found = std::ranges::find(kFormats, extension, &MeshFormat::extension);
    if (found == kFormats.end())
        throw InputError(path.string(), "", "'" + extension + "' is not a mesh format: " + usable_extensions());
    return *found;
}

void write_garment(const DrawMesh& mesh, const std::filesystem::path& path, const GarmentExport& content) {
    write_garment(mesh, path, mesh_format_of(path), content);
}

void write_garment(const DrawMesh& mesh, const std::filesystem::path& path, const MeshFormat& format,
                   const GarmentExport& content) {
    check_some(mesh.triangles.size(), path);
    check_finite(mesh.x, path);
    check_finite(mesh.normals, path);
    check_corners(mesh, path);
    GarmentExport named = content;
    named.name = path.stem().string();
    const std::string bytes = format.garment(mesh, named);
    if (format.files_beside != nullptr)
        for (const FileBeside& file : format.files_beside(named))
            write_file_atomically(path.parent_path() / file.name, file.bytes);
    write_file_atomically(path, bytes);
}

std::vector<std::filesystem::path> paths_beside(const std::filesystem::path& path) {
    const MeshFormat& format = mesh_format_of(path);
    if (format.files_beside == nullptr) return {};
    const GarmentExport all{.textures = {.base_colour = "any", .normal = "any"}, .name = path.stem().string()};
    std::vector<std::filesystem::path> paths;
    for (const FileBeside& file : format.files_beside(all)) paths.push_back(path.parent_path() / file.name);
    return paths;
}

void write_body(const Body& body, const std::filesystem::path& path) {
    const MeshFormat& format = mesh_format_of(path);
    check_some(body.triangles.size(), path);
    check_finite(body.x, path);
    write_file_atomically(path, format.body(body));
}

DrawMesh read_garment(const std::filesystem::path& path) {
    const MeshFormat& format = mesh_format_of(path);
    if (format.panel_data == nullptr) throw InputError(path.string(), "", "this format is written, but not read");
    const ImportedScene scene = guarded_import(path);
    const PanelData data = format.panel_data(read_file(path, ImportLimits().file_bytes), path.string());
    // In a file with charts, what has none is the body beside the garment.
    std::set<std::string_view> with_chart;
    for (const auto& [name, chart] : data.charts) with_chart.insert(name);
    const auto is_panel = [&](const std::string& name) { return with_chart.empty() || with_chart.contains(name); };
    DrawMesh mesh;
    std::vector<Vec3d> corners;
    bool has_u = true;
    for (const ImportedMesh& part : scene.meshes) {
        if (part.triangles.empty() || !is_panel(panel_name(part, format))) continue;
        if (mesh.panel_names.size() > UINT16_MAX) throw InputError(path.string(), "", "more than 65,536 panels");
        has_u = has_u && !part.u.empty();
        add_panel(part, mesh, corners);
        mesh.panel_names.push_back(panel_name(part, format));
    }
    if (!has_u) mesh.u.clear();
    merge_positions(corners, mesh);
    mesh.turned_corners = find_turned_corners(mesh.triangles);
    mesh.normals = vertex_normals(mesh.x, mesh.triangles, mesh.turned_corners);
    add_panel_data(data, mesh);
    return mesh;
}

namespace {

constexpr std::uint32_t kNoCopy = UINT32_MAX;

// Linked lists of the part's copies of each mesh vertex. They are short: a vertex has few distinct material coordinates
// in one panel.
struct Copies {
    std::vector<std::uint32_t> first;  // per vertex of the mesh
    std::vector<std::uint32_t> next;   // per vertex of the part
};

std::uint32_t part_vertex(PanelPart& part, Copies& copies, std::uint32_t vertex, const Vec2f* u, bool is_turned) {
    for (std::uint32_t copy = copies.first[vertex]; copy != kNoCopy; copy = copies.next[copy])
        if ((!u || part.u[copy] == *u) && part.is_turned[copy] == is_turned) return copy;
    const std::uint32_t added = std::uint32_t(part.vertices.size());
    part.vertices.push_back(vertex);
    if (u) part.u.push_back(*u);
    part.is_turned.push_back(is_turned);
    copies.next.push_back(copies.first[vertex]);
    copies.first[vertex] = added;
    return added;
}

std::string panel_name(const DrawMesh& mesh, std::size_t panel) {
    return panel < mesh.panel_names.size() ? mesh.panel_names[panel] : "panel" + std::to_string(panel);
}

}  // namespace

std::vector<PanelPart> split_by_panel(const DrawMesh& mesh) {
    SELVEDGE_ASSERT(mesh.panel.empty() || mesh.panel.size() == mesh.triangles.size());
    SELVEDGE_ASSERT(mesh.u.empty() || mesh.u.size() == mesh.triangles.size());
    std::vector<std::vector<std::size_t>> triangles_of_panel;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t panel = panel_of(mesh, t);
        if (panel >= triangles_of_panel.size()) triangles_of_panel.resize(panel + 1);
        triangles_of_panel[panel].push_back(t);
    }
    std::vector<PanelPart> parts;
    Copies copies{std::vector<std::uint32_t>(mesh.x.size(), kNoCopy), {}};
    for (std::size_t panel = 0; panel < triangles_of_panel.size(); ++panel) {
        if (triangles_of_panel[panel].empty()) continue;
        PanelPart part;
        part.name = panel_name(mesh, panel);
        if (panel < mesh.panel_grain_angles.size()) part.grain_angle = mesh.panel_grain_angles[panel];
        if (panel < mesh.panel_sett_offsets.size()) part.sett_offset = mesh.panel_sett_offsets[panel];
        copies.next.clear();
        for (const std::size_t t : triangles_of_panel[panel]) {
            std::array<std::uint32_t, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                SELVEDGE_ASSERT(mesh.triangles[t][k] < mesh.x.size());
                const Vec2f* const u = mesh.u.empty() ? nullptr : &mesh.u[t][k];
                corners[k] = part_vertex(part, copies, mesh.triangles[t][k], u, is_turned(mesh, t, k));
            }
            part.triangles.push_back(corners);
        }
        for (const std::uint32_t v : part.vertices) copies.first[v] = kNoCopy;
        parts.push_back(std::move(part));
    }
    return parts;
}

void pack_panels(std::vector<PanelPart>& parts, const AtlasOptions& options) {
    if (parts.empty() || parts.front().u.empty()) return;
    std::vector<MaterialBox> boxes(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (const Vec2f& u : parts[i].u) boxes[i].extend(u.cast<double>());
    const std::vector<UvChart> charts = pack_charts(boxes, options);
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].chart = charts[i];
}

std::vector<Vec2f> packed_uv(const PanelPart& part) {
    std::vector<Vec2f> uv;
    uv.reserve(part.u.size());
    for (const Vec2f& u : part.u) uv.emplace_back(part.chart->uv(u.cast<double>()).cast<float>());
    return uv;
}

}  // namespace selvedge::sim
