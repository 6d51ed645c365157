#include "editor/viewport3d/cloth_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

// One side of an edge, in the direction in which its triangle traverses it.
struct HalfEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    Vec2f u_from = Vec2f::Zero();
    Vec2f u_to = Vec2f::Zero();
    std::uint16_t panel = 0;
};

// Half-edges indexed by their start vertex.
class HalfEdges {
 public:
    HalfEdges(std::vector<HalfEdge> edges, std::size_t vertices) : edges_(std::move(edges)), first_(vertices + 1, 0) {
        for (const HalfEdge& edge : edges_) ++first_[edge.from + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        order_.resize(edges_.size());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < edges_.size(); ++i) order_[next[edges_[i].from]++] = i;
    }

    const std::vector<HalfEdge>& all() const { return edges_; }

    template <class Accept>
    std::optional<std::size_t> leaving(std::uint32_t vertex, Accept&& accept) const {
        for (std::size_t i = first_[vertex]; i < first_[vertex + 1]; ++i) {
            if (accept(order_[i])) return order_[i];
        }
        return std::nullopt;
    }

 private:
    std::vector<HalfEdge> edges_;
    std::vector<std::size_t> first_;
    std::vector<std::size_t> order_;
};

HalfEdges half_edges(const sim::DrawMesh& mesh) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint16_t panel = sim::panel_of(mesh, t);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            edges.push_back({mesh.triangles[t][i], mesh.triangles[t][j], mesh.u[t][i], mesh.u[t][j], panel});
        }
    }
    return {std::move(edges), mesh.x.size()};
}

// Half-edges without a triangle of the same panel on the other side. Comparing material coordinates detects a seam that
// joins a panel to itself.
HalfEdges boundary(const HalfEdges& edges, std::size_t vertices) {
    std::vector<HalfEdge> bounds;
    for (const HalfEdge& edge : edges.all()) {
        const auto is_other_side = [&](std::size_t i) {
            const HalfEdge& other = edges.all()[i];
            return other.to == edge.from && other.panel == edge.panel && other.u_from == edge.u_to &&
                   other.u_to == edge.u_from;
        };
        if (!edges.leaving(edge.to, is_other_side)) bounds.push_back(edge);
    }
    return {std::move(bounds), vertices};
}

struct Loop {
    std::vector<std::uint32_t> vertices;
    std::vector<Vec2f> u;
};

// Finds the longest boundary loop of each panel.
std::vector<Loop> loops_of_panels(const HalfEdges& bounds, std::size_t panels) {
    std::vector<Loop> longest(panels);
    std::vector<bool> is_taken(bounds.all().size(), false);
    for (std::size_t first = 0; first < bounds.all().size(); ++first) {
        Loop loop;
        const std::uint16_t panel = bounds.all()[first].panel;
        std::optional<std::size_t> at = is_taken[first] ? std::nullopt : std::optional(first);
        while (at) {
            is_taken[*at] = true;
            const HalfEdge& edge = bounds.all()[*at];
            loop.vertices.push_back(edge.from);
            loop.u.push_back(edge.u_from);
            at = bounds.leaving(edge.to, [&](std::size_t i) {
                const HalfEdge& next = bounds.all()[i];
                return !is_taken[i] && next.panel == panel && next.u_from == edge.u_to;
            });
        }
        if (panel < panels && loop.vertices.size() > longest[panel].vertices.size()) longest[panel] = std::move(loop);
    }
    return longest;
}

std::size_t nearest_on(const Loop& loop, const Vec2f& u) {
    const auto nearer = [&](const Vec2f& a, const Vec2f& b) { return (a - u).squaredNorm() < (b - u).squaredNorm(); };
    return static_cast<std::size_t>(std::min_element(loop.u.begin(), loop.u.end(), nearer) - loop.u.begin());
}

// Searches onward from `at` for the vertex near `u` whose distance along the loop matches `length`: an outline may pass
// the same position twice.
std::size_t next_start(const Loop& loop, std::size_t at, const Vec2f& u, double length) {
    constexpr double kWayWeight = 0.05;
    std::size_t best = at;
    double least = std::numeric_limits<double>::infinity(), way = 0;
    for (std::size_t step = 0; step < loop.u.size(); ++step) {
        const std::size_t i = (at + step) % loop.u.size();
        if (step > 0) way += static_cast<double>((loop.u[i] - loop.u[(i + loop.u.size() - 1) % loop.u.size()]).norm());
        const double cost = static_cast<double>((loop.u[i] - u).norm()) + kWayWeight * std::abs(way - length);
        if (cost < least) {
            least = cost;
            best = i;
        }
    }
    return best;
}

ClothOutline outline_of(const Loop& loop, const sim::Panel& panel) {
    ClothOutline outline{.vertices = loop.vertices, .starts = {}};
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        const Vec2f u = panel.vertices[static_cast<std::size_t>(panel.edges[e].start)].cast<float>();
        const std::size_t start =
            e == 0 ? nearest_on(loop, u)
                   : next_start(loop, outline.starts.back(), u, outline_length(panel, panel.edges[e - 1]));
        outline.starts.push_back(start);
    }
    return outline;
}

}  // namespace

std::vector<ClothOutline> find_outlines(const sim::DrawMesh& mesh, const sim::Pattern& pattern) {
    std::vector<ClothOutline> outlines(pattern.panels.size());
    if (mesh.u.size() != mesh.triangles.size() || mesh.panel_names.empty()) return outlines;
    const std::vector<Loop> loops = loops_of_panels(boundary(half_edges(mesh), mesh.x.size()), mesh.panel_names.size());
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const auto name = std::find(mesh.panel_names.begin(), mesh.panel_names.end(), pattern.panels[p].name);
        if (name == mesh.panel_names.end()) continue;
        const Loop& loop = loops[static_cast<std::size_t>(name - mesh.panel_names.begin())];
        if (!loop.vertices.empty()) outlines[p] = outline_of(loop, pattern.panels[p]);
    }
    return outlines;
}

std::vector<Vec3f> whole_path(const ClothOutline& outline, const std::vector<Vec3f>& x) {
    std::vector<Vec3f> path;
    for (const std::uint32_t v : outline.vertices) path.push_back(x[v]);
    path.push_back(x[outline.vertices.front()]);
    return path;
}

std::vector<Vec3f> edge_path(const ClothOutline& outline, std::size_t edge, const std::vector<Vec3f>& x) {
    std::vector<Vec3f> path;
    if (edge >= outline.starts.size()) return path;
    const std::size_t count = outline.vertices.size(), end = outline.starts[(edge + 1) % outline.starts.size()];
    for (std::size_t i = outline.starts[edge]; i != end; i = (i + 1) % count) path.push_back(x[outline.vertices[i]]);
    path.push_back(x[outline.vertices[end]]);
    return path;
}

const Vec3f& start_of(const ClothOutline& outline, std::size_t edge, const std::vector<Vec3f>& x) {
    return x[outline.vertices[outline.starts[edge % outline.starts.size()]]];
}

}  // namespace selvedge::editor
