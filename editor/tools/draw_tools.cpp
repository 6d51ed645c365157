#include "editor/tools/draw_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "editor/geometry/draft.h"
#include "editor/geometry/panel_edit.h"
#include "editor/tools/outline_tools.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/tool.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

// The panel under the point; of several, the one drawn last. nullptr: none.
const PanelShape* panel_at(const SheetGeometry& geometry, const Vec2d& sheet) {
    const PanelShape* found = nullptr;
    for (const PanelShape& shape : geometry.panels()) {
        if (shape.may_be_picked && shape.contains(shape.in_panel(sheet))) found = &shape;
    }
    return found;
}

// The panel that the path runs through. Throws GeometryError with this text if there is none.
const PanelShape& panel_under(const SheetGeometry& geometry, const std::vector<Vec2d>& path, const char* otherwise) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (const PanelShape* shape = panel_at(geometry, (path[i] + path[i + 1]) / 2)) return *shape;
    }
    throw GeometryError(otherwise);
}

std::vector<Vec2d> in_panel(const PanelShape& shape, std::vector<Vec2d> path) {
    for (Vec2d& point : path) point = shape.in_panel(point);
    return path;
}

bool is_enter(Key key) {
    return key == Key::Enter || key == Key::KeypadEnter;
}

}  // namespace

// --- paths

void PathTool::hover(ToolContext& context, const SheetPointer& pointer) {
    Tool::hover(context, pointer);
    path_.aim(context, pointer);
    refine_aim(context, pointer);
}

void PathTool::click(ToolContext& context, const SheetPointer& pointer) {
    hover(context, pointer);
    modifiers_ = pointer.modifiers;
    path_.add(false);
    if (is_done(context)) finish(context);
}

// If the user drags instead of clicking, the point is where the button was released.
void PathTool::drop(ToolContext& context, const SheetPointer& pointer) {
    click(context, pointer);
}

void PathTool::double_click(ToolContext& context, const SheetPointer& pointer) {
    modifiers_ = pointer.modifiers;
    if (path_.points().size() > 1) finish(context);
}

bool PathTool::key(ToolContext& context, Key key, const Modifiers& modifiers) {
    if (path_.is_empty()) return false;
    if (key == Key::Backspace) {
        path_.remove_last();
        hover(context, context.pointer);
        return true;
    }
    if (!is_enter(key)) return false;
    modifiers_ = modifiers;
    finish(context);
    return true;
}

// A length in the direction of the cursor, or across x up from the last point; the first point: its place on the sheet.
bool PathTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (numbers.size() > 2 || (numbers.size() == 1 && path_.is_empty())) return false;
    if (numbers.size() == 2) {
        const Vec2d by = Vec2d(numbers[0], numbers[1]) / 100;
        if (!path_.is_empty() && by.norm() == 0) throw GeometryError("The length must be greater than 0");
        path_.add_at(path_.is_empty() ? by : path_.points().back().at + by);
    } else {
        if (!(numbers[0] > 0)) throw GeometryError("The length must be greater than 0");
        path_.add_at_length(numbers[0] / 100);
    }
    if (is_done(context)) finish(context);
    return true;
}

bool PathTool::cancel(ToolContext&) {
    const bool was_begun = !path_.is_empty();
    path_.clear();
    return was_begun;
}

void PathTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    path_.draw(context, overlay, is_closed());
}

// If the command throws, the path stays, so that the user can remove points.
void PathTool::finish(ToolContext& context) {
    context.document.run(command(context));
    path_.clear();
}

// --- polygon

void PolygonTool::click(ToolContext& context, const SheetPointer& pointer) {
    hover(context, pointer);
    if (path_.is_closing(kPickTolerance * context.px)) {
        context.document.run(command(context));
        path_.clear();
    } else {
        path_.add(pointer.modifiers.ctrl);
    }
}

bool PolygonTool::is_done(const ToolContext&) const {
    return false;
}

Command PolygonTool::command(const ToolContext& context) const {
    return AddPanels{{placed_freely(context.document, context.drape, outline_through(path_.points()))}};
}

std::string PolygonTool::hint(const ToolContext&) const {
    if (path_.is_empty()) return "Click the first point of the panel";
    return "Click points (Ctrl: on a curve, Shift: 45\u00b0), or type 12, 12 < 30 (angle) or 5 x -8 (across x up); the "
           "first point or Enter closes, Backspace takes back";
}

// --- internal line

