#include "sim/exchange/garmentcode_element.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/lower_case.h"
#include "sim/exchange/little_endian.h"
#include "sim/exchange/mesh_file.h"
#include "sim/exchange/number_text.h"
#include "sim/mesh/sample_outline.h"

namespace selvedge::sim {
namespace {

constexpr double kOnEdge = 1e-5;  // m: above the rounding of material coordinates to floats, far below an edge's length

double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
    const Vec2d along = b - a;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (a + t * along - p).norm();
}

// Which edge of which panel a vertex lies on.
struct EdgePlace {
    SeamSide edge;
    bool is_end = false;

    auto operator<=>(const EdgePlace&) const = default;
};

// The outline edges of a panel as its mesh has them: splits lie on the chords between their samples.
class EdgeChords {
 public:
    EdgeChords(const Panel& panel, const std::vector<int>& segments) : outline_(sample_outline(panel, segments)) {}

    // Adds the edges on which u lies.
    void find(const Vec2d& u, int panel, std::vector<EdgePlace>& places) const {
        for (std::size_t e = 0; e < outline_.runs.size(); ++e) {
            const OutlineRun& run = outline_.runs[e];
            bool is_on = false;
            for (int i = 0; i < run.segments && !is_on; ++i)
                is_on = distance_to_segment(u, point(run, i), point(run, i + 1)) < kOnEdge;
            if (!is_on) continue;
            const bool is_end = (u - point(run, 0)).norm() < kOnEdge || (u - point(run, run.segments)).norm() < kOnEdge;
            places.push_back({{panel, static_cast<int>(e)}, is_end});
        }
    }

 private:
    const Vec2d& point(const OutlineRun& run, int i) const {
        return outline_.points[static_cast<std::size_t>(run.first + i) % outline_.points.size()];
    }

    SampledOutline outline_;
};

// Where the vertices of a mesh are in the pattern.
struct VertexPlaces {
    std::vector<std::vector<EdgePlace>> edges;  // per vertex
    std::vector<int> panel;                     // per vertex: the first that it belongs to; -1: to none
};

int panel_index(const Pattern& pattern, const std::string& name) {
    const auto found = std::ranges::find(pattern.panels, name, &Panel::name);
    return found == pattern.panels.end() ? -1 : static_cast<int>(found - pattern.panels.begin());
}

VertexPlaces find_places(const DrawMesh& mesh, const Pattern& pattern, const MeshOptions& meshing) {
    const std::vector<std::vector<int>> segments = count_segments(pattern, meshing);
    VertexPlaces places{std::vector<std::vector<EdgePlace>>(mesh.x.size()), std::vector<int>(mesh.x.size(), -1)};
    for (const PanelPart& part : split_by_panel(mesh)) {
        const int panel = panel_index(pattern, part.name);
        if (panel < 0) continue;
        const auto p = static_cast<std::size_t>(panel);
        const EdgeChords chords(pattern.panels[p], segments[p]);
        for (std::size_t i = 0; i < part.vertices.size(); ++i) {
            const std::uint32_t v = part.vertices[i];
            if (places.panel[v] < 0) places.panel[v] = panel;
            chords.find(part.u[i].cast<double>(), panel, places.edges[v]);
        }
    }
    return places;
}

bool is_on(const std::vector<EdgePlace>& places, const SeamSide& edge) {
    return std::ranges::find(places, edge, &EdgePlace::edge) != places.end();
}

const OutlineEdge& edge_of(const Pattern& pattern, const SeamSide& side) {
    return panel_of(pattern, side).edges[static_cast<std::size_t>(side.edge)];
}

// The seam that sews an edge; -1: none.
int seam_of(const Pattern& pattern, const SeamSide& edge) {
    const auto found = std::ranges::find_if(
        pattern.seams, [&](const Seam& seam) { return seam.first == edge || seam.second == edge; });
    if (found == pattern.seams.end()) return -1;
    const bool are_worn = panel_of(pattern, found->first).is_worn && panel_of(pattern, found->second).is_worn;
    return are_worn ? static_cast<int>(found - pattern.seams.begin()) : -1;
}

// Per vertex: the seams of which it lies on both sides. A dart's tip does.
std::vector<std::vector<int>> find_stitches(const Pattern& pattern, const VertexPlaces& places) {
    std::vector<std::vector<int>> stitches(places.edges.size());
    for (std::size_t v = 0; v < places.edges.size(); ++v) {
        std::set<int> seams;
        for (const EdgePlace& place : places.edges[v]) {
            const int s = seam_of(pattern, place.edge);
            if (s < 0) continue;
            const Seam& seam = pattern.seams[static_cast<std::size_t>(s)];
            if (is_on(places.edges[v], seam.first) && is_on(places.edges[v], seam.second)) seams.insert(s);
        }
        stitches[v].assign(seams.begin(), seams.end());
    }
    return stitches;
}

// Stitches first, by their first seam; then the other vertices by panel.
std::vector<std::uint32_t> ordered(const VertexPlaces& places, const std::vector<std::vector<int>>& stitches) {
    std::vector<std::uint32_t> order(places.panel.size());
    std::iota(order.begin(), order.end(), 0U);
    std::erase_if(order, [&](std::uint32_t v) { return places.panel[v] < 0; });
    std::ranges::stable_sort(order, {}, [&](std::uint32_t v) {
        return stitches[v].empty() ? std::pair(1, places.panel[v]) : std::pair(0, stitches[v].front());
    });
    return order;
}

// The labels that a vertex has.
std::set<std::string> labels_at(const Pattern& pattern, const std::vector<EdgePlace>& places,
                                const std::vector<int>& stitches) {
    std::set<std::string> labels;
    for (const int s : stitches) {
        const Seam& seam = pattern.seams[static_cast<std::size_t>(s)];
        for (const SeamSide& side : {seam.first, seam.second}) labels.insert(edge_of(pattern, side).label);
    }
    for (const EdgePlace& place : places)
        if (!place.is_end && seam_of(pattern, place.edge) < 0) labels.insert(edge_of(pattern, place.edge).label);
    labels.erase("");
    return labels;
}

std::vector<std::string> labels_of(const Pattern& pattern) {
    std::vector<std::string> labels;
    for (const Panel& panel : pattern.panels)
        for (const OutlineEdge& edge : panel.edges)
            if (!edge.label.empty() && std::ranges::find(labels, edge.label) == labels.end())
                labels.push_back(edge.label);
    return labels;
}

}  // namespace

