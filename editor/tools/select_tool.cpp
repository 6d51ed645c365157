#include "editor/tools/select_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/tools/overlay_parts.h"
#include "editor/tools/selected_parts.h"

namespace selvedge {
namespace {

// Calls use(set, value) with the set of the selection that the picked thing belongs to.
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

// The vertex of the panels that lies nearest to where one grips them.
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
    moved_ = context.document.selection();
    moving_ = {};
    const std::vector<PartRef> vertices = selected_vertices(context.geometry, moved_);
    moving_.moving = {vertices.begin(), vertices.end()};
    moving_.moving_panels = moved_.panels;
    copied_.clear();
    if (!moved_.panels.empty()) {
        held_ = nearest_vertex(context.geometry, moved_.panels, pressed_at_);
        if (pointer.modifiers.alt && moved_.panels.size() == 1) copied_ = *moved_.panels.begin();
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
    options.moving_panels = copied_.empty() ? moving_.moving_panels : context.document.selection().panels;
    options.origin = held_;
    // Panels keep off whole steps of the grid by as much as they did: the way is a whole number of steps.
    const bool moves_panels = !moved_.panels.empty();
    if (moves_panels) options.grid = 0;
    const Vec2d way = pointer.at - pressed_at_;
    snapped_ = snap(context.geometry, held_ + way, options);
    by_ = snapped_.point - held_;
    if (moves_panels && options.is_on && snapped_.kind == SnapKind::None && context.grid > 0) {
        by_ = (way / context.grid).array().round() * context.grid;
    }
    if (!copied_.empty()) {
        context.document.attempt(DuplicatePanel{copied_, by_});
    } else if (const std::optional<Command> command = move_selected(context.geometry, moved_, by_)) {
        context.document.attempt(*command);
    }
}

void SelectTool::drop(ToolContext& context, const SheetPointer& pointer) {
    const Drag was = drag_;
    drag_ = Drag::None;
    if (was == Drag::Move) context.document.keep();
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

// Moves the selection so far: x, or x x y, cm.
bool SelectTool::enter(ToolContext& context, const std::vector<double>& numbers) {
    if (numbers.size() > 2) return false;
    const Vec2d by = Vec2d(numbers[0], numbers.size() > 1 ? numbers[1] : 0) / 100;
    const std::optional<Command> command = move_selected(context.geometry, context.document.selection(), by);
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

}  // namespace selvedge
