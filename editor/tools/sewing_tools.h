#pragma once
// Sewing edge to edge: click one, then the other; the ends nearer to the clicks meet.
#include "editor/tools/outline_tools.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {

// An edge, entered at its start or at its end.
struct SewnEnd {
    PartRef edge;
    bool is_from_start = true;

    bool operator==(const SewnEnd&) const = default;
};

// How the two are sewn so that the ends at which they are entered meet (Seam::is_reversed).
bool is_reversed(const SewnEnd& first, const SewnEnd& second);

// The seam with panels by index. None: an edge is not there.
std::optional<sim::Seam> seam_between(const SheetGeometry& geometry, const SewnEnd& first, const SewnEnd& second);

// Threads between two lines, from start to start.
void add_threads(ToolOverlay& overlay, const std::vector<Vec2d>& first, const std::vector<Vec2d>& second,
                 OverlayTone tone);

// The difference of lengths, when it is one to be told.
std::optional<std::string> difference_text(double first, double second);

class SewingTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    bool key(ToolContext& context, Key key, const Modifiers& modifiers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    std::optional<SewnEnd> end_at(const ToolContext& context, const SheetPointer& pointer) const;

    std::optional<SewnEnd> first_;
    std::optional<SewnEnd> second_;  // under the cursor
    bool is_turned_ = false;         // R: the second is entered at its other end
};

// The middle of the seam's first side, where a click on the tick of a selected seam reverses it; on the sheet, m.
std::optional<Vec2d> seam_button(const SheetGeometry& geometry, const sim::Pattern& pattern, int seam);

// Sewing parts of edges: draw a run along one or several edges, then what it is sewn to. One to many.

// A part of an edge in the direction in which it was drawn: from > to is against the outline.
struct DrawnSpan {
    PartRef edge;
    double from = 0;
    double to = 0;

    bool is_forward() const { return to >= from; }
};

// Spans along the outline, in its order, and whether they were drawn that way. Throws GeometryError where pieces run
// both ways, or there are none.
struct SewnRun {
    std::vector<SpanRef> spans;
    bool is_forward = true;
};
SewnRun run_of(const std::vector<DrawnSpan>& drawn);

class FreeSewingTool : public EdgeTool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool key(ToolContext& context, Key key, const Modifiers& modifiers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    std::vector<DrawnSpan>& current() { return is_second_ ? second_ : first_; }
    void add(ToolContext& context, const DrawnSpan& span, bool goes_on);
    void end_run(ToolContext& context);
    double length_of(const ToolContext& context, const std::vector<DrawnSpan>& run) const;

    std::vector<DrawnSpan> first_;
    std::vector<DrawnSpan> second_;
    bool is_second_ = false;
    std::optional<EdgePlace> pressed_;
    std::optional<DrawnSpan> drawing_;
};

}  // namespace selvedge::editor