GarmentSegmentation segment_garment(const DrawMesh& mesh, const Pattern& pattern, const MeshOptions& meshing) {
    const VertexPlaces places = find_places(mesh, pattern, meshing);
    const std::vector<std::vector<int>> stitches = find_stitches(pattern, places);
    GarmentSegmentation found{.order = ordered(places, stitches), .stitches = {}, .panels = {}, .labels = {}};
    for (const std::string& label : labels_of(pattern)) found.labels.push_back({label, {}});
    for (std::size_t i = 0; i < found.order.size(); ++i) {
        const std::uint32_t v = found.order[i];
        found.stitches.push_back(stitches[v]);
        found.panels.push_back(pattern.panels[static_cast<std::size_t>(places.panel[v])].name);
        const std::set<std::string> labels = labels_at(pattern, places.edges[v], stitches[v]);
        for (GarmentSegmentation::Label& label : found.labels)
            if (labels.contains(label.name)) label.vertices.push_back(static_cast<std::uint32_t>(i));
    }
    std::erase_if(found.labels, [](const GarmentSegmentation::Label& label) { return label.vertices.empty(); });
    return found;
}

std::vector<std::vector<int>> seams_of_vertices(const DrawMesh& mesh, const Pattern& pattern,
                                                const MeshOptions& meshing) {
    const GarmentSegmentation found = segment_garment(mesh, pattern, meshing);
    std::vector<std::vector<int>> seams(mesh.x.size());
    for (std::size_t i = 0; i < found.order.size(); ++i) seams[found.order[i]] = found.stitches[i];
    return seams;
}

namespace {

constexpr float kCentimetres = 100;

// A panel's name in a list of one line per vertex, apart from the names of stitches and without commas.
std::string listed_name(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == ',' || static_cast<unsigned char>(c) < ' '; }, '_');
    return name.starts_with("stitch_") ? "panel_" + name : name;
}

std::string segmentation_text(const GarmentSegmentation& segmentation) {
    std::string text;
    for (std::size_t i = 0; i < segmentation.order.size(); ++i) {
        const std::vector<int>& stitches = segmentation.stitches[i];
        if (stitches.empty()) text += listed_name(segmentation.panels[i]);
        for (std::size_t k = 0; k < stitches.size(); ++k)
            text += (k > 0 ? ",stitch_" : "stitch_") + std::to_string(stitches[k]);
        text += '\n';
    }
    return text;
}

// A key of YAML: in double quotes unless it is a plain word.
std::string yaml_key(const std::string& name) {
    const auto is_plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const bool starts_with_letter = std::isalpha(static_cast<unsigned char>(name.front())) != 0;
    constexpr std::array<std::string_view, 6> kWords{"true", "false", "yes", "no", "on", "off"};
    const std::string lower = lower_case(name);
    const bool is_word =
        std::ranges::find(kWords, lower) != kWords.end() || lower == "null" || lower == "y" || lower == "n";
    if (starts_with_letter && std::ranges::all_of(name, is_plain) && !is_word) return name;
    std::string quoted = "\"";
    for (const char c : name) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += std::iscntrl(static_cast<unsigned char>(c)) != 0 ? '_' : c;
    }
    return quoted + '"';
}

