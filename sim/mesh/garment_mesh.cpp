#include "sim/mesh/garment_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"
#include "sim/core/edge_table.h"
#include "sim/mesh/sample_outline.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kFlat = 1e-9;  // smallest valid ratio of twice the area to the squared longest edge

using EdgeSides = EdgeTable<int>::Edge;
using Side = TriangleSide<int>;

using Faults = std::vector<std::string>;

std::string name_of(const GarmentMesh& mesh, int triangle) {
    const int panel = mesh.triangles[static_cast<std::size_t>(triangle)].panel;
    const bool is_known = panel >= 0 && panel < static_cast<int>(mesh.panel_names.size());
    return "triangle " + std::to_string(triangle) +
           (is_known ? " (" + mesh.panel_names[static_cast<std::size_t>(panel)] + ")" : "");
}

std::string name_of(EdgeSides edge) {
    return "edge " + std::to_string(edge[0].low) + "-" + std::to_string(edge[0].high);
}

void check_indices(const GarmentMesh& mesh, Faults& faults) {
    const auto count = static_cast<int>(mesh.x.size());
    const auto is_vertex = [&](int vertex) { return vertex >= 0 && vertex < count; };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const GarmentTriangle& t = mesh.triangles[i];
        const std::string name = name_of(mesh, static_cast<int>(i));
        if (!std::ranges::all_of(t.vertices, is_vertex)) faults.push_back(name + ": no such vertex");
        if (t.panel < 0 || t.panel >= static_cast<int>(mesh.panel_names.size())) faults.push_back(name + ": no panel");
    }
    for (const SeamLink& link : mesh.links) {
        if (!is_vertex(link.a) || !is_vertex(link.b))
            faults.push_back("seam " + std::to_string(link.seam) + ": no such vertex");
    }
    for (int pin : mesh.pins) {
        if (!is_vertex(pin)) faults.push_back("pin: no vertex " + std::to_string(pin));
    }
    if (mesh.panel_grain_angles.size() != mesh.panel_names.size()) faults.push_back("panels: not one grain angle each");
    if (!mesh.panel_sett_offsets.empty() && mesh.panel_sett_offsets.size() != mesh.panel_names.size()) {
        faults.push_back("panels: not one sett offset each");
    }
    if (!mesh.panel_layers.empty() && mesh.panel_layers.size() != mesh.panel_names.size())
        faults.push_back("panels: not one layer each");
}

void check_shapes(const GarmentMesh& mesh, Faults& faults) {
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        if (!mesh.x[i].allFinite()) faults.push_back("vertex " + std::to_string(i) + ": no finite position");
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::array<int, 3>& v = mesh.triangles[i].vertices;
        const std::array<Vec2d, 3>& u = mesh.triangles[i].u;
        const std::string name = name_of(mesh, static_cast<int>(i));
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) faults.push_back(name + ": two corners are one vertex");
        const double longest =
            std::max({(u[1] - u[0]).squaredNorm(), (u[2] - u[1]).squaredNorm(), (u[0] - u[2]).squaredNorm()});
        const double twice_area = cross2(u[1] - u[0], u[2] - u[0]);
        if (!std::isfinite(twice_area)) {
            faults.push_back(name + ": no finite material coordinates");
        } else if (twice_area < -kFlat * longest) {
            faults.push_back(name + ": turned over in its panel");
        } else if (twice_area <= kFlat * longest) {
            faults.push_back(name + ": no area in its panel");
        }
    }
}

void check_duplicates(const GarmentMesh& mesh, Faults& faults) {
    std::map<std::array<int, 3>, int> seen;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::array<int, 3> corners = mesh.triangles[i].vertices;
        std::ranges::sort(corners);
        const auto [first, is_new] = seen.emplace(corners, static_cast<int>(i));
        if (is_new) continue;
        faults.push_back(name_of(mesh, static_cast<int>(i)) + ": same corners as triangle " +
                         std::to_string(first->second));
    }
}

