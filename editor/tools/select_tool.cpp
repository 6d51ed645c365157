#include "editor/tools/select_tool.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "editor/geometry/draft.h"
#include "editor/tools/tool.h"
#include "sim/core/math.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

// Calls use(set, value) with the selection's set for the picked kind and the value of the picked part.
template <class Chosen, class Use>
void with_set(Chosen& selection, const Pick& picked, Use&& use) {
    switch (picked.kind) {
        case PickKind::Vertex:
            return use(selection.vertices, picked.ref());
        case PickKind::Edge:
        case PickKind::Handle:
            return use(selection.edges, picked.ref());
        case PickKind::Notch:
            return use(selection.notches, picked.ref());
        case PickKind::InternalLine:
            return use(selection.internal_lines, picked.ref());
        case PickKind::Panel:
            return use(selection.panels, picked.panel);
        case PickKind::Nothing:
            return;
    }
}

// The vertex of these panels nearest to `at`, on the sheet; `at` if there is none.
Vec2d nearest_vertex(const SheetGeometry& geometry, const std::set<std::string>& panels, const Vec2d& at) {
    Vec2d best = at;
    double distance = std::numeric_limits<double>::infinity();
    for (const std::string& name : panels) {
        const PanelShape* shape = geometry.find(name);
        if (shape == nullptr) continue;
        for (const Vec2d& vertex : shape->panel.vertices) {
            const double away = (shape->on_sheet(vertex) - at).norm();
            if (away >= distance) continue;
            distance = away;
            best = shape->on_sheet(vertex);
        }
    }
    return best;
}

std::map<PartRef, Vec2d> all_vertices(const SheetGeometry& geometry) {
    std::map<PartRef, Vec2d> vertices;
    for (const PanelShape& shape : geometry.panels()) {
        int index = 0;
        for (const Vec2d& vertex : shape.panel.vertices) vertices[{shape.panel.name, index++}] = shape.on_sheet(vertex);
    }
    return vertices;
}

// The points that a command moves, by more than rounding: those of linked panels and halves too. None where it cannot
// be applied. Pre: there is no preview, so the geometry is the document's.
std::set<PartRef> moved_by(ToolContext& context, const std::optional<Command>& command) {
    if (!command || !has_links(context.document.pattern())) return {};
    SheetGeometry after = context.geometry;
    try {
        context.document.preview(*command);
    } catch (const GeometryError&) {
        return {};  // the drag says why
    }
    after.update(context.document.pattern(), context.document.revision());
    context.document.rollback();
    constexpr double kRounding = 1e-9;  // m
    std::set<PartRef> moved;
    for (const auto& [vertex, at] : all_vertices(context.geometry)) {
        const std::optional<Vec2d> now = after.vertex(vertex);
        if (now && (*now - at).norm() > kRounding) moved.insert(vertex);
    }
    return moved;
}

// The move in world space, m, after which copies of the panels stand beside all that is there.
Vec3d move_beside(const ToolContext& context, const std::set<std::string>& panels) {
    std::vector<sim::Panel> copies;
    for (const sim::Panel& panel : context.document.pattern().panels) {
        if (panels.contains(panel.name)) copies.push_back(panel);
    }
    return free_move(context.document, context.drape, copies);
}

}  // namespace

bool is_selected(const Selection& selection, const Pick& picked) {
    bool found = false;
    with_set(selection, picked, [&](const auto& set, const auto& value) { found = set.contains(value); });
    return found;
}

Selection with_picked(const Selection& selection, const Pick& picked, bool toggles) {
    Selection result = toggles ? selection : Selection{};
    with_set(result, picked, [&](auto& set, const auto& value) {
        if (!set.erase(value)) set.insert(value);
    });
    return result;
}

PickOptions SelectTool::wanted(const ToolContext& context) const {
    return pick_options(context);
}

