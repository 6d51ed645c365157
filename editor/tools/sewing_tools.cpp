#include "editor/tools/sewing_tools.h"

#include <algorithm>
#include <cmath>

#include "editor/geometry/draft.h"
#include "editor/geometry/seam_edit.h"
#include "editor/geometry/sewing.h"
#include "editor/tools/outline_tools.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {
namespace {

std::optional<int> index_of(const SheetGeometry& geometry, const std::string& panel) {
    const std::vector<PanelShape>& panels = geometry.panels();
    for (std::size_t i = 0; i < panels.size(); ++i) {
        if (panels[i].panel.name == panel) return static_cast<int>(i);
    }
    return {};
}

std::vector<Vec2d> line_of(const SheetGeometry& geometry, const SewnEnd& end) {
    const PanelShape* shape = geometry.find(end.edge.panel);
    if (shape == nullptr || geometry.edge(end.edge) == nullptr) return {};
    return part_of_edge(*shape, end.edge.index, end.is_from_start ? 0 : 1, end.is_from_start ? 1 : 0);
}

Vec2d along(const std::vector<Vec2d>& line, double share) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
    double left = share * length;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double part = (line[i + 1] - line[i]).norm();
        if (left <= part && part > 0) return line[i] + left / part * (line[i + 1] - line[i]);
        left -= part;
    }
    return line.back();
}

}  // namespace

bool is_reversed(const SewnEnd& first, const SewnEnd& second) {
    return first.is_from_start != second.is_from_start;
}

std::optional<sim::Seam> seam_between(const SheetGeometry& geometry, const SewnEnd& first, const SewnEnd& second) {
    const std::optional<int> a = index_of(geometry, first.edge.panel), b = index_of(geometry, second.edge.panel);
    if (!a || !b || geometry.edge(first.edge) == nullptr || geometry.edge(second.edge) == nullptr) return {};
    return sim::Seam{
        .first = {*a, first.edge.index}, .second = {*b, second.edge.index}, .is_reversed = is_reversed(first, second)};
}

void add_seam_lines(ToolOverlay& overlay, const std::vector<Vec2d>& first, const std::vector<Vec2d>& second,
                    OverlayTone tone) {
    if (first.size() < 2 || second.size() < 2) return;
    constexpr int kThreads = 6;
    for (int i = 0; i <= kThreads; ++i) {
        const double share = double(i) / kThreads;
        overlay.lines.push_back({.points = {along(first, share), along(second, share)},
                                 .tone = tone,
                                 .is_dashed = i != 0 && i != kThreads});
    }
}

std::optional<std::string> difference_text(double first, double second) {
    if (std::abs(second - first) <= kUnevenSeam) return {};
    return in_mm(second - first);
}

std::optional<Vec2d> seam_button(const SheetGeometry& geometry, const sim::Pattern& pattern, int seam) {
    if (seam < 0 || static_cast<std::size_t>(seam) >= pattern.seams.size()) return {};
    const sim::SeamSide& side = pattern.seams[static_cast<std::size_t>(seam)].first;
    const std::vector<PanelShape>& panels = geometry.panels();
    if (side.panel < 0 || static_cast<std::size_t>(side.panel) >= panels.size()) return {};
    const PanelShape& shape = panels[static_cast<std::size_t>(side.panel)];
    if (side.edge < 0 || static_cast<std::size_t>(side.edge) >= shape.edges.size()) return {};
    return sheet_point(shape, side.edge, 0.5);
}

std::optional<SewnEnd> SewingTool::end_at(const ToolContext& context, const SheetPointer& pointer) const {
    PickOptions options = pick_options(context);
    options.tolerance *= 1.6;
    options.vertices = options.notches = options.internal_lines = options.panels = false;
    const Pick picked = pick(context.geometry, pointer.at, options);
    if (picked.kind != PickKind::Edge) return {};
    return SewnEnd{picked.ref(), (picked.t <= 0.5) != (first_ && is_turned_)};
}

void SewingTool::hover(ToolContext& context, const SheetPointer& pointer) {
    second_ = end_at(context, pointer);
    Pick picked = pick(context.geometry, pointer.at, pick_options(context));
    if (second_) picked = {.kind = PickKind::Edge, .panel = second_->edge.panel, .index = second_->edge.index};
    context.hover = hover_of(context.geometry, picked);
}