// Whether both triangles lie in one panel with the same material coordinates at the edge: then it is no seam.
bool is_inside_panel(const GarmentMesh& mesh, const Side& first, const Side& second) {
    const GarmentTriangle& a = mesh.triangles[static_cast<std::size_t>(first.triangle)];
    const GarmentTriangle& b = mesh.triangles[static_cast<std::size_t>(second.triangle)];
    const auto u_at = [](const GarmentTriangle& t, int vertex) {
        return t.u[static_cast<std::size_t>(std::ranges::find(t.vertices, vertex) - t.vertices.begin())];
    };
    const auto is_same = [&](int vertex) { return u_at(a, vertex) == u_at(b, vertex); };
    const auto corner = static_cast<std::size_t>(first.k);
    return a.panel == b.panel && is_same(a.vertices[corner]) && is_same(a.vertices[(corner + 1) % 3]);
}

void check_edges(const GarmentMesh& mesh, const EdgeTable<int>& table, Faults& faults) {
    for (const EdgeSides edge : table.edges()) {
        if (edge.size() > 2) {
            faults.push_back(name_of(edge) + ": " + std::to_string(edge.size()) + " triangles meet, first " +
                             name_of(mesh, edge[0].triangle));
        } else if (edge.size() == 2 && edge[0].rises == edge[1].rises && is_inside_panel(mesh, edge[0], edge[1])) {
            faults.push_back(name_of(edge) + ": " + name_of(mesh, edge[0].triangle) + " and " +
                             name_of(mesh, edge[1].triangle) + " face opposite sides");
        }
    }
}

// Joins the corners of neighbouring triangles at their common vertices; corners of a vertex that stay separate belong
// to separate fans.
void check_fans(const GarmentMesh& mesh, const EdgeTable<int>& table, Faults& faults) {
    DisjointSets corners(3 * mesh.triangles.size());
    const auto corner_at = [&](int triangle, int vertex) {
        const auto& v = mesh.triangles[static_cast<std::size_t>(triangle)].vertices;
        return 3 * triangle + static_cast<int>(std::ranges::find(v, vertex) - v.begin());
    };
    for (const EdgeSides edge : table.edges()) {
        for (std::size_t i = 1; i < edge.size(); ++i) {
            for (int vertex : {edge[0].low, edge[0].high}) {
                corners.join(corner_at(edge[0].triangle, vertex), corner_at(edge[i].triangle, vertex));
            }
        }
    }
    std::vector<int> fan(mesh.x.size(), -1);
    std::vector<bool> is_reported(mesh.x.size(), false);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int vertex : mesh.triangles[t].vertices) {
            const auto at = static_cast<std::size_t>(vertex);
            const int own = corners.find(corner_at(static_cast<int>(t), vertex));
            if (fan[at] < 0) fan[at] = own;
            if (fan[at] == own || is_reported[at]) continue;
            faults.push_back("vertex " + std::to_string(vertex) + ": joins triangles that share no edge");
            is_reported[at] = true;
        }
    }
    for (std::size_t i = 0; i < fan.size(); ++i) {
        if (fan[i] < 0) faults.push_back("vertex " + std::to_string(i) + ": belongs to no triangle");
    }
}

// The ends of the sides on one line, by material coordinates: how often a side starts there, less how often one ends.
using LineEnds = std::map<std::pair<double, double>, int>;

// A line in one piece starts once and ends once, or is closed.
void check_pieces(const GarmentMesh& mesh, Faults& faults) {
    std::map<std::pair<int, int>, LineEnds> lines;  // by panel and edge
    for (const GarmentTriangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (t.lines[k].is_none()) continue;
            LineEnds& ends = lines[{t.panel, t.lines[k].edge}];
            const Vec2d &from = t.u[k], &to = t.u[(k + 1) % 3];
            ++ends[{from.x(), from.y()}];
            --ends[{to.x(), to.y()}];
        }
    }
    for (const auto& [line, ends] : lines) {
        const auto starts = std::ranges::count_if(ends, [](const auto& end) { return end.second > 0; });
        if (starts > 1)
            faults.push_back("edge " + std::to_string(line.second) + " of " +
                             mesh.panel_names[static_cast<std::size_t>(line.first)] + ": lies in " +
                             std::to_string(starts) + " pieces");
    }
}

