#include "sim/mesh/check_mesh.h"

#include <algorithm>
#include <map>
#include <utility>

#include "sim/mesh/linked_vertices.h"

namespace selvedge {
namespace {

constexpr double kFlat = 1e-9;  // twice the area over the longest edge squared: less is no triangle

using EdgeEnds = std::pair<int, int>;  // lower vertex first

struct EdgeUse {
    int triangle = 0;
    int corner = 0;  // the edge runs from this corner to the next
};

using Faults = std::vector<std::string>;

std::string name_of(const GarmentMesh& mesh, int triangle) {
    const int panel = mesh.triangles[static_cast<std::size_t>(triangle)].panel;
    const bool is_known = panel >= 0 && panel < static_cast<int>(mesh.panel_names.size());
    return "triangle " + std::to_string(triangle) +
           (is_known ? " (" + mesh.panel_names[static_cast<std::size_t>(panel)] + ")" : "");
}

std::string name_of(const EdgeEnds& edge) {
    return "edge " + std::to_string(edge.first) + "-" + std::to_string(edge.second);
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
}

void check_shapes(const GarmentMesh& mesh, Faults& faults) {
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        if (!mesh.x[i].allFinite()) faults.push_back("vertex " + std::to_string(i) + ": no finite position");
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [v, u, panel] = mesh.triangles[i];
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

std::map<EdgeEnds, std::vector<EdgeUse>> edges_of(const GarmentMesh& mesh) {
    std::map<EdgeEnds, std::vector<EdgeUse>> edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& v = mesh.triangles[i].vertices;
        for (std::size_t k = 0; k < 3; ++k) {
            edges[std::minmax({v[k], v[(k + 1) % 3]})].push_back({static_cast<int>(i), static_cast<int>(k)});
        }
    }
    return edges;
}

int start_of(const GarmentMesh& mesh, const EdgeUse& use) {
    return mesh.triangles[static_cast<std::size_t>(use.triangle)].vertices[static_cast<std::size_t>(use.corner)];
}

void check_edges(const GarmentMesh& mesh, Faults& faults) {
    for (const auto& [edge, uses] : edges_of(mesh)) {
        if (uses.size() > 2) {
            faults.push_back(name_of(edge) + ": " + std::to_string(uses.size()) + " triangles meet, first " +
                             name_of(mesh, uses[0].triangle));
        } else if (uses.size() == 2 && start_of(mesh, uses[0]) == start_of(mesh, uses[1])) {
            faults.push_back(name_of(edge) + ": " + name_of(mesh, uses[0].triangle) + " and " +
                             name_of(mesh, uses[1].triangle) + " face opposite sides");
        }
    }
}

// Joins the corners of neighbouring triangles round their common vertices: what is left apart are separate fans.
void check_fans(const GarmentMesh& mesh, Faults& faults) {
    DisjointSets corners(3 * mesh.triangles.size());
    const auto corner_at = [&](int triangle, int vertex) {
        const auto& v = mesh.triangles[static_cast<std::size_t>(triangle)].vertices;
        return 3 * triangle + static_cast<int>(std::ranges::find(v, vertex) - v.begin());
    };
    for (const auto& [edge, uses] : edges_of(mesh)) {
        for (std::size_t i = 1; i < uses.size(); ++i) {
            for (int vertex : {edge.first, edge.second}) {
                corners.join(corner_at(uses[0].triangle, vertex), corner_at(uses[i].triangle, vertex));
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

}  // namespace

std::vector<std::string> check_mesh(const GarmentMesh& mesh) {
    Faults faults;
    check_indices(mesh, faults);
    if (!faults.empty()) return faults;  // the rest relies on indices
    check_shapes(mesh, faults);
    check_duplicates(mesh, faults);
    check_edges(mesh, faults);
    check_fans(mesh, faults);
    return faults;
}

}  // namespace selvedge
