#pragma once
// Select and move: panels, edges and points, by click and by box.
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {

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

// Edit point: points and curve handles; a double click on an edge adds a point, points of internal lines move, too.

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
    sim::OutlineEdge curve_;         // before the drag
    sim::InternalLine line_;
    std::size_t line_point_ = 0;
    Snap snapped_;
};

// What is selected, as tools act on it.

// The vertices that move with the selection, ends of selected edges included; those of selected panels not.
std::vector<PartRef> selected_vertices(const SheetGeometry& geometry, const Selection& selection);

// Moves selected panels, or else selected vertices and edges. None: nothing of these is selected.
std::optional<Command> move_selected(const SheetGeometry& geometry, const Selection& selection, const Vec2d& by);

// A map of the sheet for the same. `what`: the word for the history.
std::optional<Command> transform_selected(const SheetGeometry& geometry, const Selection& selection,
                                          const PlaneMap& map, const std::string& what);

// The panels that have any part selected.
std::set<std::string> touched_panels(const Selection& selection);

PlaneMap rotation_about(const Vec2d& centre, double angle);
PlaneMap scaling_about(const Vec2d& centre, const Vec2d& factors);
PlaneMap mirror_over(const Vec2d& on_axis, const Vec2d& direction);  // Pre: the direction is not zero
Vec2d apply(const PlaneMap& map, const Vec2d& p);

// Rotate and scale what is selected: by handles at its box, or typed.

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
    void preview(ToolContext& context, const PlaneMap& map);

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

}  // namespace selvedge::editor