void check_lines(const GarmentMesh& mesh, const EdgeTable<int>& table, Faults& faults) {
    std::vector<bool> has_lines(mesh.panel_names.size(), false);
    for (const GarmentTriangle& t : mesh.triangles) {
        if (!std::ranges::all_of(t.lines, &SideLine::is_none)) has_lines[static_cast<std::size_t>(t.panel)] = true;
    }
    const auto has_none = [&](const Side& side) {
        return mesh.triangles[static_cast<std::size_t>(side.triangle)]
            .lines[static_cast<std::size_t>(side.k)]
            .is_none();
    };
    for (const EdgeSides edge : table.edges()) {
        const bool is_inside = edge.size() == 2 && is_inside_panel(mesh, edge[0], edge[1]);
        if (is_inside && has_none(edge[0]) != has_none(edge[1]))  // both lie on lines where a slit was sewn shut
            faults.push_back(name_of(edge) + ": inside " + name_of(mesh, edge[0].triangle) +
                             ", but on an outline edge");
        for (const Side& side : edge) {
            const int panel = mesh.triangles[static_cast<std::size_t>(side.triangle)].panel;
            if (is_inside || !has_lines[static_cast<std::size_t>(panel)] || !has_none(side)) continue;
            faults.push_back(name_of(edge) + ": at the border of " + name_of(mesh, side.triangle) +
                             ", but on no outline edge");
        }
    }
    check_pieces(mesh, faults);
}

}  // namespace

DrawMesh draw_mesh(const GarmentMesh& mesh) {
    DrawMesh drawn;
    for (const Vec3d& x : mesh.x) drawn.x.emplace_back(x.cast<float>());
    drawn.vertex_level.assign(drawn.x.size(), 0);
    for (const GarmentTriangle& t : mesh.triangles) {
        std::array<std::uint32_t, 3> corners{};
        std::array<Vec2f, 3> u;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = static_cast<std::uint32_t>(t.vertices[k]);
            u[k] = t.u[k].cast<float>();
        }
        drawn.triangles.push_back(corners);
        drawn.u.push_back(u);
        drawn.panel.push_back(static_cast<std::uint16_t>(t.panel));
        drawn.level.push_back(0);
    }
    drawn.normals = vertex_normals(drawn.x, drawn.triangles);
    drawn.panel_names = mesh.panel_names;
    for (const double angle : mesh.panel_grain_angles) drawn.panel_grain_angles.push_back(static_cast<float>(angle));
    for (const Vec2d& offset : mesh.panel_sett_offsets) drawn.panel_sett_offsets.push_back(offset.cast<float>());
    return drawn;
}

std::vector<int> panels_of_vertices(const GarmentMesh& mesh) {
    std::vector<int> panels(mesh.x.size(), -1);
    for (const GarmentTriangle& triangle : mesh.triangles)
        for (const int v : triangle.vertices) panels[static_cast<std::size_t>(v)] = triangle.panel;
    return panels;
}

std::vector<std::string> check_mesh(const GarmentMesh& mesh) {
    Faults faults;
    check_indices(mesh, faults);
    if (!faults.empty()) return faults;  // the other checks need valid indices
    check_shapes(mesh, faults);
    check_duplicates(mesh, faults);
    const EdgeTable<int> table(mesh.triangles, &GarmentTriangle::vertices);
    check_edges(mesh, table, faults);
    check_fans(mesh, table, faults);
    check_lines(mesh, table, faults);
    return faults;
}

namespace {

void measure_angles(const GarmentMesh& mesh, MeshReport& report) {
    double smallest = std::numbers::pi;
    for (const GarmentTriangle& triangle : mesh.triangles) {
        const double angle = smallest_angle(triangle.u[0], triangle.u[1], triangle.u[2]);
        if (angle >= smallest) continue;
        smallest = angle;
        report.min_angle_panel = mesh.panel_names[static_cast<std::size_t>(triangle.panel)];
    }
    report.min_angle_deg = mesh.triangles.empty() ? 0 : smallest * 180 / std::numbers::pi;
}

double side_length(const Pattern& pattern, const SeamSide& side) {
    const Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
    return outline_length(panel, panel.edges[static_cast<std::size_t>(side.edge)]);
}

std::optional<SeamMismatch> worst_mismatch(const Pattern& pattern) {
    std::optional<SeamMismatch> worst;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        const double first = side_length(pattern, pattern.seams[i].first);
        const double second = side_length(pattern, pattern.seams[i].second);
        const auto [shorter, longer] = std::minmax(first, second);
        if (!worst || longer > worst->ratio * shorter) {
            worst = SeamMismatch{static_cast<int>(i), longer / shorter, longer - shorter};
        }
    }
    return worst;
}

}  // namespace

