#include "editor/geometry/outline_edit.h"

#include <algorithm>
#include <cmath>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

// Joins the edges around each run of marked vertices to one edge.
class VertexRemover {
 public:
    VertexRemover(sim::Pattern& draft, int panel, const std::vector<int>& vertices)
        : draft_(draft), panel_(panel), going_(draft.panels.size()), is_marked_(own().vertices.size(), false) {
        for (const int vertex : vertices) is_marked_[as_size(vertex)] = true;
        going_[as_size(panel)] = vertices;
    }

    void remove() {
        const auto is_kept = [&](const sim::OutlineEdge& edge) { return !is_marked_[as_size(edge.start)]; };
        if (std::count_if(own().edges.begin(), own().edges.end(), is_kept) < 2) {
            throw GeometryError("Panel " + own().name + " would have no area.", {{own().name, -1, -1}});
        }
        while (join_one_run()) continue;
        for (std::size_t i = 0; i < going_.size(); ++i) {
            drop_unused(draft_.panels[i], going_[i]);
        }
    }

 private:
    const sim::Panel& own() const { return draft_.panels[as_size(panel_)]; }

    bool join_one_run() {
        const std::vector<sim::OutlineEdge>& edges = own().edges;
        const auto is_run_start = [&](const sim::OutlineEdge& edge) {
            return !is_marked_[as_size(edge.start)] && is_marked_[as_size(edge.end)];
        };
        const auto found = std::find_if(edges.begin(), edges.end(), is_run_start);
        if (found == edges.end()) return false;
        const int first = static_cast<int>(found - edges.begin());
        int count = 1;
        while (is_marked_[as_size(edges[as_size((first + count - 1) % edge_count(own()))].end)]) ++count;
        join_sewn(draft_, panel_, first, count, [&](int panel, int vertex) { return may_join(panel, vertex); });
        return true;
    }

    bool may_join(int panel, int vertex) {
        if (panel == panel_) return is_marked_[as_size(vertex)];
        if (!is_smooth(draft_.panels[as_size(panel)], vertex)) return false;
        going_[as_size(panel)].push_back(vertex);
        return true;
    }

    sim::Pattern& draft_;
    int panel_;
    std::vector<std::vector<int>> going_;  // vertices to remove, per panel
    std::vector<bool> is_marked_;          // per vertex of panel_
};

sim::VertexMove move_of(const sim::Panel& panel, const std::vector<int>& vertices, const Eigen::Affine2d& map) {
    expect_vertices(panel, vertices);
    sim::VertexMove move{std::vector<bool>(panel.vertices.size(), false), map};
    for (const int vertex : vertices) move.is_moved[as_size(vertex)] = true;
    return move;
}

}  // namespace

std::optional<int> panel_index(const sim::Pattern& pattern, const std::string& name) {
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        if (pattern.panels[i].name == name) return static_cast<int>(i);
    }
    return std::nullopt;
}

int find_panel(const sim::Pattern& pattern, const std::string& name) {
    if (const std::optional<int> index = panel_index(pattern, name)) return *index;
    throw GeometryError("There is no panel " + name + ".");
}

int split_edge(sim::Pattern& pattern, sim::SeamSide at, double t) {
    edge_of(pattern, at);
    if (!(t > 0 && t < 1)) {
        throw GeometryError("A new point lies between the ends of its edge.", {place_of(pattern, at)});
    }
    return edit_pattern(pattern, [&](sim::Pattern& draft) { return split_sewn(draft, at, t); });
}

void remove_vertices(sim::Pattern& pattern, int panel, std::vector<int> vertices) {
    expect_vertices(panel_of(pattern, panel), vertices);
    edit_pattern(pattern, [&](sim::Pattern& draft) { VertexRemover(draft, panel, vertices).remove(); });
}

void move_vertices(sim::Pattern& pattern, int panel, const std::vector<int>& vertices, const Vec2d& by) {
    transform_vertices(pattern, panel, vertices, Eigen::Affine2d(Eigen::Translation2d(by)));
}

void transform_vertices(sim::Pattern& pattern, int panel, const std::vector<int>& vertices,
                        const Eigen::Affine2d& map) {
    const sim::VertexMove move = move_of(panel_of(pattern, panel), vertices, map);
    edit_pattern(pattern, [&](sim::Pattern& draft) { move_outline(draft.panels[as_size(panel)], move); });
}

void transform_panel(sim::Pattern& pattern, int panel, const Eigen::Affine2d& map) {
    panel_of(pattern, panel);
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        sim::Panel& own = draft.panels[as_size(panel)];
        own = mapped_panel(own, map);
        if (map.linear().determinant() >= 0) return;
        remap_edges(draft, panel, [&](int edge) {
            return EdgeImage{{panel, sim::mirrored_edge(edge, edge_count(own))}, true};
        });
    });
}

namespace {

// Without what its kind of curve does not use.
sim::OutlineEdge only_used(sim::OutlineEdge edge) {
    const bool is_bezier = edge.kind == sim::CurveKind::Quadratic || edge.kind == sim::CurveKind::Cubic;
    if (!is_bezier) edge.control = sim::OutlineEdge().control;
    if (edge.kind == sim::CurveKind::Quadratic) edge.control[1] = Vec2d::Zero();
    if (edge.kind != sim::CurveKind::Arc) {
        edge.arc_radius = 0;
        edge.is_large_arc = edge.turns_right = false;
    }
    return edge;
}

}  // namespace

void set_curve(sim::Pattern& pattern, sim::SeamSide at, const sim::OutlineEdge& curve) {
    edge_of(pattern, at);
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        sim::OutlineEdge& edge = edge_of(draft, at);
        sim::OutlineEdge changed = only_used(curve);
        changed.start = edge.start;
        changed.end = edge.end;
        keep_properties(changed, edge);
        edge = changed;
    });
}

}  // namespace selvedge::editor
