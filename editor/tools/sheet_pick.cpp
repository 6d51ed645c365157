#include "editor/tools/sheet_pick.h"

#include <algorithm>

#include "sim/pattern/segment_distance.h"

namespace selvedge::editor {
namespace {

// Keeps the best candidate: the kind with the higher priority, then the nearer.
class Best {
 public:
    explicit Best(double tolerance) : tolerance_(tolerance) {}

    void offer(const Pick& offered, double distance) {
        if (distance > tolerance_) return;
        const bool is_smaller = pick_.kind == PickKind::Nothing || offered.kind < pick_.kind;
        if (!is_smaller && (offered.kind != pick_.kind || distance > distance_)) return;
        pick_ = offered;
        distance_ = distance;
    }

    const Pick& pick() const { return pick_; }

 private:
    double tolerance_;
    double distance_ = 0;
    Pick pick_;
};

void offer_points(const PanelShape& shape, const Vec2d& u, const PickOptions& options, Best& best) {
    const sim::Panel& panel = shape.panel;
    if (options.vertices) {
        for (std::size_t i = 0; i < panel.vertices.size(); ++i) {
            best.offer({PickKind::Vertex, panel.name, static_cast<int>(i), 0, 0, shape.on_sheet(panel.vertices[i])},
                       (panel.vertices[i] - u).norm());
        }
    }
    if (options.notches) {
        for (std::size_t i = 0; i < panel.notches.size(); ++i) {
            const sim::Notch& notch = panel.notches[i];
            if (notch.edge < 0 || static_cast<std::size_t>(notch.edge) >= shape.edges.size()) continue;
            const Vec2d point = shape.edges[static_cast<std::size_t>(notch.edge)].at(notch.t);
            best.offer({PickKind::Notch, panel.name, static_cast<int>(i), 0, notch.t, shape.on_sheet(point)},
                       (point - u).norm());
        }
    }
}

void offer_handles(const PanelShape& shape, const Vec2d& u, const PickOptions& options, Best& best) {
    for (const PartRef& ref : options.handle_edges) {
        if (ref.panel != shape.panel.name) continue;
        if (ref.index < 0 || static_cast<std::size_t>(ref.index) >= shape.panel.edges.size()) continue;
        const sim::OutlineEdge& edge = shape.panel.edges[static_cast<std::size_t>(ref.index)];
        for (int c = 0; c < control_count(edge.kind); ++c) {
            const Vec2d& point = edge.control[static_cast<std::size_t>(c)];
            best.offer({PickKind::Handle, ref.panel, ref.index, c, 0, shape.on_sheet(point)}, (point - u).norm());
        }
    }
}

void offer_lines(const PanelShape& shape, const Vec2d& u, const PickOptions& options, Best& best) {
    if (options.edges) {
        for (std::size_t i = 0; i < shape.edges.size(); ++i) {
            if (shape.edges[i].box.exteriorDistance(u) > options.tolerance) continue;
            const EdgeHit hit = nearest(shape.edges[i], u);
            best.offer({PickKind::Edge, shape.panel.name, static_cast<int>(i), 0, hit.t, shape.on_sheet(hit.point)},
                       hit.distance);
        }
    }
    if (!options.internal_lines) return;
    for (std::size_t i = 0; i < shape.panel.internal_lines.size(); ++i) {
        const std::vector<Vec2d>& points = shape.panel.internal_lines[i].points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            best.offer({PickKind::InternalLine, shape.panel.name, static_cast<int>(i), 0, 0, shape.on_sheet(u)},
                       sim::distance_to_segment(u, points[k], points[k + 1]));
        }
    }
}

bool segment_meets_box(const Vec2d& a, const Vec2d& b, const SheetBox& box) {
    if (box.contains(a) || box.contains(b)) return true;
    double from = 0, to = 1;  // parameter range inside all slabs so far
    for (int axis = 0; axis < 2; ++axis) {
        const double along = b[axis] - a[axis];
        if (along == 0) {
            if (a[axis] < box.min()[axis] || a[axis] > box.max()[axis]) return false;
            continue;
        }
        const double first = (box.min()[axis] - a[axis]) / along;
        const double second = (box.max()[axis] - a[axis]) / along;
        from = std::max(from, std::min(first, second));
        to = std::min(to, std::max(first, second));
    }
    return from <= to;
}

bool edge_is_in(const EdgeShape& edge, const SheetBox& box, BoxRule rule) {
    if (rule == BoxRule::Inside) return box.contains(edge.box);
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
        if (segment_meets_box(edge.points[i], edge.points[i + 1], box)) return true;
    }
    return false;
}