Selection SelectTool::boxed(const ToolContext& context) const {
    const SheetBox box = box_.box();
    const Selection panels = in_box(context.geometry, box, box_.rule(), BoxTargets::Panels);
    const bool is_within_one = box_.rule() == BoxRule::Inside && panels.panels.empty();
    return is_within_one ? in_box(context.geometry, box, box_.rule(), BoxTargets::Vertices) : panels;
}

void SelectTool::hover(ToolContext& context, const SheetPointer& pointer) {
    context.hover = hover_of(context.geometry, pick(context.geometry, pointer.at, wanted(context)));
}

void SelectTool::press(ToolContext& context, const SheetPointer& pointer) {
    drag_ = Drag::None;
    pressed_at_ = pointer.at;
    pressed_ = pick(context.geometry, pointer.at, wanted(context));
    was_selected_ = is_selected(context.document.selection(), pressed_);
}

void SelectTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (pressed_.kind == PickKind::Handle) return;
    context.document.select(with_picked(context.document.selection(), pressed_, pointer.modifiers.shift));
}

void SelectTool::begin_move(ToolContext& context, const SheetPointer& pointer) {
    if (!was_selected_) {
        context.document.select(with_picked(context.document.selection(), pressed_, pointer.modifiers.shift));
    }
    drag_ = Drag::Move;
    moved_ = context.document.changeable();
    moving_ = {};
    const std::vector<PartRef> vertices = selected_vertices(context.geometry, moved_);
    moving_.moving = {vertices.begin(), vertices.end()};
    moving_.moving_panels = moved_.panels;
    is_copying_ = pointer.modifiers.alt && !moved_.panels.empty();
    if (is_copying_) {
        copy_move_ = move_beside(context, moved_.panels);
    } else {
        moving_.moving.merge(moved_by(context, move_selected(context.geometry, moved_, pointer.at - pressed_at_)));
    }
    if (!moved_.panels.empty()) {
        held_ = nearest_vertex(context.geometry, moved_.panels, pressed_at_);
    } else {
        held_ = pressed_.kind == PickKind::Vertex ? pressed_.point
                                                  : context.geometry.vertex(vertices.front()).value_or(pressed_at_);
    }
}

void SelectTool::drag(ToolContext& context, const SheetPointer& pointer) {
    if (drag_ == Drag::None) {
        const bool is_movable =
            pressed_.kind == PickKind::Vertex || pressed_.kind == PickKind::Edge || pressed_.kind == PickKind::Panel;
        if (is_movable) {
            begin_move(context, pointer);
        } else {
            drag_ = Drag::Box;
            box_.from = pressed_at_;
        }
    }
    if (drag_ == Drag::Box) box_.to = pointer.at;
    if (drag_ == Drag::Move) move_to(context, pointer);
}

void SelectTool::move_to(ToolContext& context, const SheetPointer& pointer) {
    SnapOptions options = snap_options(context, pointer.modifiers);
    options.moving = moving_.moving;
    options.moving_panels = is_copying_ ? context.document.selection().panels : moving_.moving_panels;
    options.origin = held_;
    // Panels move by whole grid steps, so that they keep their offset from the grid.
    const bool moves_panels = !moved_.panels.empty();
    if (moves_panels) options.grid = 0;
    const Vec2d way = pointer.at - pressed_at_;
    snapped_ = snap(context.geometry, held_ + way, options);
    by_ = snapped_.point - held_;
    if (moves_panels && options.is_on && snapped_.kind == SnapKind::None && context.grid > 0) {
        by_ = (way / context.grid).array().round() * context.grid;
    }
    if (is_copying_) {
        context.document.preview(DuplicatePanels{{moved_.panels.begin(), moved_.panels.end()}, by_, copy_move_});
    } else if (const std::optional<Command> command = move_selected(context.geometry, moved_, by_)) {
        context.document.preview(*command);
    }
}

