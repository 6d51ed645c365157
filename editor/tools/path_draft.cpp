#include "editor/tools/path_draft.h"

#include <algorithm>
#include <cmath>

#include "editor/drafting/draft_error.h"
#include "editor/tools/overlay_parts.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

// Controls so that the curve passes through points at 1/2, or at 1/3 and 2/3.
OutlineEdge bent(int start, int end, const Vec2d& from, const Vec2d& to, const std::vector<Vec2d>& through) {
    OutlineEdge edge{.start = start, .end = end};
    if (through.size() == 1) {
        edge.kind = CurveKind::Quadratic;
        edge.control[0] = 2 * through[0] - (from + to) / 2;
    } else if (through.size() == 2) {
        edge.kind = CurveKind::Cubic;
        edge.control[0] = (-5 * from + 18 * through[0] - 9 * through[1] + 2 * to) / 6;
        edge.control[1] = (2 * from - 9 * through[0] + 18 * through[1] - 5 * to) / 6;
    }
    return edge;
}

struct Runs {
    std::vector<Vec2d> vertices;
    std::vector<std::vector<Vec2d>> through;  // after each vertex
};

Runs runs_of(const std::vector<PathPoint>& points) {
    Runs runs;
    for (const PathPoint& point : points) {
        if (point.is_curve && !runs.vertices.empty() && runs.through.back().size() < 2) {
            runs.through.back().push_back(point.at);
        } else {
            runs.vertices.push_back(point.at);
            runs.through.emplace_back();
        }
    }
    return runs;
}

Panel chained(const Runs& runs, bool is_closed) {
    Panel panel;
    panel.vertices = runs.vertices;
    const std::size_t edges = is_closed ? runs.vertices.size() : runs.vertices.size() - 1;
    for (std::size_t i = 0; i < edges; ++i) {
        const std::size_t next = (i + 1) % runs.vertices.size();
        panel.edges.push_back(
            bent(static_cast<int>(i), static_cast<int>(next), runs.vertices[i], runs.vertices[next], runs.through[i]));
    }
    return panel;
}

}  // namespace

void PathDraft::aim(const ToolContext& context, const SheetPointer& pointer) {
    SnapOptions options = snap_options(context, pointer.modifiers);
    for (const PathPoint& point : points_) options.more_points.push_back(point.at);
    if (!points_.empty()) options.origin = points_.back().at;
    aimed_ = snap(context.geometry, pointer.at, options);
    const bool has_length = context.typed && context.typed->size() == 1 && !points_.empty();
    const Vec2d away = has_length ? Vec2d(aimed_.point - points_.back().at) : Vec2d(0, 0);
    if (away.norm() > 0)
        aimed_ = {points_.back().at + context.typed->front() / 100 * away.normalized(), SnapKind::None, {}};
}

void PathDraft::add(bool is_curve) {
    const bool is_double = !points_.empty() && (points_.back().at - aimed_.point).norm() < 1e-5;
    if (!is_double) points_.push_back({aimed_.point, is_curve && !points_.empty()});
}

void PathDraft::add_at_length(double length) {
    if (points_.empty()) return;
    const Vec2d away = aimed_.point - points_.back().at;
    const Vec2d direction = away.norm() > 0 ? Vec2d(away.normalized()) : Vec2d(1, 0);
    points_.push_back({points_.back().at + length * direction, false});
}

bool PathDraft::remove_last() {
    if (points_.empty()) return false;
    points_.pop_back();
    return true;
}

std::vector<Vec2d> PathDraft::places() const {
    std::vector<Vec2d> places;
    for (const PathPoint& point : points_) places.push_back(point.at);
    return places;
}

bool PathDraft::is_closing(double tolerance) const {
    return points_.size() >= 3 && (points_.front().at - aimed_.point).norm() <= tolerance;
}

void PathDraft::draw(const ToolContext& context, ToolOverlay& overlay, bool is_closed) const {
    add_guides(overlay, aimed_);
    const bool is_closing_now = is_closed && is_closing(kPickTolerance * context.px);
    std::vector<PathPoint> shown = points_;
    if (!is_closing_now) shown.push_back({aimed_.point, false});
    if (points_.empty()) {
        overlay.handles.push_back({aimed_.point, HandleShape::Cross, OverlayTone::Draft, false});
        return;
    }
    if (is_closed && points_.size() > 1) {
        overlay.lines.push_back(
            {.points = polyline_through(shown, true), .tone = OverlayTone::Faint, .is_closed = true});
    }
    overlay.lines.push_back({.points = polyline_through(shown, is_closing_now)});
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const bool is_first = is_closed && i == 0;
        overlay.handles.push_back({points_[i].at,
                                   points_[i].is_curve || is_first ? HandleShape::Round : HandleShape::Square,
                                   OverlayTone::Draft, is_first && is_closing_now});
    }
    const Vec2d away = aimed_.point - points_.back().at;
    if (away.norm() == 0) return;
    overlay.handles.push_back({aimed_.point, HandleShape::Square, OverlayTone::Draft, true});
    if (points_.size() > 1) {
        const Vec2d before = points_.back().at - points_[points_.size() - 2].at;
        const double turn = std::atan2(cross2(before, away), before.dot(away));
        overlay.readout = {in_cm(away.norm()), "turn " + in_degrees(turn)};
    } else {
        overlay.readout = {in_cm(away.norm()), in_degrees(std::atan2(away.y(), away.x()))};
    }
}

Panel outline_through(std::vector<PathPoint> points) {
    const auto first = std::find_if(points.begin(), points.end(), [](const PathPoint& p) { return !p.is_curve; });
    if (first != points.end()) std::rotate(points.begin(), first, points.end());
    const auto panel_of = [](const std::vector<PathPoint>& given) { return chained(runs_of(given), true); };
    if (points.size() < 3 || runs_of(points).vertices.size() < 2) {
        throw DraftError("A panel needs three points at least");
    }
    Panel panel = panel_of(points);
    if (outline_area(panel) < 0) {
        std::reverse(points.begin() + 1, points.end());
        panel = panel_of(points);
    }
    SheetBox box;
    for (const Vec2d& vertex : panel.vertices) box.extend(vertex);
    const Vec2d middle = box.center();
    for (Vec2d& vertex : panel.vertices) vertex -= middle;
    for (OutlineEdge& edge : panel.edges) {
        for (int c = 0; c < control_count(edge.kind); ++c) edge.control[static_cast<std::size_t>(c)] -= middle;
    }
    panel.name = "panel";
    panel.sheet_position = middle;
    return panel;
}

std::vector<Vec2d> polyline_through(const std::vector<PathPoint>& points, bool is_closed) {
    std::vector<Vec2d> line;
    if (points.empty()) return line;
    std::vector<PathPoint> shown = points;
    if (!is_closed) shown.back().is_curve = false;
    const Panel panel = chained(runs_of(shown), is_closed);
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> part = outline_polyline(panel, edge, kShapeError * 4);
        line.insert(line.end(), part.begin(), part.end() - 1);
    }
    if (!is_closed || panel.edges.empty()) line.push_back(panel.vertices.back());
    if (is_closed) line.push_back(panel.vertices.front());
    return line;
}

Panel placed_before_body(const Pattern& pattern, Panel panel) {
    constexpr double kChest = 0.7;    // of the stature
    constexpr double kBefore = 0.35;  // m, before the body's middle
    constexpr double kLayer = 0.02;   // m, each one before the others
    panel.translation =
        Vec3d(0, kChest * pattern.body_height, kBefore + kLayer * static_cast<double>(pattern.panels.size()));
    return panel;
}

}  // namespace selvedge
