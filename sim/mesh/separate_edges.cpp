#include "sim/mesh/separate_edges.h"

#include <algorithm>
#include <map>
#include <utility>

#include "sim/mesh/linked_vertices.h"

namespace selvedge {
namespace {

constexpr int kMostRounds = 8;  // two are enough for any complex whose outline edges are apart

using EdgeEnds = std::pair<int, int>;  // lower vertex first

EdgeEnds ends(int a, int b) {
    return std::minmax({a, b});
}

EdgeEnds edge_of(const GarmentTriangle& triangle, std::size_t k) {
    return ends(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
}

std::map<EdgeEnds, int> count_triangles_at_edges(const GarmentMesh& mesh) {
    std::map<EdgeEnds, int> uses;
    for (const GarmentTriangle& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++uses[edge_of(triangle, k)];
    }
    return uses;
}

// The inner edges that sewing would lay on another edge or shrink to a point.
std::vector<EdgeEnds> find_coinciding(const GarmentMesh& unsewn) {
    const std::vector<int> lead = leads_of_linked(unsewn);
    const auto lead_of = [&](int vertex) { return lead[static_cast<std::size_t>(vertex)]; };
    const std::map<EdgeEnds, int> uses = count_triangles_at_edges(unsewn);
    std::map<EdgeEnds, int> sewn;  // how many unsewn edges become this one
    for (const auto& [edge, count] : uses) ++sewn[ends(lead_of(edge.first), lead_of(edge.second))];
    std::vector<EdgeEnds> coinciding;
    for (const auto& [edge, count] : uses) {
        if (count < 2) continue;
        const EdgeEnds merged = ends(lead_of(edge.first), lead_of(edge.second));
        if (merged.first == merged.second || sewn[merged] > 1) coinciding.push_back(edge);
    }
    return coinciding;
}

struct CornerPoint {
    int vertex = 0;
    Vec2d u = Vec2d::Zero();
};

using Middles = std::map<EdgeEnds, int>;

// A triangle's corners, and the middles of those of its edges that are split.
struct SplitTriangle {
    std::array<CornerPoint, 3> corner;
    std::array<CornerPoint, 3> middle;  // middle[k] halves the edge from corner k to the next; vertex -1: not split
    int panel = 0;
};

SplitTriangle with_middles(const GarmentTriangle& triangle, const Middles& middles) {
    SplitTriangle split;
    split.panel = triangle.panel;
    for (std::size_t k = 0; k < 3; ++k) {
        split.corner[k] = {triangle.vertices[k], triangle.u[k]};
        const auto found = middles.find(edge_of(triangle, k));
        const int vertex = found == middles.end() ? -1 : found->second;
        split.middle[k] = {vertex, 0.5 * (triangle.u[k] + triangle.u[(k + 1) % 3])};
    }
    return split;
}

void add_triangle(std::vector<GarmentTriangle>& out, int panel, const CornerPoint& a, const CornerPoint& b,
                  const CornerPoint& c) {
    out.push_back({{a.vertex, b.vertex, c.vertex}, {a.u, b.u, c.u}, panel});
}

// Triangles that conform to the split edges (SPEC 1.2: C1..C3; C4 or C5 by the shorter diagonal; C10).
void add_parts(std::vector<GarmentTriangle>& out, SplitTriangle t) {
    const auto is_split = [](const CornerPoint& middle) { return middle.vertex >= 0; };
    const auto count = std::ranges::count_if(t.middle, is_split);
    const auto turn = [&] {
        std::ranges::rotate(t.corner, t.corner.begin() + 1);
        std::ranges::rotate(t.middle, t.middle.begin() + 1);
    };
    if (count == 1) {
        while (!is_split(t.middle[0])) turn();
        add_triangle(out, t.panel, t.corner[0], t.middle[0], t.corner[2]);
        add_triangle(out, t.panel, t.middle[0], t.corner[1], t.corner[2]);
    } else if (count == 2) {
        while (is_split(t.middle[2])) turn();
        add_triangle(out, t.panel, t.middle[0], t.corner[1], t.middle[1]);
        if ((t.middle[0].u - t.corner[2].u).norm() <= (t.corner[0].u - t.middle[1].u).norm()) {
            add_triangle(out, t.panel, t.corner[0], t.middle[0], t.corner[2]);
            add_triangle(out, t.panel, t.middle[0], t.middle[1], t.corner[2]);
        } else {
            add_triangle(out, t.panel, t.corner[0], t.middle[0], t.middle[1]);
            add_triangle(out, t.panel, t.corner[0], t.middle[1], t.corner[2]);
        }
    } else if (count == 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            add_triangle(out, t.panel, t.corner[k], t.middle[k], t.middle[(k + 2) % 3]);
        }
        add_triangle(out, t.panel, t.middle[0], t.middle[1], t.middle[2]);
    } else {
        add_triangle(out, t.panel, t.corner[0], t.corner[1], t.corner[2]);
    }
}

void split_edges(GarmentMesh& mesh, const std::vector<EdgeEnds>& edges) {
    Middles middles;
    for (const EdgeEnds& edge : edges) {
        middles[edge] = static_cast<int>(mesh.x.size());
        const Vec3d middle =
            0.5 * (mesh.x[static_cast<std::size_t>(edge.first)] + mesh.x[static_cast<std::size_t>(edge.second)]);
        mesh.x.push_back(middle);
    }
    std::vector<GarmentTriangle> triangles;
    for (const GarmentTriangle& triangle : mesh.triangles) add_parts(triangles, with_middles(triangle, middles));
    mesh.triangles = std::move(triangles);
}

}  // namespace

int separate_coinciding_edges(GarmentMesh& unsewn) {
    int split = 0;
    for (int round = 0; round < kMostRounds; ++round) {
        const std::vector<EdgeEnds> edges = find_coinciding(unsewn);
        if (edges.empty()) break;
        split_edges(unsewn, edges);
        split += static_cast<int>(edges.size());
    }
    return split;
}

}  // namespace selvedge
