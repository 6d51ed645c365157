#pragma once
// Panels, small patterns and a topology check that the tests of sim/mesh share.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/disjoint_sets.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/sew.h"
#include "sim/mesh/triangulate.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

inline constexpr double kPi = std::numbers::pi;

// A panel with straight edges through the points, which must be counter-clockwise.
inline Panel polygon(const std::string& name, const std::vector<Vec2d>& points) {
    Panel panel;
    panel.name = name;
    panel.vertices = points;
    const auto count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) {
        OutlineEdge edge;
        edge.start = i;
        edge.end = (i + 1) % count;
        panel.edges.push_back(edge);
    }
    return panel;
}

// Edges: 0 bottom, 1 right, 2 top, 3 left.
inline Panel rectangle(const std::string& name, double width, double height) {
    return polygon(name, {{0, 0}, {width, 0}, {width, height}, {0, height}});
}

// A square with a wedge cut out of its bottom edge; the dart's legs are edges 1 and 2, its tip is vertex 2.
inline Panel square_with_dart(double side, double width, double depth) {
    const double middle = side / 2;
    return polygon("darted", {{0, 0},
                              {middle - width / 2, 0},
                              {middle, depth},
                              {middle + width / 2, 0},
                              {side, 0},
                              {side, side},
                              {0, side}});
}

inline double outline_area_of(const PanelMesh& mesh) {
    double twice = 0;
    for (std::size_t i = 0; i < mesh.outline.size(); ++i) {
        const auto at = static_cast<std::size_t>(mesh.outline[i]);
        const auto next = static_cast<std::size_t>(mesh.outline[(i + 1) % mesh.outline.size()]);
        twice += cross2(mesh.u[at], mesh.u[next]);
    }
    return twice / 2;
}

inline double area_of(const std::array<Vec2d, 3>& u) {
    return cross2(u[1] - u[0], u[2] - u[0]) / 2;
}

inline double area_of(const PanelMesh& mesh) {
    double area = 0;
    for (const auto& t : mesh.triangles) {
        area += area_of({mesh.u[static_cast<std::size_t>(t[0])], mesh.u[static_cast<std::size_t>(t[1])],
                         mesh.u[static_cast<std::size_t>(t[2])]});
    }
    return area;
}

// The mesh of one panel as a garment mesh, for check_mesh().
inline GarmentMesh as_garment(const PanelMesh& mesh) {
    GarmentMesh garment;
    for (const Vec2d& u : mesh.u) garment.x.emplace_back(u.x(), u.y(), 0);
    for (const auto& t : mesh.triangles) {
        GarmentTriangle triangle{t, {}, 0};
        for (std::size_t k = 0; k < 3; ++k) triangle.u[k] = mesh.u[static_cast<std::size_t>(t[k])];
        garment.triangles.push_back(triangle);
    }
    garment.panel_names = {"panel"};
    garment.panel_grain_angles = {0};
    return garment;
}

// The mesh with its seams merged.
inline GarmentMesh sew_together(GarmentMesh mesh) {
    merge_seams(mesh);
    return mesh;
}

// The number of edges that two triangles share after sewing but not before. Both meshes have the same triangles.
inline int count_seam_edges(const GarmentMesh& before, const GarmentMesh& after) {
    using EdgeEnds = std::pair<int, int>;  // lower vertex first
    const auto edge_of = [](const GarmentTriangle& triangle, std::size_t k) -> EdgeEnds {
        return std::minmax({triangle.vertices[k], triangle.vertices[(k + 1) % 3]});
    };
    std::map<EdgeEnds, EdgeEnds> edge_before;
    int count = 0;
    for (std::size_t t = 0; t < after.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const EdgeEnds own = edge_of(before.triangles[t], k);
            const auto [other, is_new] = edge_before.emplace(edge_of(after.triangles[t], k), own);
            if (!is_new && other->second != own) ++count;
        }
    }
    return count;
}

// Topological invariants of a surface.
struct Topology {
    int euler = 0;           // Euler characteristic: vertices - edges + triangles
    int boundary_loops = 0;  // valid for a mesh without bow-tie vertices
};

inline Topology topology_of(const GarmentMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const GarmentTriangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::pair<int, int> ends = std::minmax({t.vertices[k], t.vertices[(k + 1) % 3]});
            ++edges[ends];
        }
    }
    Topology topology;
    topology.euler =
        static_cast<int>(mesh.x.size()) - static_cast<int>(edges.size()) + static_cast<int>(mesh.triangles.size());
    DisjointSets loops(mesh.x.size());  // directions change where a seam joins right side to wrong side
    std::set<int> on_boundary;
    for (const auto& [ends, count] : edges) {
        if (count != 1) continue;
        loops.join(ends.first, ends.second);
        on_boundary.insert({ends.first, ends.second});
    }
    for (const int v : on_boundary)
        topology.boundary_loops += on_boundary.contains(loops.find(v)) && loops.find(v) == v;
    return topology;
}

}  // namespace selvedge::sim
