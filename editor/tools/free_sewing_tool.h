#pragma once
// Sewing parts of edges: draw a run along one or several edges, then what it is sewn to. One to many.
#include "editor/tools/outline_tools.h"

namespace selvedge {

// A part of an edge in the direction in which it was drawn: from > to is against the outline.
struct DrawnSpan {
    PartRef edge;
    double from = 0;
    double to = 0;

    bool is_forward() const { return to >= from; }
};

// Spans along the outline, in its order, and whether they were drawn that way. Throws DraftError where pieces run both
// ways, or there are none.
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

}  // namespace selvedge
