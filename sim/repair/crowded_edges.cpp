#include "sim/repair/crowded_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "sim/core/disjoint_sets.h"
#include "sim/core/edge_table.h"

namespace selvedge::sim {
namespace {

using Triangles = std::vector<std::array<int, 3>>;
using EdgeSides = EdgeTable<int>::Edge;
using Side = TriangleSide<int>;

bool is_crowded(EdgeSides edge) {
    return edge.size() > 2;
}

void drop(Triangles& triangles, const std::set<int>& dropped) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (!dropped.contains(int(t))) triangles[kept++] = triangles[t];
    triangles.resize(kept);
}

// Fins: triangles with an open side that stand on an edge where, without them, an even number of triangles meets.
std::set<int> find_fins(const Triangles& triangles, const std::vector<EdgeSides>& edges) {
    std::vector<bool> is_open(triangles.size(), false);
    for (const EdgeSides edge : edges)
        if (edge.size() == 1) is_open[std::size_t(edge[0].triangle)] = true;
    std::set<int> fins;
    for (const EdgeSides edge : edges) {
        if (!is_crowded(edge)) continue;
        const auto open = std::count_if(edge.begin(), edge.end(),
                                        [&](const Side& side) { return is_open[std::size_t(side.triangle)]; });
        const auto rest = std::ptrdiff_t(edge.size()) - open;
        if (open == 0 || rest < 2 || rest % 2 != 0) continue;
        for (const Side& side : edge)
            if (is_open[std::size_t(side.triangle)]) fins.insert(side.triangle);
    }
    return fins;
}

// Six times the volume under all triangles, m^3: negative for a surface that faces inward.
double volume_under(const std::vector<Vec3d>& x, const Triangles& triangles) {
    const Vec3d& from = x[std::size_t(triangles.front()[0])];
    double sum = 0;
    for (const auto& [a, b, c] : triangles)
        sum += (x[std::size_t(a)] - from).dot((x[std::size_t(b)] - from).cross(x[std::size_t(c)] - from));
    return sum;
}

// A triangle beside an edge, seen along the edge from its high to its low vertex.
struct Leaf {
    double angle = 0;               // rad, counter-clockwise about the edge
    bool has_solid_behind = false;  // the solid lies counter-clockwise of it
    Side side;
};

std::vector<Leaf> leaves_about(EdgeSides edge, const std::vector<Vec3d>& x, const Triangles& triangles,
                               bool faces_outward) {
    const Vec3d& from = x[std::size_t(edge[0].low)];
    const Vec3d along = (x[std::size_t(edge[0].high)] - from).normalized();
    const Vec3d right = along.unitOrthogonal();
    std::vector<Leaf> leaves;
    for (const Side& side : edge) {
        const std::array<int, 3>& triangle = triangles[std::size_t(side.triangle)];
        const Vec3d to = x[std::size_t(triangle[std::size_t(side.k + 2) % 3])] - from;
        leaves.push_back({.angle = std::atan2(to.dot(along.cross(right)), to.dot(right)),
                          .has_solid_behind = side.rises != faces_outward,
                          .side = side});
    }
    std::stable_sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) { return a.angle < b.angle; });
    return leaves;
}

// Joins corners of triangles that stay connected across the surface. Corner k of triangle t has the index 3 t + k.
void join_across(const Side& a, const Side& b, DisjointSets& corners) {
    for (const bool at_low : {true, false})
        corners.join(3 * a.triangle + a.corner(at_low), 3 * b.triangle + b.corner(at_low));
}

// Joins each pair of leaves that have the solid between them, the outermost first: what is left lies inside the solid,
// as a wall across it does, and stays apart.
void join_pairs(const std::vector<Leaf>& leaves, DisjointSets& corners) {
    const std::size_t count = leaves.size();
    const auto begins = [&](std::size_t i) { return leaves[i % count].has_solid_behind; };
    std::size_t first = 0;
    while (first < count && !(begins(first) && !begins(first + count - 1))) ++first;
    if (first == count) return;
    for (std::size_t at = first; at < first + count;) {
        std::size_t middle = at;  // the first leaf that ends a solid
        while (begins(middle)) ++middle;
        std::size_t end = middle;
        while (end < first + count && !begins(end)) ++end;
        for (std::size_t i = 0; i < std::min(middle - at, end - middle); ++i)
            join_across(leaves[(at + i) % count].side, leaves[(end - 1 - i) % count].side, corners);
        at = end;
    }
}

// Gives each fan of joined triangles a vertex of its own at the ends of the crowded edges.
void part_vertices(std::vector<Vec3d>& x, std::vector<int>& origin, Triangles& triangles,
                   const std::vector<EdgeSides>& edges) {
    const bool faces_outward = volume_under(x, triangles) >= 0;
    DisjointSets corners(3 * triangles.size());
    std::set<int> parted;
    for (const EdgeSides edge : edges) {
        if (edge.size() == 2) join_across(edge[0], edge[1], corners);
        if (!is_crowded(edge)) continue;
        join_pairs(leaves_about(edge, x, triangles, faces_outward), corners);
        parted.insert({edge[0].low, edge[0].high});
    }
    std::map<int, int> vertex_of_fan;  // by the fan's first corner
    std::set<int> taken;               // vertices that one fan keeps
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            int& v = triangles[t][k];
            if (!parted.contains(v)) continue;
            const auto [fan, is_new] = vertex_of_fan.try_emplace(corners.find(int(3 * t + k)), v);
            if (is_new && !taken.insert(v).second) {
                fan->second = int(x.size());
                x.push_back(Vec3d(x[std::size_t(v)]));
                origin.push_back(int(origin[std::size_t(v)]));
            }
            v = fan->second;
        }
    }
}

// What no cut can part: edges of which both ends lie in one fan.
std::set<int> triangles_at_crowded_edges(const std::vector<EdgeSides>& edges) {
    std::set<int> found;
    for (const EdgeSides edge : edges)
        if (is_crowded(edge))
            for (const Side& side : edge) found.insert(side.triangle);
    return found;
}

}  // namespace

EdgeCuts cut_crowded_edges(std::vector<Vec3d>& x, std::vector<int>& origin,
                           std::vector<std::array<int, 3>>& triangles) {
    constexpr int kIterations = 8;  // of dropping fins that stand on fins; the rest goes with the edges
    EdgeCuts cuts;
    bool is_parted = false;
    for (int iteration = 0; !triangles.empty(); ++iteration) {
        const EdgeTable<int> table(triangles);
        const std::vector<EdgeSides> edges = table.edges();
        const auto first = std::find_if(edges.begin(), edges.end(), is_crowded);
        if (first == edges.end()) break;
        if (iteration == 0) {
            cuts.edges = int(std::count_if(edges.begin(), edges.end(), is_crowded));
            cuts.at = (x[std::size_t((*first)[0].low)] + x[std::size_t((*first)[0].high)]) / 2;
        }
        std::set<int> dropped;
        if (is_parted) dropped = triangles_at_crowded_edges(edges);
        if (!is_parted && iteration < kIterations) dropped = find_fins(triangles, edges);
        cuts.dropped += int(dropped.size());
        if (!dropped.empty()) {
            drop(triangles, dropped);
        } else {
            part_vertices(x, origin, triangles, edges);
            is_parted = true;
        }
    }
    return cuts;
}

}  // namespace selvedge::sim