void SelectTool::drop(ToolContext& context, const SheetPointer& pointer) {
    const Drag was = drag_;
    drag_ = Drag::None;
    if (was == Drag::Move) context.document.commit();
    if (was != Drag::Box) return;
    box_.to = pointer.at;
    Selection found = boxed(context);
    if (pointer.modifiers.shift) {
        const Selection& old = context.document.selection();
        found.panels.insert(old.panels.begin(), old.panels.end());
        found.vertices.insert(old.vertices.begin(), old.vertices.end());
        found.edges.insert(old.edges.begin(), old.edges.end());
    }
    context.document.select(found);
}

// Moves the selection by dx or by dx x dy, cm.
bool SelectTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    // A number cannot tell how far copies, a frame or a curve's handle go.
    const Drag drag = std::exchange(drag_, Drag::None);
    if (numbers.size() > 2 || drag == Drag::Box || (drag == Drag::Move && is_copying_)) return false;
    const Vec2d by = Vec2d(numbers[0], numbers.size() > 1 ? numbers[1] : 0) / 100;
    const Selection held = drag == Drag::Move ? moved_ : context.document.changeable();
    const std::optional<Command> command = move_selected(context.geometry, held, by);
    if (!command) return false;
    context.document.run(*command);
    return true;
}

bool SelectTool::cancel(ToolContext&) {
    const bool was_busy = drag_ != Drag::None;
    drag_ = Drag::None;
    return was_busy;
}

void SelectTool::draw(const ToolContext&, ToolOverlay& overlay) const {
    if (drag_ == Drag::Box) {
        add_box(overlay, box_.box(), box_.rule() == BoxRule::Inside ? OverlayTone::Draft : OverlayTone::Guide);
    }
    if (drag_ != Drag::Move) return;
    add_guides(overlay, snapped_);
    overlay.lines.push_back({.points = {held_, held_ + by_}, .tone = OverlayTone::Measure, .is_dashed = true});
    overlay.readout = {"dx " + in_cm(by_.x()), "dy " + in_cm(by_.y()), in_cm(by_.norm())};
}

std::string SelectTool::hint(const ToolContext& context) const {
    if (drag_ == Drag::Move) return "Shift: 45\u00b0, Ctrl: no snapping, Esc: back";
    if (drag_ == Drag::Box) return "To the right: what is inside. To the left: what it touches";
    if (context.document.selection().is_empty()) return "Click or drag a box to select; drag to move";
    return "Drag to move, Alt-drag to copy, arrows: 1 mm, with Shift 1 cm, or type dx x dy";
}

namespace {

std::set<PartRef> shown_handles(const ToolContext& context) {
    std::set<std::string> panels = touched_panels(context.document.changeable());
    return curved_edges_of(context.geometry, panels);
}

}  // namespace

PickOptions EditPointTool::wanted(const ToolContext& context) const {
    PickOptions options = pick_options(context);
    options.handle_edges = shown_handles(context);
    return options;
}

Selection EditPointTool::boxed(const ToolContext& context) const {
    return in_box(context.geometry, box(), BoxRule::Inside, BoxTargets::Vertices);
}

void EditPointTool::press(ToolContext& context, const SheetPointer& pointer) {
    SelectTool::press(context, pointer);
    is_dragging_part_ = false;
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (shape == nullptr) return;
    if (pressed_.kind == PickKind::Handle) curve_ = shape->panel.edges.at(static_cast<std::size_t>(pressed_.index));
    if (pressed_.kind != PickKind::InternalLine) return;
    line_ = shape->panel.internal_lines.at(static_cast<std::size_t>(pressed_.index));
    const Vec2d u = shape->in_panel(pointer.at);
    line_point_ = 0;
    for (std::size_t i = 1; i < line_.points.size(); ++i) {
        if ((line_.points[i] - u).norm() < (line_.points[line_point_] - u).norm()) line_point_ = i;
    }
}

