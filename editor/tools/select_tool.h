#pragma once
// Select and move: panels, edges and points, by click and by box.
#include "editor/tools/tool.h"

namespace selvedge {

// Whether what is picked is selected already.
bool is_selected(const Selection& selection, const Pick& picked);

// Selects what is picked: alone, or, where `toggles`, beside the rest or no longer.
Selection with_picked(const Selection& selection, const Pick& picked, bool toggles);

// A box that is dragged open: to the right it takes what is inside, to the left what it touches.
struct BoxDrag {
    Vec2d from = Vec2d::Zero();
    Vec2d to = Vec2d::Zero();

    SheetBox box() const { return {from.cwiseMin(to), from.cwiseMax(to)}; }
    BoxRule rule() const { return to.x() >= from.x() ? BoxRule::Inside : BoxRule::Touching; }
};

// Panels, points and edges together; used by Select and move, and by Edit point with points alone.
class SelectTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 protected:
    virtual PickOptions wanted(const ToolContext& context) const;
    virtual Selection boxed(const ToolContext& context) const;
    SheetBox box() const { return box_.box(); }

    Pick pressed_;

 private:
    enum class Drag { None, Move, Box };

    void begin_move(ToolContext& context, const SheetPointer& pointer);
    void move_to(ToolContext& context, const SheetPointer& pointer);

    Drag drag_ = Drag::None;
    BoxDrag box_;
    bool was_selected_ = false;
    Vec2d pressed_at_ = Vec2d::Zero();
    Vec2d held_ = Vec2d::Zero();  // the point that snaps, before the drag
    Vec2d by_ = Vec2d::Zero();
    SnapOptions moving_;
    Snap snapped_;
    Selection moved_;     // what is dragged
    std::string copied_;  // the panel that an Alt-drag copies; empty: it moves
};

}  // namespace selvedge
