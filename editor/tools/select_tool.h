#pragma once
// The tools select and move, edit point, rotate and scale; the commands that act on a selection; maps of the sheet.
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {

// Whether the picked part is selected.
bool is_selected(const Selection& selection, const Pick& picked);

// Selects the picked part alone; with `toggles`, adds it to the selection or removes it.
Selection with_picked(const Selection& selection, const Pick& picked, bool toggles);

// A selection box. Dragged to the right it selects parts fully inside; dragged to the left also parts that it touches.
struct BoxDrag {
    Vec2d from = Vec2d::Zero();
    Vec2d to = Vec2d::Zero();

    SheetBox box() const { return {from.cwiseMin(to), from.cwiseMax(to)}; }
    BoxRule rule() const { return to.x() >= from.x() ? BoxRule::Inside : BoxRule::Touching; }
};

// Selects and moves panels, points and edges. Base of EditPointTool, whose box selects points only.
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
    Vec2d held_ = Vec2d::Zero();  // the point that snaps, at its position before the drag
    Vec2d by_ = Vec2d::Zero();
    SnapOptions moving_;
    Snap snapped_;
    Selection moved_;                  // the dragged parts
    bool is_copying_ = false;          // an Alt-drag, which copies the panels of moved_
    Vec3d copy_move_ = Vec3d::Zero();  // m, in world space, of the copies
};

// Edit point: drags points, curve handles and points of internal lines; a double click on an edge adds a point.

class EditPointTool : public SelectTool {
 public:
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    void double_click(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 protected:
    PickOptions wanted(const ToolContext& context) const override;
    Selection boxed(const ToolContext& context) const override;

 private:
    void drag_handle(ToolContext& context, const SheetPointer& pointer);
    void drag_line_point(ToolContext& context, const SheetPointer& pointer);

    bool is_dragging_part_ = false;  // dragging a handle or a point of an internal line
    sim::OutlineEdge curve_;         // before the drag
    sim::InternalLine line_;
    std::size_t line_point_ = 0;
    Snap snapped_;
};

// Commands on the selection.

// The vertices that move with the selection: selected vertices and ends of selected edges, without those of selected
// panels.
std::vector<PartRef> selected_vertices(const SheetGeometry& geometry, const Selection& selection);

// Moves the selected panels; if there are none, the selected vertices and edges. None: nothing to move is selected.
std::optional<Command> move_selected(const SheetGeometry& geometry, const Selection& selection, const Vec2d& by);

// Applies a map in sheet coordinates to the same parts. `what`: the verb of the history label.
std::optional<Command> transform_selected(const SheetGeometry& geometry, const Selection& selection,
                                          const PlaneMap& map, const std::string& what);

// The panels that are selected or have a selected part.
std::set<std::string> touched_panels(const Selection& selection);

PlaneMap rotation_about(const Vec2d& centre, double angle);
PlaneMap scaling_about(const Vec2d& centre, const Vec2d& factors);
PlaneMap mirror_over(const Vec2d& on_axis, const Vec2d& direction);  // Pre: direction != 0
Vec2d apply(const PlaneMap& map, const Vec2d& p);

// Rotates or scales the selection by the handles of its bounding box, or by typed values.

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
    Vec2d centre(const ToolContext& context) const;
    void put_pivot(const ToolContext& context, const SheetPointer& pointer);
    void rotate(ToolContext& context, const SheetPointer& pointer);
    void scale(ToolContext& context, const SheetPointer& pointer);
    void preview(ToolContext& context, const PlaneMap& map);

    TransformMode mode_;
    Pick pressed_;
    Selection held_;  // the selection being transformed
    SheetBox box_;    // its bounding box before the drag
    Vec2d pressed_at_ = Vec2d::Zero();
    std::optional<Vec2d> handle_;  // -1, 0 or 1 per axis: a corner or a side's middle
    bool is_dragging_ = false;
    std::set<PartRef> scaled_;  // the points that are scaled along, of linked panels and halves too
    double angle_ = 0;
    Vec2d factors_ = Vec2d(1, 1);
    std::optional<Vec2d> pivot_;    // about which to rotate; none: the middle of the box
    Selection pivot_of_;            // it holds while this is selected
    bool moves_pivot_ = false;      // the drag does
    Vec2d centre_ = Vec2d::Zero();  // of the drag
};

}  // namespace selvedge::editor