void EditPointTool::drag(ToolContext& context, const SheetPointer& pointer) {
    is_dragging_part_ = pressed_.kind == PickKind::Handle || pressed_.kind == PickKind::InternalLine;
    if (pressed_.kind == PickKind::Handle) return drag_handle(context, pointer);
    if (pressed_.kind == PickKind::InternalLine) return drag_line_point(context, pointer);
    SelectTool::drag(context, pointer);
}

void EditPointTool::drag_handle(ToolContext& context, const SheetPointer& pointer) {
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (shape == nullptr) return;
    SnapOptions options = snap_options(context, pointer.modifiers);
    options.to_guides = false;
    const int from = pressed_.control == 0 ? curve_.start : curve_.end;
    options.origin = shape->on_sheet(shape->panel.vertices.at(static_cast<std::size_t>(from)));
    snapped_ = snap(context.geometry, pointer.at, options);
    sim::OutlineEdge curve = curve_;
    curve.control.at(static_cast<std::size_t>(pressed_.control)) = shape->in_panel(snapped_.point);
    context.document.preview(SetCurve{pressed_.panel, pressed_.index, curve});
}

void EditPointTool::drag_line_point(ToolContext& context, const SheetPointer& pointer) {
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (shape == nullptr) return;
    snapped_ = snap(context.geometry, pointer.at, snap_options(context, pointer.modifiers));
    sim::InternalLine line = line_;
    line.points.at(line_point_) = shape->in_panel(snapped_.point);
    context.document.preview(SetInternalLine{pressed_.panel, pressed_.index, line});
}

void EditPointTool::drop(ToolContext& context, const SheetPointer& pointer) {
    if (!is_dragging_part_) return SelectTool::drop(context, pointer);
    is_dragging_part_ = false;
    context.document.commit();
}

void EditPointTool::double_click(ToolContext& context, const SheetPointer& pointer) {
    PickOptions options = pick_options(context);
    const Pick picked = pick(context.geometry, pointer.at, options);
    if (picked.kind != PickKind::Edge) return;
    const double t =
        snap_along(*context.geometry.edge(picked.ref()), picked.t, snap_options(context, pointer.modifiers));
    context.document.run(AddVertex{picked.panel, picked.index, t});
}

// Moves the handle, or the point of an internal line, that is dragged by dx or by dx x dy, cm.
bool EditPointTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (!std::exchange(is_dragging_part_, false)) return SelectTool::enter(context, numbers);
    const PanelShape* shape = context.geometry.find(pressed_.panel);
    if (numbers.size() > 2 || shape == nullptr) return false;
    const Vec2d by = Vec2d(numbers[0], numbers.size() > 1 ? numbers[1] : 0) / 100;
    const auto move = [&](Vec2d& u) { u = shape->in_panel(shape->on_sheet(u) + by); };
    if (pressed_.kind == PickKind::Handle) {
        move(curve_.control.at(static_cast<std::size_t>(pressed_.control)));
        context.document.run(SetCurve{pressed_.panel, pressed_.index, curve_});
    } else {
        move(line_.points.at(line_point_));
        context.document.run(SetInternalLine{pressed_.panel, pressed_.index, line_});
    }
    return true;
}

bool EditPointTool::cancel(ToolContext& context) {
    const bool was_dragging = is_dragging_part_;
    is_dragging_part_ = false;
    return SelectTool::cancel(context) || was_dragging;
}

void EditPointTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    overlay.shows_vertices = true;
    overlay.handle_edges = shown_handles(context);
    SelectTool::draw(context, overlay);
    if (!is_dragging_part_) return;
    add_guides(overlay, snapped_);
    if (pressed_.kind != PickKind::Handle) return;
    if (const EdgeShape* edge = context.geometry.edge(pressed_.ref())) overlay.readout = {in_cm(edge->length)};
}

std::string EditPointTool::hint(const ToolContext&) const {
    return "Drag points and handles; double click an edge to add a point, Delete to take one out";
}