void SewingTool::click(ToolContext& context, const SheetPointer& pointer) {
    slide_.reset();
    for (const int seam : context.document.changeable().seams) {
        const std::optional<Vec2d> button = seam_button(context.geometry, context.document.pattern(), seam);
        if (first_ || !button || (*button - pointer.at).norm() > kPickTolerance * context.px) continue;
        return context.document.run(ReverseSeam{seam});
    }
    const std::optional<SewnEnd> end = end_at(context, pointer);
    if (!end) {
        const bool had_selection = !context.document.selection().is_empty();
        const bool is_on_part = pick(context.geometry, pointer.at, pick_options(context)).kind != PickKind::Nothing;
        context.document.select({});
        if (had_selection && !first_ && !is_on_part) return;  // that is what the click was for
        throw no_edge_error(context, pointer, "sewn");
    }
    if (!first_) {
        Selection selection;
        if (const std::optional<int> seam = context.geometry.seam_of(end->edge)) {
            selection.seams.insert(*seam);
        } else {
            first_ = end;
            is_turned_ = false;
        }
        return context.document.select(selection);
    }
    const SewnEnd first = *first_;
    context.document.run(SewEdges{first.edge, end->edge, is_reversed(first, *end)});
    first_.reset();
    second_.reset();
}

bool SewingTool::key(ToolContext& context, Key key, const Modifiers& modifiers) {
    if (key != key_of('R') || modifiers.ctrl) return false;
    if (slide_) return true;
    if (first_) {
        is_turned_ = !is_turned_;
        hover(context, context.pointer);
        return true;
    }
    reverse_selected(context);
    return true;
}

// The seams of a sewing that is reversed get other indices, so those that stand alone come first, and the rest is
// found again by name.
void SewingTool::reverse_selected(ToolContext& context) const {
    std::vector<std::string> sewings;
    for (const int seam : one_of_each_sewing(context.document.pattern(), context.document.changeable().seams)) {
        const std::string& sewing = context.document.pattern().seams[static_cast<std::size_t>(seam)].sewing;
        if (sewing.empty()) {
            context.document.run(ReverseSeam{seam});
        } else {
            sewings.push_back(sewing);
        }
    }
    for (const std::string& sewing : sewings) {
        const std::vector<sim::Seam>& seams = context.document.pattern().seams;
        const auto found = std::ranges::find(seams, sewing, &sim::Seam::sewing);
        if (found != seams.end()) context.document.run(ReverseSeam{static_cast<int>(found - seams.begin())});
    }
}

void SewingTool::press(ToolContext& context, const SheetPointer& pointer) {
    slide_.reset();
    const std::optional<SewnEnd> end = first_ ? std::nullopt : end_at(context, pointer);
    const std::optional<int> seam = end ? context.geometry.seam_of(end->edge) : std::nullopt;
    if (!seam || !context.document.changeable().seams.contains(*seam)) return;
    const sim::SeamSide& first = context.document.pattern().seams[static_cast<std::size_t>(*seam)].first;
    const bool is_second = index_of(context.geometry, end->edge.panel) != first.panel || end->edge.index != first.edge;
    if (!can_slide(context.document.pattern(), *seam, is_second ? SewingRun::Second : SewingRun::First)) return;
    const PanelShape* shape = context.geometry.find(end->edge.panel);
    const double t = nearest(*context.geometry.edge(end->edge), shape->in_panel(pointer.at)).t;
    const Vec2d along = sheet_point(*shape, end->edge.index, std::min(t + 0.05, 1.0)) -
                        sheet_point(*shape, end->edge.index, std::max(t - 0.05, 0.0));
    slide_ = Slide{{.seam = *seam, .is_second = is_second}, pointer.at, along.normalized()};
}

// By how far the pointer moves in the direction that the outline has where it was pressed.
void SewingTool::drag(ToolContext& context, const SheetPointer& pointer) {
    if (slide_ && !context.document.selection().seams.contains(slide_->command.seam)) slide_.reset();
    if (!slide_) return;
    slide_->command.by = slide_->along.dot(pointer.at - slide_->from);
    context.document.preview(slide_->command);
}

void SewingTool::drop(ToolContext& context, const SheetPointer&) {
    if (!slide_) return;
    context.document.commit();
    slide_.reset();
}

bool SewingTool::cancel(ToolContext& context) {
    const bool was_begun = first_.has_value() || slide_.has_value();
    if (slide_) context.document.rollback();
    slide_.reset();
    first_.reset();
    is_turned_ = false;
    return was_begun;
}

void SewingTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    overlay.shows_sewing = true;
    if (slide_) {
        overlay.readout = {in_mm(slide_->command.by)};
        return;
    }
    const std::optional<SewnEnd>& begun = first_ ? first_ : second_;
    if (!begun || context.geometry.edge(begun->edge) == nullptr) return;
    const double length = context.geometry.edge(begun->edge)->length;
    const bool is_taken = !first_ && context.geometry.seam_of(begun->edge);
    if (!is_taken) overlay.lines.push_back({.points = line_of(context.geometry, *begun), .has_ticks = true});
    overlay.readout = {in_cm(length)};
    if (!first_) return;
    if (!second_ || second_->edge == first_->edge) {
        const std::vector<Vec2d> line = line_of(context.geometry, *first_);
        overlay.lines.push_back(
            {.points = {line.front(), context.pointer.at}, .tone = OverlayTone::Faint, .is_dashed = true});
        return;
    }
    const std::optional<sim::Seam> seam = seam_between(context.geometry, *first_, *second_);
    if (!seam) return;
    const bool is_twisted = is_crossed(context.document.pattern(), *seam);
    const OverlayTone tone = is_twisted ? OverlayTone::Warning : OverlayTone::Draft;
    const std::vector<Vec2d> second = line_of(context.geometry, *second_);
    overlay.lines.push_back({.points = second, .tone = tone, .has_ticks = true});
    add_seam_lines(overlay, line_of(context.geometry, *first_), second, is_twisted ? tone : OverlayTone::Faint);
    const double other = context.geometry.edge(second_->edge)->length;
    overlay.readout = {in_cm(length) + " to " + in_cm(other)};
    if (const std::optional<std::string> text = difference_text(length, other)) overlay.readout.push_back(*text);
    if (is_twisted) overlay.readout.push_back("twisted? R turns it");
}

std::string SewingTool::hint(const ToolContext& context) const {
    if (first_) return "Click the other edge near the end that meets the first click; R turns it round";
    if (!context.document.selection().seams.empty())
        return "R: reverse the seam, Delete: remove it, drag along it: slide its ends";
    return "Click an edge near one of its ends";
}

namespace {

std::vector<Vec2d> line_of(const SheetGeometry& geometry, const std::vector<DrawnSpan>& run) {
    std::vector<Vec2d> line;
    for (const DrawnSpan& span : run) {
        const PanelShape* shape = geometry.find(span.edge.panel);
        if (shape == nullptr || geometry.edge(span.edge) == nullptr) return {};
        const std::vector<Vec2d> part = part_of_edge(*shape, span.edge.index, span.from, span.to);
        line.insert(line.end(), part.begin(), part.end());
    }
    return line;
}

}  // namespace

SewnRun run_of(const std::vector<DrawnSpan>& drawn) {
    if (drawn.empty()) throw GeometryError("Draw along an edge first");
    SewnRun run{.spans = {}, .is_forward = drawn.front().is_forward()};
    for (const DrawnSpan& span : drawn) {
        if (span.is_forward() != run.is_forward) {
            throw GeometryError("The parts of one side run both ways: draw them all the same way round",
                                {{.panel = span.edge.panel, .edge = span.edge.index}});
        }
        run.spans.push_back(
            {span.edge.panel, span.edge.index, std::min(span.from, span.to), std::max(span.from, span.to)});
    }
    if (!run.is_forward) std::reverse(run.spans.begin(), run.spans.end());
    return run;
}

double FreeSewingTool::length_of(const ToolContext& context, const std::vector<DrawnSpan>& run) const {
    double length = 0;
    for (const DrawnSpan& span : run) {
        if (const EdgeShape* edge = context.geometry.edge(span.edge))
            length += std::abs(span.to - span.from) * edge->length;
    }
    return length;
}

void FreeSewingTool::hover(ToolContext& context, const SheetPointer& pointer) {
    EdgeTool::hover(context, pointer);
    const EdgeShape* edge = place_ ? context.geometry.edge(place_->edge) : nullptr;
    if (edge == nullptr || !(edge->length > 0)) return;
    const double end = kSnapTolerance * context.px / edge->length;
    if (place_->t < end) place_->t = 0;
    if (place_->t > 1 - end) place_->t = 1;
}

void FreeSewingTool::press(ToolContext& context, const SheetPointer& pointer) {
    hover(context, pointer);
    pressed_ = place_;
    drawing_.reset();
}