bool panel_is_in(const PanelShape& shape, const SheetBox& box, BoxRule rule) {
    if (shape.box.isEmpty()) return false;
    if (rule == BoxRule::Inside) return box.contains(shape.box);
    if (!box.intersects(shape.box)) return false;
    return shape.contains(box.center()) ||
           std::any_of(shape.edges.begin(), shape.edges.end(),
                       [&](const EdgeShape& edge) { return edge_is_in(edge, box, rule); });
}

}  // namespace

int control_count(sim::CurveKind kind) {
    return kind == sim::CurveKind::Quadratic ? 1 : kind == sim::CurveKind::Cubic ? 2 : 0;
}

Pick pick(const SheetGeometry& geometry, const Vec2d& sheet, const PickOptions& options) {
    Best best(options.tolerance);
    for (const PanelShape& shape : geometry.panels()) {
        if (!shape.may_be_picked) continue;
        const Vec2d u = shape.in_panel(sheet);
        offer_handles(shape, u, options, best);
        if (shape.box.isEmpty() || shape.box.exteriorDistance(u) > options.tolerance) continue;
        offer_points(shape, u, options, best);
        offer_lines(shape, u, options, best);
        if (options.panels && shape.contains(u)) {
            best.offer({PickKind::Panel, shape.panel.name, 0, 0, 0, sheet}, 0);
        }
    }
    return best.pick();
}

Hover hover_of(const SheetGeometry& geometry, const Pick& picked) {
    Hover hover;
    hover.panel = picked.panel;
    switch (picked.kind) {
        case PickKind::Vertex:
            hover.vertex = picked.ref();
            break;
        case PickKind::Notch:
            hover.notch = picked.ref();
            break;
        case PickKind::Handle:
        case PickKind::Edge:
            hover.edge = picked.ref();
            hover.seam = geometry.seam_of(picked.ref());
            break;
        case PickKind::InternalLine:
            hover.internal_line = picked.ref();
            break;
        case PickKind::Panel:
        case PickKind::Nothing:
            break;
    }
    return hover;
}

Selection in_box(const SheetGeometry& geometry, const SheetBox& box, BoxRule rule, BoxTargets targets) {
    Selection found;
    if (box.isEmpty()) return found;
    for (const PanelShape& shape : geometry.panels()) {
        if (!shape.may_be_picked) continue;
        const SheetBox here(box.min() - shape.origin, box.max() - shape.origin);
        const std::string& name = shape.panel.name;
        if (targets == BoxTargets::Panels) {
            if (panel_is_in(shape, here, rule)) found.panels.insert(name);
            continue;
        }
        if (!here.intersects(shape.box)) continue;
        if (targets == BoxTargets::Vertices) {
            for (std::size_t i = 0; i < shape.panel.vertices.size(); ++i) {
                if (here.contains(shape.panel.vertices[i])) found.vertices.insert({name, static_cast<int>(i)});
            }
        } else {
            for (std::size_t i = 0; i < shape.edges.size(); ++i) {
                if (edge_is_in(shape.edges[i], here, rule)) found.edges.insert({name, static_cast<int>(i)});
            }
        }
    }
    return found;
}

}  // namespace selvedge::editor
