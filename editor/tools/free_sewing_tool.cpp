#include "editor/tools/free_sewing_tool.h"

#include <algorithm>
#include <cmath>

#include "editor/drafting/draft_error.h"
#include "editor/tools/overlay_parts.h"
#include "editor/tools/sewing_tool.h"

namespace selvedge {
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
    if (drawn.empty()) throw DraftError("Draw along an edge first");
    SewnRun run{.spans = {}, .is_forward = drawn.front().is_forward()};
    for (const DrawnSpan& span : drawn) {
        if (span.is_forward() != run.is_forward) {
            throw DraftError("The parts of one side run both ways: draw them all the same way round",
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

// All of the edge, from the end that is nearer.
void FreeSewingTool::click(ToolContext& context, const SheetPointer& pointer) {
    if (!pressed_) return;
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
    // As long as what it is sewn to, where it nearly is.
    if (is_second_ && options.is_on) {
        const double left = (length_of(context, first_) - length_of(context, second_)) / edge->length;
        const double wanted = t > pressed_->t ? pressed_->t + left : pressed_->t - left;
        if (left > 0 && wanted >= 0 && wanted <= 1 && std::abs(t - wanted) < end) t = wanted;
    }
    drawing_ = DrawnSpan{pressed_->edge, pressed_->t, t};
    place_ = EdgePlace{pressed_->edge, t};
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
        run_of(first_);  // says what is wrong now rather than later
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
    add_threads(overlay, line_of(context.geometry, first), line_of(context.geometry, second), OverlayTone::Faint);
    overlay.readout = {in_cm(length) + " to " + in_cm(other)};
    if (const std::optional<std::string> words = difference_words(length, other)) overlay.readout.push_back(*words);
}

std::string FreeSewingTool::hint(const ToolContext&) const {
    const std::string_view more = "; hold Shift for more parts, Enter ends them";
    return std::string(is_second_ ? "Drag along what it is sewn to" : "Drag along an edge, or click it whole")
        .append(more);
}

}  // namespace selvedge
