#include "sim/exchange/ply_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "sim/exchange/little_endian.h"
#include "sim/exchange/mesh_cache.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge::sim {
namespace {

std::string one_line(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, '_');
    return name;
}

void append_properties(std::string& text, std::string_view type, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) ((((text += "property ") += type) += ' ') += name) += '\n';
}

struct Counts {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
};

enum class Labels { None, PanelAndSeam };

constexpr std::int32_t kBodyPanel = -1;

std::string header(const std::vector<PanelPart>& parts, const DrawMesh* body, Labels labels, Counts counts) {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    if (labels == Labels::None) {
        text += "comment Selvedge body: metres, y up\n";
    } else {
        text += "comment Selvedge garment: metres, y up; s t in the unit square, material_u material_v in metres\n";
        for (std::size_t i = 0; i < parts.size(); ++i)
            text += "comment panel " + std::to_string(i) + ' ' + one_line(parts[i].name) + '\n';
        if (body != nullptr) text += "comment panel " + std::to_string(kBodyPanel) + " is the body\n";
    }
    text += "element vertex " + std::to_string(counts.vertices) + '\n';
    append_properties(text, "float", {"x", "y", "z", "nx", "ny", "nz"});
    if (!parts.front().u.empty()) append_properties(text, "float", {"s", "t", "material_u", "material_v"});
    if (labels == Labels::PanelAndSeam) {
        append_properties(text, "int", {"panel"});
        append_properties(text, "uchar", {"seam"});
    }
    text += "element face " + std::to_string(counts.triangles) + "\nproperty list uchar uint vertex_indices\n";
    return text + "end_header\n";
}

// In how many places of the parts each vertex of the mesh occurs: more than once at seams and darts.
std::vector<std::uint32_t> occurrences(const std::vector<PanelPart>& parts, std::size_t vertices) {
    std::vector<std::uint32_t> count(vertices, 0);
    for (const PanelPart& part : parts)
        for (const std::uint32_t v : part.vertices) ++count[v];
    return count;
}

void append_labels(std::string& bytes, std::int32_t panel, bool is_on_seam) {
    append_value(bytes, panel);
    append_value(bytes, static_cast<std::uint8_t>(is_on_seam ? 1 : 0));
}

// The body's vertices have the properties of the others; its texture and material coordinates are zero.
void append_body_vertices(std::string& bytes, const DrawMesh& body, bool has_u) {
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        append_values(bytes, body.x[v].data(), 3);
        append_values(bytes, body.normals[v].data(), 3);
        constexpr float kNone[4]{};
        if (has_u) append_values(bytes, kNone, 4);
        append_labels(bytes, kBodyPanel, false);
    }
}

void append_faces(std::string& bytes, const std::vector<std::array<std::uint32_t, 3>>& triangles, std::uint32_t first) {
    for (const auto& triangle : triangles) {
        append_value(bytes, std::uint8_t{3});
        for (const std::uint32_t corner : triangle) append_value(bytes, first + corner);
    }
}

// body: only with labels; null: none.
std::string ply(const DrawMesh& mesh, const std::vector<PanelPart>& parts, const DrawMesh* body, Labels labels) {
    const std::vector<Vec3f> normals = vertex_normals(mesh);
    const std::vector<std::uint32_t> count = occurrences(parts, mesh.x.size());
    Counts counts{.triangles = mesh.triangles.size()};
    for (const PanelPart& part : parts) counts.vertices += part.vertices.size();
    if (body != nullptr) counts = {counts.vertices + body->x.size(), counts.triangles + body->triangles.size()};
    std::string bytes = header(parts, body, labels, counts);
    for (std::size_t panel = 0; panel < parts.size(); ++panel) {
        const PanelPart& part = parts[panel];
        const std::vector<Vec2f> packed = packed_uv(part);
        for (std::size_t i = 0; i < part.vertices.size(); ++i) {
            const std::uint32_t v = part.vertices[i];
            append_values(bytes, mesh.x[v].data(), 3);
            append_values(bytes, (part.is_turned[i] ? Vec3f(-normals[v]) : normals[v]).data(), 3);
            if (!part.u.empty()) {
                append_values(bytes, packed[i].data(), 2);
                append_values(bytes, part.u[i].data(), 2);
            }
            if (labels != Labels::None) append_labels(bytes, static_cast<std::int32_t>(panel), count[v] > 1);
        }
    }
    if (body != nullptr) append_body_vertices(bytes, *body, !parts.front().u.empty());
    std::uint32_t first = 0;
    for (const PanelPart& part : parts) {
        append_faces(bytes, part.triangles, first);
        first += static_cast<std::uint32_t>(part.vertices.size());
    }
    if (body != nullptr) append_faces(bytes, body->triangles, first);
    return bytes;
}

}  // namespace

std::string garment_ply(const DrawMesh& mesh, const GarmentExport& content) {
    std::vector<PanelPart> parts = split_by_panel(mesh);
    pack_panels(parts, content.atlas);
    if (content.body == nullptr) return ply(mesh, parts, nullptr, Labels::PanelAndSeam);
    const DrawMesh body = body_mesh(*content.body);
    return ply(mesh, parts, &body, Labels::PanelAndSeam);
}

std::string body_ply(const Body& body) {
    const DrawMesh mesh = body_mesh(body);
    return ply(mesh, split_by_panel(mesh), nullptr, Labels::None);
}

}  // namespace selvedge::sim
