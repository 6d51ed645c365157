#pragma once
// Rotate and scale what is selected: by handles at its box, or typed.
#include "editor/tools/tool.h"

namespace selvedge {

enum class TransformMode { Rotate, Scale };

class TransformTool : public Tool {
 public:
    explicit TransformTool(TransformMode mode) : mode_(mode) {}

    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    void rotate(ToolContext& context, const SheetPointer& pointer);
    void scale(ToolContext& context, const SheetPointer& pointer);
    void attempt(ToolContext& context, const PlaneMap& map);

    TransformMode mode_;
    Pick pressed_;
    Selection held_;  // what is turned or scaled
    SheetBox box_;    // of it before the drag
    Vec2d pressed_at_ = Vec2d::Zero();
    std::optional<Vec2d> handle_;  // -1, 0 or 1 per axis: a corner or the middle of a side
    bool is_dragging_ = false;
    double angle_ = 0;
    Vec2d factors_ = Vec2d(1, 1);
};

}  // namespace selvedge