namespace {

PlaneMap about(const Vec2d& centre, const Vec2d& x_axis, const Vec2d& y_axis) {
    return {x_axis, y_axis, centre - x_axis * centre.x() - y_axis * centre.y()};
}

}  // namespace

std::vector<PartRef> selected_vertices(const SheetGeometry& geometry, const Selection& selection) {
    std::set<PartRef> vertices = selection.vertices;
    for (const PartRef& ref : selection.edges) {
        const PanelShape* shape = geometry.find(ref.panel);
        if (shape == nullptr || geometry.edge(ref) == nullptr) continue;
        const sim::OutlineEdge& edge = shape->panel.edges[static_cast<std::size_t>(ref.index)];
        vertices.insert({ref.panel, edge.start});
        vertices.insert({ref.panel, edge.end});
    }
    std::erase_if(vertices, [&](const PartRef& ref) { return selection.panels.contains(ref.panel); });
    return {vertices.begin(), vertices.end()};
}

std::optional<Command> move_selected(const SheetGeometry& geometry, const Selection& selection, const Vec2d& by) {
    if (!selection.panels.empty()) {
        return MovePanels{{selection.panels.begin(), selection.panels.end()}, by};
    }
    const std::vector<PartRef> vertices = selected_vertices(geometry, selection);
    if (vertices.empty()) return {};
    return MoveVertices{vertices, by};
}

std::optional<Command> transform_selected(const SheetGeometry& geometry, const Selection& selection,
                                          const PlaneMap& map, const std::string& what) {
    if (!selection.panels.empty()) {
        return TransformPanels{{selection.panels.begin(), selection.panels.end()}, map, what};
    }
    const std::vector<PartRef> vertices = selected_vertices(geometry, selection);
    if (vertices.empty()) return {};
    return TransformVertices{vertices, map, what};
}

std::set<std::string> touched_panels(const Selection& selection) {
    std::set<std::string> panels = selection.panels;
    for (const std::set<PartRef>* parts :
         {&selection.vertices, &selection.edges, &selection.internal_lines, &selection.notches}) {
        for (const PartRef& ref : *parts) panels.insert(ref.panel);
    }
    return panels;
}

PlaneMap rotation_about(const Vec2d& centre, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return about(centre, Vec2d(c, s), Vec2d(-s, c));
}

PlaneMap scaling_about(const Vec2d& centre, const Vec2d& factors) {
    return about(centre, Vec2d(factors.x(), 0), Vec2d(0, factors.y()));
}

PlaneMap mirror_over(const Vec2d& on_axis, const Vec2d& direction) {
    const Vec2d d = direction.normalized();
    return about(on_axis, Vec2d(2 * d.x() * d.x() - 1, 2 * d.x() * d.y()),
                 Vec2d(2 * d.x() * d.y(), 2 * d.y() * d.y() - 1));
}

Vec2d apply(const PlaneMap& map, const Vec2d& p) {
    return map.x_axis * p.x() + map.y_axis * p.y() + map.shift;
}

namespace {

Vec2d handle_place(const SheetBox& box, const Vec2d& handle) {
    return box.center() + handle.cwiseProduct(box.sizes() / 2);
}

template <class Use>
void for_each_handle(Use&& use) {
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            if (x != 0 || y != 0) use(Vec2d(x, y));
        }
    }
}

std::string in_percent(double factor) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", factor * 100);
    return text;
}

}  // namespace

void TransformTool::press(ToolContext& context, const SheetPointer& pointer) {
    pressed_ = pick(context.geometry, pointer.at, pick_options(context));
    held_ = context.document.changeable();
    box_ = context.geometry.box_of(held_);
    pressed_at_ = pointer.at;
    handle_.reset();
    is_dragging_ = moves_pivot_ = false;
    if (box_.isEmpty()) return;
    if (mode_ == TransformMode::Rotate) {
        const bool is_on_pivot = (centre(context) - pointer.at).norm() <= 1.3 * kPickTolerance * context.px;
        moves_pivot_ = is_on_pivot || pointer.modifiers.alt;
        if (moves_pivot_) return;
    }
    for_each_handle([&](const Vec2d& handle) {
        if ((handle_place(box_, handle) - pointer.at).norm() <= 1.3 * kPickTolerance * context.px) handle_ = handle;
    });
}

