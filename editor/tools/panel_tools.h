#pragma once
// The one-click tools merge and unfold, and the measure tool.
#include "editor/tools/outline_tools.h"

namespace selvedge::editor {

class MergeTool : public EdgeTool {
 public:
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;
};

class UnfoldTool : public EdgeTool {
 public:
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;
};

class MeasureTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    void press(ToolContext& context, const SheetPointer& pointer) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    struct End {
        Vec2d at = Vec2d::Zero();
        std::optional<EdgePoint> place;  // set if the end is on an edge
    };

    End end_at(const ToolContext& context, const SheetPointer& pointer);

    std::optional<End> from_;
    End to_;
    bool is_done_ = false;  // the measurement is complete and stays visible
    bool is_new_ = false;
    Snap aimed_;
};

}  // namespace selvedge::editor