// Adds the whole edge, from the end nearer to the click.
void FreeSewingTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (!pressed_) throw no_edge_error(context, pointer, "sewn");
    const bool is_forward = pressed_->t <= 0.5;
    add(context, {pressed_->edge, is_forward ? 0.0 : 1.0, is_forward ? 1.0 : 0.0}, pointer.modifiers.shift);
}

void FreeSewingTool::drag(ToolContext& context, const SheetPointer& pointer) {
    if (!pressed_) return;
    const PanelShape* shape = context.geometry.find(pressed_->edge.panel);
    const EdgeShape* edge = context.geometry.edge(pressed_->edge);
    if (shape == nullptr || edge == nullptr || !(edge->length > 0)) return;
    const SnapOptions options = snap_options(context, pointer.modifiers);
    double t = nearest(*edge, shape->in_panel(pointer.at)).t;
    const double end = options.tolerance / edge->length;
    if (options.is_on && t < end) t = 0;
    if (options.is_on && t > 1 - end) t = 1;
    if (options.is_on && t > 0 && t < 1) t = snap_along(*edge, t, options);
    // Snaps to the length at which both runs are equally long.
    if (is_second_ && options.is_on) {
        const double left = (length_of(context, first_) - length_of(context, second_)) / edge->length;
        const double wanted = t > pressed_->t ? pressed_->t + left : pressed_->t - left;
        if (left > 0 && wanted >= 0 && wanted <= 1 && std::abs(t - wanted) < end) t = wanted;
    }
    drawing_ = DrawnSpan{pressed_->edge, pressed_->t, t};
    place_ = EdgePoint{pressed_->edge, t};
}

void FreeSewingTool::drop(ToolContext& context, const SheetPointer& pointer) {
    if (!drawing_) return;
    const DrawnSpan span = *drawing_;
    drawing_.reset();
    if (span.from != span.to) add(context, span, pointer.modifiers.shift);
}

void FreeSewingTool::add(ToolContext& context, const DrawnSpan& span, bool goes_on) {
    current().push_back(span);
    if (!goes_on) end_run(context);
}

void FreeSewingTool::end_run(ToolContext& context) {
    if (current().empty()) return;
    if (!is_second_) {
        run_of(first_);  // reports errors of the first run at once
        is_second_ = true;
        return;
    }
    const std::vector<DrawnSpan> drawn = second_;
    second_.clear();
    const SewnRun first = run_of(first_), second = run_of(drawn);
    context.document.run(SewRuns{first.spans, second.spans, first.is_forward != second.is_forward});
    first_.clear();
    is_second_ = false;
}

bool FreeSewingTool::key(ToolContext& context, Key key, const Modifiers&) {
    if (key == Key::Enter || key == Key::KeypadEnter) {
        if (current().empty()) return false;
        end_run(context);
        return true;
    }
    if (key != Key::Backspace || (first_.empty() && second_.empty())) return false;
    if (second_.empty()) is_second_ = false;
    current().pop_back();
    return true;
}

bool FreeSewingTool::cancel(ToolContext&) {
    const bool was_begun = !first_.empty() || drawing_;
    first_.clear();
    second_.clear();
    is_second_ = false;
    drawing_.reset();
    pressed_.reset();
    return was_begun;
}

void FreeSewingTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    overlay.shows_sewing = true;
    EdgeTool::draw(context, overlay);
    std::vector<DrawnSpan> first = first_, second = second_;
    if (drawing_) (is_second_ ? second : first).push_back(*drawing_);
    for (const std::vector<DrawnSpan>* run : {&first, &second}) {
        for (const DrawnSpan& span : *run) {
            overlay.lines.push_back({.points = line_of(context.geometry, {span}), .has_ticks = true});
        }
    }
    if (first.empty()) return;
    const double length = length_of(context, first), other = length_of(context, second);
    overlay.readout = {in_cm(length)};
    if (second.empty()) return;
    add_seam_lines(overlay, line_of(context.geometry, first), line_of(context.geometry, second), OverlayTone::Faint);
    overlay.readout = {in_cm(length) + " to " + in_cm(other)};
    if (const std::optional<std::string> text = difference_text(length, other)) overlay.readout.push_back(*text);
}

std::string FreeSewingTool::hint(const ToolContext&) const {
    const std::string_view more = "; hold Shift for more parts, Enter ends them";
    return std::string(is_second_ ? "Drag along what it is sewn to" : "Drag along an edge, or click it whole")
        .append(more);
}

}  // namespace selvedge::editor