// About which the selection is rotated.
Vec2d TransformTool::centre(const ToolContext& context) const {
    const Selection selected = context.document.changeable();
    if (pivot_ && pivot_of_ == selected) return *pivot_;
    return context.geometry.box_of(selected).center();
}

void TransformTool::put_pivot(const ToolContext& context, const SheetPointer& pointer) {
    SnapOptions options = snap_options(context, {.ctrl = pointer.modifiers.ctrl});
    options.to_guides = false;
    pivot_ = snap(context.geometry, pointer.at, options).point;
    pivot_of_ = context.document.changeable();
}

void TransformTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (moves_pivot_) {
        if (pointer.modifiers.alt) put_pivot(context, pointer);
        return;
    }
    if (handle_) return;
    context.document.select(with_picked(context.document.selection(), pressed_, pointer.modifiers.shift));
}

void TransformTool::drag(ToolContext& context, const SheetPointer& pointer) {
    if (moves_pivot_) return put_pivot(context, pointer);
    if (box_.isEmpty()) {  // nothing was selected: select the pressed part
        if (pressed_.kind == PickKind::Nothing) return;
        context.document.select(with_picked({}, pressed_, false));
        held_ = context.document.selection();
        box_ = context.geometry.box_of(held_);
        if (box_.isEmpty()) return;
    }
    if (!is_dragging_) centre_ = centre(context);
    if (!std::exchange(is_dragging_, true) && mode_ == TransformMode::Scale) {
        constexpr double kSmaller = 0.9;  // any factor shows what is scaled along
        const PlaneMap map = scaling_about(box_.center(), Vec2d(kSmaller, kSmaller));
        scaled_ = moved_by(context, transform_selected(context.geometry, held_, map, "Scale"));
    }
    mode_ == TransformMode::Rotate ? rotate(context, pointer) : scale(context, pointer);
}

void TransformTool::rotate(ToolContext& context, const SheetPointer& pointer) {
    const Vec2d middle = centre_, from = pressed_at_ - middle, to = pointer.at - middle;
    if (from.norm() == 0 || to.norm() == 0) return;
    angle_ = std::atan2(sim::cross2(from, to), from.dot(to));
    const double step = pointer.modifiers.shift ? 15 * sim::kDegree : sim::kDegree;
    if (pointer.modifiers.shift || snap_options(context, pointer.modifiers).is_on) {
        angle_ = std::round(angle_ / step) * step;
    }
    preview(context, rotation_about(middle, angle_));
}

// Scales about the opposite handle; with Alt about the centre. A handle at a side's middle scales one axis only.
void TransformTool::scale(ToolContext& context, const SheetPointer& pointer) {
    if (!handle_) return;
    const bool is_about_middle = pointer.modifiers.alt;
    const Vec2d fixed = is_about_middle ? Vec2d(box_.center()) : handle_place(box_, -*handle_);
    const Vec2d held = handle_place(box_, *handle_);
    SnapOptions options = snap_options(context, pointer.modifiers);
    options.to_directions = false;
    options.moving = scaled_;
    options.moving_panels = touched_panels(held_);
    const Vec2d to = snap(context.geometry, pointer.at, options).point;
    factors_ = Vec2d(1, 1);
    for (int axis = 0; axis < 2; ++axis) {
        const double before = held[axis] - fixed[axis];
        if ((*handle_)[axis] != 0 && std::abs(before) > 1e-9) factors_[axis] = (to[axis] - fixed[axis]) / before;
    }
    if (pointer.modifiers.shift) {
        const bool is_x =
            (*handle_).x() != 0 && ((*handle_).y() == 0 || std::abs(factors_.x() - 1) > std::abs(factors_.y() - 1));
        factors_ = Vec2d::Constant(is_x ? factors_.x() : factors_.y());
    }
    if (factors_.cwiseAbs().minCoeff() < 0.01) return;
    preview(context, scaling_about(fixed, factors_));
}

