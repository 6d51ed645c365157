#pragma once
// Edit point: points and curve handles; a double click on an edge adds a point, points of internal lines move, too.
#include "editor/tools/select_tool.h"

namespace selvedge {

class EditPointTool : public SelectTool {
 public:
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    void double_click(ToolContext& context, const SheetPointer& pointer) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 protected:
    PickOptions wanted(const ToolContext& context) const override;
    Selection boxed(const ToolContext& context) const override;

 private:
    void drag_handle(ToolContext& context, const SheetPointer& pointer);
    void drag_line_point(ToolContext& context, const SheetPointer& pointer);

    bool is_dragging_part_ = false;  // a handle or a point of an internal line
    OutlineEdge curve_;              // before the drag
    InternalLine line_;
    std::size_t line_point_ = 0;
    Snap snapped_;
};

}  // namespace selvedge