Command InternalLineTool::command(const ToolContext& context) const {
    const std::vector<Vec2d> path = path_.places();
    if (path.size() < 2) throw GeometryError("A line needs two points");
    const PanelShape& shape =
        panel_under(context.geometry, path, "The line lies over no panel: click its points inside one");
    return AddInternalLine{shape.panel.name, {.name = "", .points = in_panel(shape, path)}};
}

std::string InternalLineTool::hint(const ToolContext&) const {
    if (path_.is_empty()) return "Click the first point inside a panel";
    return "Click points, or type 12, 12 < 30 (angle) or 5 x -8 (across x up) in cm; Enter or double click ends";
}

// --- cut

// To a vertex, as the tip of a dart is one; else to a point of an edge.
void CutTool::refine_aim(const ToolContext& context, const SheetPointer& pointer) {
    if (pointer.modifiers.shift) return;
    PickOptions vertices = pick_options(context);
    vertices.tolerance = kSnapTolerance * context.px;
    vertices.edges = vertices.notches = vertices.internal_lines = vertices.panels = false;
    const bool is_snapping = snap_options(context, pointer.modifiers).is_on;
    const Pick vertex = pick(context.geometry, pointer.at, vertices);
    if (is_snapping && vertex.kind == PickKind::Vertex) return path_.aim_at(vertex.point);
    const std::optional<EdgePoint> place = edge_point_at(context, pointer);
    if (!place) return;
    const PanelShape* shape = context.geometry.find(place->edge.panel);
    path_.aim_at(sheet_point(*shape, place->edge.index, place->t));
}

// Done when a point after the first is on an outline.
bool CutTool::is_done(const ToolContext& context) const {
    if (path_.points().size() < 2) return false;
    PickOptions options = pick_options(context);
    options.vertices = options.notches = options.internal_lines = options.panels = false;
    return pick(context.geometry, path_.points().back().at, options).kind == PickKind::Edge;
}

Command CutTool::command(const ToolContext& context) const {
    const std::vector<Vec2d> path = path_.places();
    if (path.size() < 2)
        throw GeometryError("A cut needs two points: click where it begins on the outline, then where it ends");
    const PanelShape& shape =
        panel_under(context.geometry, path,
                    "The cut lies over no panel: click on across the panel, to another point of its outline");
    return CutPanel{shape.panel.name, in_panel(shape, path), !modifiers_.alt};
}

std::string CutTool::hint(const ToolContext&) const {
    if (path_.is_empty()) return "Click the edge, or the point, where the cut begins: a corner, or the tip of a dart";
    return "Click on to another edge or point: cut, and sewn again; with Alt: not sewn. Backspace takes a point back";
}

// --- mirror

bool MirrorTool::is_done(const ToolContext&) const {
    return path_.points().size() == 2;
}

Command MirrorTool::command(const ToolContext& context) const {
    const std::vector<Vec2d> axis = path_.places();
    const Vec2d along = axis.at(1) - axis.at(0);
    if (!(along.norm() > 0)) throw GeometryError("The axis needs two points");
    const std::optional<Command> command =
        transform_selected(context.geometry, context.document.changeable(), mirror_over(axis[0], along), "Mirror");
    if (!command) throw GeometryError("Select what to mirror first");
    return *command;
}

void MirrorTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    PathTool::draw(context, overlay);
    if (path_.is_empty()) return;
    const Vec2d along = path_.aimed() - path_.points().front().at;
    if (!(along.norm() > 0)) return;
    const PlaneMap map = mirror_over(path_.aimed(), along);
    for (const std::string& name : touched_panels(context.document.changeable())) {
        const PanelShape* shape = context.geometry.find(name);
        if (shape == nullptr) continue;
        OverlayLine ghost{.points = {}, .tone = OverlayTone::Faint, .is_dashed = true};
        for (const Vec2d& point : shape->outline) ghost.points.push_back(apply(map, shape->on_sheet(point)));
        if (!ghost.points.empty()) ghost.points.push_back(ghost.points.front());
        overlay.lines.push_back(std::move(ghost));
    }
}

std::string MirrorTool::hint(const ToolContext& context) const {
    if (context.document.selection().is_empty()) return "Select what to mirror first";
    return "Click two points of the axis; Shift: 45\u00b0";
}

// --- boxes

void BoxTool::aim(const ToolContext& context, const SheetPointer& pointer) {
    SnapOptions options = snap_options(context, pointer.modifiers);
    options.to_directions = false;
    options.origin = from_;
    aimed_ = snap(context.geometry, pointer.at, options);
    if (!from_) return;
    Vec2d size = aimed_.point - *from_;
    if (context.typed && context.typed->size() <= 2) {
        const Vec2d typed = Vec2d(context.typed->front(), context.typed->back()) / 100;
        size = {std::copysign(typed.x(), size.x()), std::copysign(typed.y(), size.y())};
    } else if (pointer.modifiers.shift) {
        const double side = size.cwiseAbs().maxCoeff();
        size = {std::copysign(side, size.x()), std::copysign(side, size.y())};
    }
    aimed_.point = *from_ + size;
}