std::string labels_text(const GarmentSegmentation& segmentation) {
    if (segmentation.labels.empty()) return "{}\n";
    std::string text;
    for (const GarmentSegmentation::Label& label : segmentation.labels) {
        text += yaml_key(label.name) + ":\n";
        for (const std::uint32_t v : label.vertices) text += "- " + std::to_string(v) + '\n';
    }
    return text;
}

// The cloth with its vertices in another order, in centimetres.
struct OrderedCloth {
    std::vector<Vec3f> x;
    std::vector<Vec3f> normals;
    std::vector<PanelPart> parts;         // with charts; their vertices are those of the mesh
    std::vector<std::uint32_t> index_of;  // by vertex of the mesh
};

OrderedCloth in_order(const DrawMesh& mesh, const std::vector<std::uint32_t>& order) {
    OrderedCloth cloth{.x = {}, .normals = {}, .parts = split_by_panel(mesh), .index_of{}};
    pack_panels(cloth.parts, {});
    cloth.index_of.resize(mesh.x.size());
    const std::vector<Vec3f> normals = vertex_normals(mesh);
    for (std::size_t i = 0; i < order.size(); ++i) {
        cloth.x.emplace_back(kCentimetres * mesh.x[order[i]]);
        cloth.normals.push_back(normals[order[i]]);
        cloth.index_of[order[i]] = static_cast<std::uint32_t>(i);
    }
    return cloth;
}

std::string obj_of(const OrderedCloth& cloth) {
    std::string text = "# Selvedge garment for GarmentCode: centimetres, y up\n";
    for (const Vec3f& x : cloth.x) append_vector(text, "v", x);
    std::size_t first = 1;
    for (const PanelPart& part : cloth.parts)
        for (const Vec2f& uv : packed_uv(part)) append_vector(text, "vt", uv);
    for (const PanelPart& part : cloth.parts) {
        for (const auto& triangle : part.triangles) {
            text += 'f';
            for (const std::uint32_t corner : triangle) {
                text += ' ';
                append_number(text, cloth.index_of[part.vertices[corner]] + 1);
                text += '/';
                append_number(text, first + corner);
            }
            text += '\n';
        }
        first += part.vertices.size();
    }
    return text;
}

std::string ply_of(const OrderedCloth& cloth) {
    std::size_t triangles = 0;
    for (const PanelPart& part : cloth.parts) triangles += part.triangles.size();
    std::string bytes = "ply\nformat binary_little_endian 1.0\n";
    bytes += "comment Selvedge garment for GarmentCode: centimetres, y up\n";
    bytes += "element vertex " + std::to_string(cloth.x.size()) + '\n';
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) ((bytes += "property float ") += name) += '\n';
    bytes += "element face " + std::to_string(triangles) + '\n';
    bytes += "property list uchar int vertex_indices\nend_header\n";
    for (std::size_t v = 0; v < cloth.x.size(); ++v) {
        append_values(bytes, cloth.x[v].data(), 3);
        append_values(bytes, cloth.normals[v].data(), 3);
    }
    for (const PanelPart& part : cloth.parts) {
        for (const auto& triangle : part.triangles) {
            append_value(bytes, std::uint8_t{3});
            for (const std::uint32_t corner : triangle)
                append_value(bytes, static_cast<std::int32_t>(cloth.index_of[part.vertices[corner]]));
        }
    }
    return bytes;
}

void check_can_write(const DrawMesh& mesh, const std::filesystem::path& folder) {
    if (mesh.triangles.empty()) throw InputError(folder.string(), "", "not written: there are no triangles");
    if (mesh.u.empty()) throw InputError(folder.string(), "", "not written: there are no material coordinates");
    for (std::size_t v = 0; v < mesh.x.size(); ++v)
        if (!mesh.x[v].allFinite())
            throw InputError(folder.string(), "vertex " + std::to_string(v), "not written: it is not finite");
}

}  // namespace

std::array<std::filesystem::path, kGarmentCodeFiles> garmentcode_paths(const std::filesystem::path& folder,
                                                                       const std::string& name) {
    return {folder / (name + "_sim.obj"), folder / (name + "_sim.ply"), folder / (name + "_sim_segmentation.txt"),
            folder / (name + "_vertex_labels.yaml"), folder / (name + "_specification.json")};
}

void write_garmentcode_element(const DrawMesh& mesh, const PatternDocument& document, const MeshOptions& meshing,
                               const std::filesystem::path& folder, const std::string& name) {
    check_can_write(mesh, folder);
    const GarmentSegmentation segmentation = segment_garment(mesh, document.pattern, meshing);
    const OrderedCloth cloth = in_order(mesh, segmentation.order);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(folder.string(), "", "cannot make the folder: " + error.message());
    const auto [obj, ply, text, labels, specification] = garmentcode_paths(folder, name);
    write_file_atomically(obj, obj_of(cloth));
    write_file_atomically(ply, ply_of(cloth));
    write_file_atomically(text, segmentation_text(segmentation));
    write_file_atomically(labels, labels_text(segmentation));
    save_pattern(document, specification);
}

}  // namespace selvedge::sim