MeshReport report_mesh(const Pattern& pattern, const GarmentMesh& mesh) {
    MeshReport report;
    report.triangles = static_cast<int>(mesh.triangles.size());
    report.worst_mismatch = worst_mismatch(pattern);
    measure_angles(mesh, report);
    return report;
}

namespace {

// Twice the area in material space, m^2.
float material_area(const std::array<Vec2f, 3>& u) {
    const Vec2f a = u[1] - u[0], b = u[2] - u[0];
    return std::abs(a.x() * b.y() - a.y() * b.x());
}

// Strain along a unit direction of material space: its length after deformation - 1. 0 for a triangle of zero area.
float stretch_along(const Vec2f& direction, const std::array<Vec2f, 3>& u, const std::array<Vec3f, 3>& x) {
    const Vec2f a = u[1] - u[0], b = u[2] - u[0];
    const float area = a.x() * b.y() - a.y() * b.x();
    if (area == 0) return 0;
    const float along_a = (direction.x() * b.y() - direction.y() * b.x()) / area;
    const float along_b = (a.x() * direction.y() - a.y() * direction.x()) / area;
    return (along_a * (x[1] - x[0]) + along_b * (x[2] - x[0])).norm() - 1;
}

// A triangle corner with its (vertex, panel) as a sort key.
struct Share {
    std::uint64_t key = 0;  // vertex << 16 | panel
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;

    auto operator<=>(const Share&) const = default;
};

std::vector<Share> sorted_shares(const DrawMesh& mesh) {
    std::vector<Share> shares;
    shares.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t vertex = mesh.triangles[t][corner];
            shares.push_back({vertex << 16U | panel_of(mesh, t), t, corner});
        }
    }
    std::sort(shares.begin(), shares.end());
    return shares;
}

}  // namespace

std::vector<MeshStrain> measure_strain(const DrawMesh& mesh) {
    SELVEDGE_ASSERT(mesh.u.size() == mesh.triangles.size());
    std::vector<MeshStrain> strains;
    strains.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::array<Vec3f, 3> x{mesh.x[a], mesh.x[b], mesh.x[c]};
        const std::size_t panel = panel_of(mesh, t);
        const float grain = panel < mesh.panel_grain_angles.size() ? mesh.panel_grain_angles[panel] : 0;
        const Vec2f warp(-std::sin(grain), std::cos(grain)), weft(std::cos(grain), std::sin(grain));
        strains.push_back({stretch_along(warp, mesh.u[t], x), stretch_along(weft, mesh.u[t], x)});
    }
    return strains;
}

std::vector<std::array<float, 3>> smooth_in_panels(const DrawMesh& mesh, const std::vector<float>& values) {
    SELVEDGE_ASSERT(values.size() == mesh.triangles.size() && mesh.u.size() == mesh.triangles.size());
    std::vector<std::array<float, 3>> corners(mesh.triangles.size(), {0, 0, 0});
    const std::vector<Share> shares = sorted_shares(mesh);
    for (std::size_t first = 0; first < shares.size();) {
        float sum = 0, weight = 0;
        std::size_t last = first;
        for (; last < shares.size() && shares[last].key == shares[first].key; ++last) {
            const float area = material_area(mesh.u[shares[last].triangle]);
            sum += area * values[shares[last].triangle];
            weight += area;
        }
        for (std::size_t i = first; i < last; ++i)
            corners[shares[i].triangle][shares[i].corner] = weight > 0 ? sum / weight : 0;
        first = last;
    }
    return corners;
}

}  // namespace selvedge::sim
