#pragma once
// The two sewing tools. SewingTool joins two whole edges: click one, then the other; the ends nearer to the clicks
// meet. A drag along an edge of a selected seam slides that run of it. FreeSewingTool joins runs of parts of edges.
#include "editor/tools/outline_tools.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {

// An edge with the end from which it is sewn.
struct SewnEnd {
    PartRef edge;
    bool is_from_start = true;

    bool operator==(const SewnEnd&) const = default;
};

// The value of Seam::is_reversed with which the two given ends meet.
bool is_reversed(const SewnEnd& first, const SewnEnd& second);

// The seam between the two edges. None: an edge does not exist.
std::optional<sim::Seam> seam_between(const SheetGeometry& geometry, const SewnEnd& first, const SewnEnd& second);

// Adds seven lines that connect two polylines at equal fractions of their lengths, from start to end.
void add_seam_lines(ToolOverlay& overlay, const std::vector<Vec2d>& first, const std::vector<Vec2d>& second,
                    OverlayTone tone);

// The difference of two lengths (m) as text. None: it is at most kUnevenSeam (1 mm).
std::optional<std::string> difference_text(double first, double second);

class SewingTool : public Tool {
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
    // A run of a selected seam that is slid along its outline.
    struct Slide {
        SlideSewing command;
        Vec2d from;   // where it was pressed, on the sheet, m
        Vec2d along;  // unit tangent of the outline there
    };

    std::optional<SewnEnd> end_at(const ToolContext& context, const SheetPointer& pointer) const;
    void reverse_selected(ToolContext& context) const;

    std::optional<Slide> slide_;
    std::optional<SewnEnd> first_;
    std::optional<SewnEnd> second_;  // under the cursor
    bool is_turned_ = false;         // toggled by R: the second edge is sewn from its other end
};

// The middle of the seam's first side, on the sheet, m. A click there reverses a selected seam.
std::optional<Vec2d> seam_button(const SheetGeometry& geometry, const sim::Pattern& pattern, int seam);

// Free sewing (one to many): draw a run along one or several edges, then the run it is sewn to.

// A part of an edge, with fractions of its length in drawing order: from > to means against the outline's direction.
struct DrawnSpan {
    PartRef edge;
    double from = 0;
    double to = 0;

    bool is_forward() const { return to >= from; }
};

// Spans in outline order, and whether they were drawn in that order. run_of throws GeometryError if the drawn parts
// have different directions, or if there are none.
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
    std::optional<EdgePoint> pressed_;
    std::optional<DrawnSpan> drawing_;
};

}  // namespace selvedge::editor
