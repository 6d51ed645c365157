#include "editor/tools/panel_tools.h"

#include <cmath>

#include "editor/geometry/draft.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {

void MergeTool::click(ToolContext& context, const SheetPointer& pointer) {
    require_place(context, pointer, "merged over");
    const std::optional<int> seam = context.geometry.seam_of(place_->edge);
    if (!seam)
        throw GeometryError("This edge is not sewn: sew it to the panel that it is to be merged with (N) first",
                            {{.panel = place_->edge.panel, .edge = place_->edge.index}});
    const bool is_named = pointer.modifiers.ctrl;
    context.document.run(MergePanels{.seam = *seam, .stays = is_named ? place_->edge.panel : ""});
}

void MergeTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    overlay.shows_sewing = true;
    if (place_) add_edge(overlay, context.geometry, place_->edge, OverlayTone::Draft);
}

std::string MergeTool::hint(const ToolContext&) const {
    return "Click a seam: its two panels become one, and the larger one stays where it lies. Ctrl: the clicked one "
           "stays";
}

void UnfoldTool::click(ToolContext& context, const SheetPointer& pointer) {
    require_place(context, pointer, "unfolded over");
    context.document.run(UnfoldPanel{place_->edge.panel, place_->edge.index});
}

void UnfoldTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    if (place_) add_edge(overlay, context.geometry, place_->edge, OverlayTone::Draft);
}

std::string UnfoldTool::hint(const ToolContext&) const {
    return "Click a straight edge: the panel is opened over it as over a fold";
}

// --- measure

MeasureTool::End MeasureTool::end_at(const ToolContext& context, const SheetPointer& pointer) {
    SnapOptions options = snap_options(context, pointer.modifiers);
    options.to_guides = false;
    options.grid = 0;
    if (from_ && !is_done_) options.origin = from_->at;
    aimed_ = snap(context.geometry, pointer.at, options);
    End end{aimed_.point, {}};
    const Pick on = pick(context.geometry, aimed_.point,
                         {.tolerance = kPickTolerance * context.px,
                          .vertices = false,
                          .notches = false,
                          .internal_lines = false,
                          .panels = false});
    if (on.kind != PickKind::Edge || aimed_.kind == SnapKind::Direction) return end;
    end.place = EdgePoint{on.ref(), on.t};
    if (aimed_.kind == SnapKind::None) end.at = on.point;
    return end;
}

void MeasureTool::hover(ToolContext& context, const SheetPointer& pointer) {
    Tool::hover(context, pointer);
    const End end = end_at(context, pointer);
    if (!is_done_) to_ = end;
}

void MeasureTool::press(ToolContext& context, const SheetPointer& pointer) {
    is_new_ = !from_ || is_done_;
    if (!is_new_) return;
    is_done_ = false;
    from_ = end_at(context, pointer);
    to_ = *from_;
}

void MeasureTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (!is_new_) drop(context, pointer);
}

void MeasureTool::drag(ToolContext& context, const SheetPointer& pointer) {
    to_ = end_at(context, pointer);
}

void MeasureTool::drop(ToolContext& context, const SheetPointer& pointer) {
    to_ = end_at(context, pointer);
    is_done_ = true;
}

bool MeasureTool::cancel(ToolContext&) {
    const bool was_begun = from_.has_value();
    from_.reset();
    is_done_ = false;
    return was_begun;
}

void MeasureTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    if (!from_) {
        add_guides(overlay, aimed_);
        if (!to_.place) return;
        const EdgeShape* edge = context.geometry.edge(to_.place->edge);
        if (edge == nullptr) return;
        add_edge(overlay, context.geometry, to_.place->edge, OverlayTone::Measure);
        overlay.readout = {"edge " + in_cm(edge->length),
                           in_cm(to_.place->t * edge->length) + " | " + in_cm((1 - to_.place->t) * edge->length)};
        return;
    }
    if (!is_done_) add_guides(overlay, aimed_);
    const Vec2d way = to_.at - from_->at;
    overlay.lines.push_back({.points = {from_->at, to_.at}, .tone = OverlayTone::Measure});
    for (const Vec2d& at : {from_->at, to_.at})
        overlay.handles.push_back({at, HandleShape::Cross, OverlayTone::Measure, false});
    if (way.norm() == 0) return;
    overlay.labels.push_back({from_->at + way / 2, in_cm(way.norm()) + "   " + in_degrees(std::atan2(way.y(), way.x())),
                              OverlayTone::Measure});
    if (!is_done_) overlay.readout = {"dx " + in_cm(way.x()), "dy " + in_cm(way.y())};
    const bool is_along = from_->place && to_.place && from_->place->edge == to_.place->edge;
    const EdgeShape* edge = is_along ? context.geometry.edge(to_.place->edge) : nullptr;
    if (edge == nullptr) return;
    const PanelShape* shape = context.geometry.find(to_.place->edge.panel);
    const std::vector<Vec2d> part = part_of_edge(*shape, to_.place->edge.index, from_->place->t, to_.place->t);
    const double along = std::abs(from_->place->t - to_.place->t) * edge->length;
    overlay.lines.push_back({.points = part, .tone = OverlayTone::Draft});
    if (along - way.norm() > 5e-5) {
        overlay.labels.push_back({part[part.size() / 2], "along " + in_cm(along), OverlayTone::Draft});
    }
}

std::string MeasureTool::hint(const ToolContext&) const {
    return "Click two points; on one edge its length between them is shown, too";
}

}  // namespace selvedge::editor
