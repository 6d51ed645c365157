#include "render/marks/seam_lines.h"

#include <algorithm>
#include <compare>
#include <map>

#include "render/draw/cloth_vertices.h"

namespace selvedge::render {
namespace {

using Panels = std::array<std::uint16_t, 2>;

// One triangle's side of a marked edge, identified by the edge's vertices in ascending order.
struct MarkedSide {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint16_t panel = 0;

    auto operator<=>(const MarkedSide&) const = default;
};

struct MarkedEdge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    bool is_taken = false;

    std::uint32_t other(std::uint32_t vertex) const { return vertex == low ? high : low; }
};

using EdgesOfPanels = std::map<Panels, std::vector<MarkedEdge>>;

EdgesOfPanels marked_edges(const sim::PlainMesh& mesh, const std::vector<TriangleMarks>& marks,
                           std::uint32_t TriangleMarks::*kind) {
    std::vector<MarkedSide> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint16_t panel = mesh.panel.empty() ? std::uint16_t{0} : mesh.panel[t];
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if ((marks[t].*kind >> edge & 1U) == 0) continue;
            const auto [low, high] = std::minmax(mesh.triangles[t][(edge + 1) % 3], mesh.triangles[t][(edge + 2) % 3]);
            sides.push_back({low, high, panel});
        }
    }
    std::sort(sides.begin(), sides.end());
    EdgesOfPanels edges;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const bool is_second = i > 0 && sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high;
        const bool has_second =
            i + 1 < sides.size() && sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high;
        if (!is_second) {
            const std::uint16_t other = has_second ? sides[i + 1].panel : sides[i].panel;
            edges[{sides[i].panel, other}].push_back({sides[i].low, sides[i].high});
        }
    }
    return edges;
}

// Walks along edges that are not taken yet, and marks them as taken.
class Walker {
 public:
    Walker(const sim::PlainMesh& mesh, std::vector<MarkedEdge>& edges) : mesh_(mesh), edges_(edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            at_[edges[i].low].push_back(i);
            at_[edges[i].high].push_back(i);
        }
    }

    // All lines. Each starts at its smallest end vertex, or at its smallest vertex if it has no end.
    std::vector<SeamLine> lines(const Panels& panels) {
        std::vector<SeamLine> found;
        for (const auto& [vertex, edges] : at_) {
            if (std::all_of(edges.begin(), edges.end(), [&](std::size_t e) { return edges_[e].is_taken; })) continue;
            found.push_back(line_through(vertex));
            found.back().panels = panels;
        }
        return found;
    }

 private:
    SeamLine line_through(std::uint32_t vertex) {
        const std::vector<std::uint32_t> connected_vertices = connected(vertex);
        SeamLine line;
        for (const bool starts_at_ends : {true, false}) {
            for (const std::uint32_t v : connected_vertices) {
                if (starts_at_ends && at_[v].size() == 2) continue;
                for (VertexPath path = walk(v, line.length); path.size() > 1; path = walk(v, line.length))
                    line.paths.push_back(path);
            }
        }
        return line;
    }

    std::vector<std::uint32_t> connected(std::uint32_t from) {
        std::vector<std::uint32_t> connected_vertices{from};
        for (std::size_t i = 0; i < connected_vertices.size(); ++i) {
            for (const std::size_t e : at_[connected_vertices[i]]) {
                const std::uint32_t next = edges_[e].other(connected_vertices[i]);
                if (reached_.emplace(next, true).second && next != from) connected_vertices.push_back(next);
            }
        }
        std::sort(connected_vertices.begin(), connected_vertices.end());
        return connected_vertices;
    }

    VertexPath walk(std::uint32_t vertex, double& length) {
        VertexPath path{vertex};
        while (true) {
            const std::vector<std::size_t>& edges = at_[vertex];
            const auto free =
                std::find_if(edges.begin(), edges.end(), [&](std::size_t e) { return !edges_[e].is_taken; });
            if (free == edges.end()) return path;
            edges_[*free].is_taken = true;
            const std::uint32_t next = edges_[*free].other(vertex);
            length += static_cast<double>((mesh_.x[next] - mesh_.x[vertex]).norm());
            path.push_back(next);
            vertex = next;
            if (at_[vertex].size() != 2) return path;
        }
    }

    const sim::PlainMesh& mesh_;
    std::vector<MarkedEdge>& edges_;
    std::map<std::uint32_t, std::vector<std::size_t>> at_;
    std::map<std::uint32_t, bool> reached_;
};

std::vector<SeamLine> lines_of(const sim::PlainMesh& mesh, EdgesOfPanels all) {
    std::vector<SeamLine> lines;
    for (auto& [panels, edges] : all) {
        std::vector<SeamLine> found = Walker(mesh, edges).lines(panels);
        std::move(found.begin(), found.end(), std::back_inserter(lines));
    }
    return lines;
}

}  // namespace

SeamLines find_seam_lines(const sim::PlainMesh& mesh) {
    const std::vector<TriangleMarks> marks = mark_edges(mesh);
    return {.seams = lines_of(mesh, marked_edges(mesh, marks, &TriangleMarks::seam)),
            .hems = lines_of(mesh, marked_edges(mesh, marks, &TriangleMarks::hem))};
}

}  // namespace selvedge::render
