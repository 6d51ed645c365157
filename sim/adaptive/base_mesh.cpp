// Building the adaptive mesh's level 0 from a sewn garment.
#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/error.h"
#include "sim/mesh/seam_geometry.h"

namespace selvedge {
namespace {

// One side of a base edge: the corner of a triangle at which the edge starts, running anticlockwise.
struct BaseSide {
    int low = 0;  // the edge's vertices
    int high = 0;
    std::uint32_t triangle = 0;
    std::size_t corner = 0;
    bool rises = false;  // runs from low to high

    bool is_of_same_edge(const BaseSide& other) const { return low == other.low && high == other.high; }
    auto key() const { return std::tuple(low, high, triangle, corner); }
};

std::vector<BaseSide> sides_by_edge(const GarmentMesh& base) {
    std::vector<BaseSide> sides;
    sides.reserve(3 * base.triangles.size());
    for (std::uint32_t t = 0; t < base.triangles.size(); ++t) {
        const std::array<int, 3>& v = base.triangles[t].vertices;
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = v[k], to = v[(k + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), t, k, from < to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const BaseSide& a, const BaseSide& b) { return a.key() < b.key(); });
    return sides;
}

void require_manifold(std::span<const BaseSide> edge) {
    const std::string place = "edge " + std::to_string(edge[0].low) + "-" + std::to_string(edge[0].high);
    if (edge[0].low == edge[0].high) throw InputError("", place, "both ends are the same vertex");
    if (edge.size() > 2) throw InputError("", place, "is shared by " + std::to_string(edge.size()) + " triangles");
    if (edge.size() == 2 && edge[0].rises == edge[1].rises) {
        throw InputError("", place, "its two triangles face opposite ways");
    }
}

AdaptiveTriangle make_base_triangle(const GarmentTriangle& from) {
    SELVEDGE_ASSERT(from.panel >= 0 && from.panel <= 0xFFFF);
    AdaptiveTriangle triangle;
    triangle.panel = static_cast<std::uint16_t>(from.panel);
    for (std::size_t k = 0; k < 3; ++k) {
        triangle.vertices[k] = VertexId(static_cast<std::uint32_t>(from.vertices[k]));
        triangle.u[k] = from.u[k].cast<float>();
    }
    return triangle;
}

double side_length(const GarmentMesh& base, const BaseSide& side) {
    const std::array<Vec2d, 3>& u = base.triangles[side.triangle].u;
    return (u[(side.corner + 1) % 3] - u[side.corner]).norm();
}

double edge_length(const GarmentMesh& base, std::span<const BaseSide> edge, double seam_ease) {
    const double length = side_length(base, edge.front());
    if (edge.size() == 1) return length;
    return seam_rest_length(length, side_length(base, edge.back()), {.ease = seam_ease});
}

}  // namespace

AdaptiveMesh::AdaptiveMesh(const GarmentMesh& base, const AdaptiveMeshOptions& options)
    : options_(options), base_vertices_(base.x.size()), base_triangles_(base.triangles.size()) {
    SELVEDGE_ASSERT(base.links.empty());
    SELVEDGE_ASSERT(options.max_level >= 0 && options.max_level <= kDeepestLevel);
    for (std::size_t i = 0; i < base_vertices_; ++i) vertices_.create({});
    for (const GarmentTriangle& triangle : base.triangles) triangles_.create(make_base_triangle(triangle));
    add_base_edges(base);
    add_base_fans();
    levels_.set_deepest(options.max_level);
    grow_lists();
    list_base();
    refresh_lists();
}

void AdaptiveMesh::list_base() {
    for (std::uint32_t i = 0; i < base_vertices_; ++i) keeper_.note(VertexId(i));
    for (std::uint32_t i = 0; i < base_edges_; ++i) keeper_.note(EdgeId(i));
    for (std::uint32_t i = 0; i < base_triangles_; ++i) keeper_.note(TriangleId(i));
    for (std::uint32_t i = 0; i < base_edges_; ++i) levels_.add_unsplit(0, EdgeId(i));
}

// A corner starts a fan when no triangle lies clockwise of it; in a fan that closes, its lowest triangle does.
void AdaptiveMesh::add_base_fans() {
    const auto clockwise_of = [&](TriangleId id, VertexId v) {
        const AdaptiveTriangle& t = triangles_[id];
        const std::size_t k = corner_at(t, v);
        const AdaptiveEdge& edge = edges_[t.edges[k]];
        return edge.sides[edge.ends[0] == v ? 1 : 0];
    };
    const auto starts_fan = [&](TriangleId first, VertexId v) {
        TriangleId t = clockwise_of(first, v);
        while (t && t > first) t = clockwise_of(t, v);
        return !t ? !clockwise_of(first, v) : t == first;
    };
    std::vector<std::pair<VertexId, TriangleId>> found;
    for (std::uint32_t i = 0; i < base_triangles_; ++i) {
        for (const VertexId v : triangles_[TriangleId(i)].vertices) {
            if (starts_fan(TriangleId(i), v)) found.emplace_back(v, TriangleId(i));
        }
    }
    std::sort(found.begin(), found.end());
    fan_starts_.assign(base_vertices_ + 1, 0);
    for (const auto& [v, t] : found) {
        fans_.push_back(t);
        ++fan_starts_[v.value + 1];
    }
    std::partial_sum(fan_starts_.begin(), fan_starts_.end(), fan_starts_.begin());
}

void AdaptiveMesh::add_base_edges(const GarmentMesh& base) {
    const std::vector<BaseSide> sides = sides_by_edge(base);
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first;
        while (last < sides.size() && sides[last].is_of_same_edge(sides[first])) ++last;
        const std::span<const BaseSide> edge(sides.data() + first, last - first);
        require_manifold(edge);
        AdaptiveEdge made;
        made.ends = {VertexId(static_cast<std::uint32_t>(edge[0].low)),
                     VertexId(static_cast<std::uint32_t>(edge[0].high))};
        made.rest_length = static_cast<float>(edge_length(base, edge, options_.seam_ease));
        for (const BaseSide& side : edge) made.sides[side.rises ? 0 : 1] = TriangleId(side.triangle);
        const EdgeId id = edges_.create(made);
        for (const BaseSide& side : edge) triangles_[TriangleId(side.triangle)].edges[side.corner] = id;
        first = last;
    }
    base_edges_ = edges_.size();
}

}  // namespace selvedge