void BoxTool::hover(ToolContext& context, const SheetPointer& pointer) {
    Tool::hover(context, pointer);
    aim(context, pointer);
}

void BoxTool::press(ToolContext& context, const SheetPointer& pointer) {
    is_new_ = !from_;
    aim(context, pointer);
    if (is_new_) from_ = aimed_.point;
}

void BoxTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (is_new_) return;
    aim(context, pointer);
    make(context);
}

void BoxTool::drag(ToolContext& context, const SheetPointer& pointer) {
    aim(context, pointer);
}

void BoxTool::drop(ToolContext& context, const SheetPointer& pointer) {
    aim(context, pointer);
    make(context);
}

// Width x height, cm. One number: a square.
bool BoxTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (numbers.size() > 2) return false;
    if (!from_) from_ = aimed_.point;
    const Vec2d away = aimed_.point - *from_;
    aimed_.point =
        *from_ + Vec2d(std::copysign(numbers.front() / 100, away.x()), std::copysign(numbers.back() / 100, away.y()));
    make(context);
    return true;
}

void BoxTool::make(ToolContext& context) {
    const Vec2d low = from_->cwiseMin(aimed_.point), size = (aimed_.point - *from_).cwiseAbs();
    from_.reset();
    constexpr double kSmallest = 1e-3;  // m
    if (size.minCoeff() < kSmallest) throw GeometryError("That is too small for a panel: type width x height (cm)");
    sim::Panel panel =
        shape_ == BoxShape::Rectangle ? make_rectangle(-size / 2, size / 2) : make_ellipse(Vec2d(0, 0), size / 2);
    panel.name = shape_ == BoxShape::Rectangle ? "rectangle" : "ellipse";
    panel.sheet_position = low + size / 2;
    context.document.run(AddPanels{{placed_freely(context.document, context.drape, panel)}});
}

bool BoxTool::cancel(ToolContext&) {
    const bool was_begun = from_.has_value();
    from_.reset();
    return was_begun;
}

void BoxTool::draw(const ToolContext&, ToolOverlay& overlay) const {
    add_guides(overlay, aimed_);
    if (!from_) {
        overlay.handles.push_back({aimed_.point, HandleShape::Cross, OverlayTone::Draft, false});
        return;
    }
    const Vec2d low = from_->cwiseMin(aimed_.point), size = (aimed_.point - *from_).cwiseAbs();
    if (shape_ == BoxShape::Rectangle) {
        add_box(overlay, SheetBox(low, low + size), OverlayTone::Draft);
    } else {
        OverlayLine round{.points = {}, .is_closed = true};
        constexpr int kSides = 96;
        for (int i = 0; i <= kSides; ++i) {
            const double angle = 2 * std::numbers::pi * i / kSides;
            round.points.push_back(low + size / 2 + Vec2d(std::cos(angle) * size.x(), std::sin(angle) * size.y()) / 2);
        }
        overlay.lines.push_back(round);
    }
    overlay.readout = {in_cm(size.x()) + " x " + in_cm(size.y())};
}

std::string BoxTool::hint(const ToolContext&) const {
    return from_ ? "Click the opposite corner, or type width x height (cm), then Enter"
                 : "Drag a box, or click a corner; Shift: as wide as high";
}