void TransformTool::preview(ToolContext& context, const PlaneMap& map) {
    const char* what = mode_ == TransformMode::Rotate ? "Rotate" : "Scale";
    if (const std::optional<Command> command = transform_selected(context.geometry, held_, map, what)) {
        context.document.preview(*command);
    }
}

void TransformTool::drop(ToolContext& context, const SheetPointer&) {
    if (std::exchange(moves_pivot_, false)) return;
    is_dragging_ = false;
    context.document.commit();
    if (pivot_) pivot_of_ = context.document.changeable();
}

bool TransformTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    is_dragging_ = false;
    const Selection selection = context.document.changeable();
    const SheetBox box = context.geometry.box_of(selection);
    if (box.isEmpty()) throw GeometryError("Select something first");
    PlaneMap map;
    if (mode_ == TransformMode::Rotate) {
        if (numbers.size() != 1) return false;
        map = rotation_about(centre(context), numbers[0] * sim::kDegree);
    } else {
        if (numbers.size() > 2) return false;
        const Vec2d factors(numbers.front(), numbers.back());
        if (factors.cwiseAbs().minCoeff() < 0.01)
            throw GeometryError("The factor must not be 0; type, for example, 1.05");
        map = scaling_about(box.center(), factors);
    }
    const char* what = mode_ == TransformMode::Rotate ? "Rotate" : "Scale";
    const std::optional<Command> command = transform_selected(context.geometry, selection, map, what);
    if (!command) return false;
    context.document.run(*command);
    return true;
}

bool TransformTool::cancel(ToolContext&) {
    const bool was_dragging = is_dragging_;
    is_dragging_ = false;
    return was_dragging;
}

void TransformTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    const SheetBox box = context.geometry.box_of(context.document.changeable());
    if (box.isEmpty()) return;
    add_box(overlay, box, OverlayTone::Faint);
    const HandleShape shape = mode_ == TransformMode::Rotate ? HandleShape::Round : HandleShape::Square;
    for_each_handle([&](const Vec2d& handle) {
        const bool is_corner = handle.x() != 0 && handle.y() != 0;
        if (mode_ == TransformMode::Rotate && !is_corner) return;
        overlay.handles.push_back({handle_place(box, handle), shape, OverlayTone::Draft, false});
    });
    if (mode_ == TransformMode::Rotate)
        overlay.handles.push_back(
            {is_dragging_ ? centre_ : centre(context), HandleShape::Cross, OverlayTone::Draft, false});
    if (!is_dragging_) return;
    if (mode_ == TransformMode::Rotate) {
        overlay.lines.push_back(
            {.points = {centre_, context.pointer.at}, .tone = OverlayTone::Measure, .is_dashed = true});
        overlay.readout = {in_degrees(angle_)};
    } else {
        overlay.readout = {in_percent(factors_.x()) + " x " + in_percent(factors_.y()),
                           in_cm(box.sizes().x()) + " x " + in_cm(box.sizes().y())};
    }
}

std::string TransformTool::hint(const ToolContext& context) const {
    if (context.document.selection().is_empty()) return "Click what is to be changed";
    if (mode_ == TransformMode::Rotate)
        return "Drag to turn, Shift: by 15\u00b0; or type degrees, then Enter. Drag the cross, or Alt-click, to turn "
               "about "
               "another point";
    return "Drag a handle, Shift: keep proportions, Alt: about the middle; or type a factor, such as 1.05 or 1.1 x 1";
}

}  // namespace selvedge::editor