namespace {

// The edge whose curve passes through the points at parameter 1/2, or at 1/3 and 2/3.
sim::OutlineEdge bent(int start, int end, const Vec2d& from, const Vec2d& to, const std::vector<Vec2d>& through) {
    sim::OutlineEdge edge{.start = start, .end = end};
    if (through.size() == 1) {
        edge.kind = sim::CurveKind::Quadratic;
        edge.control[0] = 2 * through[0] - (from + to) / 2;
    } else if (through.size() == 2) {
        edge.kind = sim::CurveKind::Cubic;
        edge.control[0] = (-5 * from + 18 * through[0] - 9 * through[1] + 2 * to) / 6;
        edge.control[1] = (2 * from - 9 * through[0] + 18 * through[1] - 5 * to) / 6;
    }
    return edge;
}

struct Runs {
    std::vector<Vec2d> vertices;
    std::vector<std::vector<Vec2d>> through;  // curve points after each vertex
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

sim::Panel chained(const Runs& runs, bool is_closed) {
    sim::Panel panel;
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

void PathInProgress::aim(const ToolContext& context, const SheetPointer& pointer) {
    SnapOptions options = snap_options(context, pointer.modifiers);
    for (const PathPoint& point : points_) options.more_points.push_back(point.at);
    if (!points_.empty()) options.origin = points_.back().at;
    aimed_ = snap(context.geometry, pointer.at, options);
    if (context.typed && context.typed->size() == 2) {
        const Vec2d by = Vec2d(context.typed->front(), context.typed->back()) / 100;
        aimed_ = {points_.empty() ? by : Vec2d(points_.back().at + by), SnapKind::None, {}};
        return;
    }
    const bool has_length = context.typed && context.typed->size() == 1 && !points_.empty();
    const Vec2d away = has_length ? Vec2d(aimed_.point - points_.back().at) : Vec2d(0, 0);
    if (away.norm() > 0)
        aimed_ = {points_.back().at + context.typed->front() / 100 * away.normalized(), SnapKind::None, {}};
}

void PathInProgress::add(bool is_curve) {
    const bool is_double = !points_.empty() && (points_.back().at - aimed_.point).norm() < 1e-5;
    if (!is_double) points_.push_back({aimed_.point, is_curve && !points_.empty()});
}

void PathInProgress::add_at_length(double length) {
    if (points_.empty()) return;
    const Vec2d away = aimed_.point - points_.back().at;
    const Vec2d direction = away.norm() > 0 ? Vec2d(away.normalized()) : Vec2d(1, 0);
    points_.push_back({points_.back().at + length * direction, false});
}

bool PathInProgress::remove_last() {
    if (points_.empty()) return false;
    points_.pop_back();
    return true;
}

std::vector<Vec2d> PathInProgress::places() const {
    std::vector<Vec2d> places;
    for (const PathPoint& point : points_) places.push_back(point.at);
    return places;
}

bool PathInProgress::is_closing(double tolerance) const {
    return points_.size() >= 3 && (points_.front().at - aimed_.point).norm() <= tolerance;
}

void PathInProgress::draw(const ToolContext& context, ToolOverlay& overlay, bool is_closed) const {
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
    overlay.readout = {in_cm(away.norm()) + " < " + in_degrees(std::atan2(away.y(), away.x())),
                       in_cm(away.x()) + " x " + in_cm(away.y())};
    if (points_.size() > 1) {
        const Vec2d before = points_.back().at - points_[points_.size() - 2].at;
        const double turn = std::atan2(sim::cross2(before, away), before.dot(away));
        overlay.readout.push_back("turn " + in_degrees(turn));
    }
}

sim::Panel outline_through(std::vector<PathPoint> points) {
    const auto first = std::find_if(points.begin(), points.end(), [](const PathPoint& p) { return !p.is_curve; });
    if (first != points.end()) std::rotate(points.begin(), first, points.end());
    const auto panel_of = [](const std::vector<PathPoint>& given) { return chained(runs_of(given), true); };
    if (points.size() < 3 || runs_of(points).vertices.size() < 2) {
        throw GeometryError("A panel needs three points at least");
    }
    sim::Panel panel = panel_of(points);
    if (outline_area(panel) < 0) {
        std::reverse(points.begin() + 1, points.end());
        panel = panel_of(points);
    }
    SheetBox box;
    for (const Vec2d& vertex : panel.vertices) box.extend(vertex);
    const Vec2d middle = box.center();
    for (Vec2d& vertex : panel.vertices) vertex -= middle;
    for (sim::OutlineEdge& edge : panel.edges) {
        for (int c = 0; c < control_count(edge.kind); ++c) edge.control[static_cast<std::size_t>(c)] -= middle;
    }
    panel.name = "polygon";
    panel.sheet_position = middle;
    return panel;
}

std::vector<Vec2d> polyline_through(const std::vector<PathPoint>& points, bool is_closed) {
    std::vector<Vec2d> line;
    if (points.empty()) return line;
    std::vector<PathPoint> shown = points;
    if (!is_closed) shown.back().is_curve = false;
    const sim::Panel panel = chained(runs_of(shown), is_closed);
    for (const sim::OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> part = outline_polyline(panel, edge, kShapeError * 4);
        line.insert(line.end(), part.begin(), part.end() - 1);
    }
    if (!is_closed || panel.edges.empty()) line.push_back(panel.vertices.back());
    if (is_closed) line.push_back(panel.vertices.front());
    return line;
}

}  // namespace selvedge::editor
