#pragma once
// Tools that act at a point of an edge (add point, curve, notch, dart), and the geometry of bending an edge.
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {

// A position on an edge.
struct EdgePoint {
    PartRef edge;
    double t = 0;  // fraction of the edge's length
};

// The snapped position on the edge under the cursor. None: no edge within the tolerance.
std::optional<EdgePoint> edge_point_at(const ToolContext& context, const SheetPointer& pointer);

// The position at a length (m) from the end of the edge that is nearer to `place`. Throws GeometryError if the edge is
// too short.
EdgePoint at_length(const SheetGeometry& geometry, const EdgePoint& place, double length);

// Why a click at the pointer reaches no edge, and what to do. `use`: what the tool would have done, "notched".
GeometryError no_edge_error(const ToolContext& context, const SheetPointer& pointer, const std::string& use);

// Base of the tools that act at a position on an edge. Marks the position and its distances to both ends.
class EdgeTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;

 protected:
    // Throws GeometryError that says why there is no edge to use where the user clicked. `use`: "notched".
    void require_place(const ToolContext& context, const SheetPointer& pointer, const std::string& use) const;

    std::optional<EdgePoint> place_;
};

class AddPointTool : public EdgeTool {
 public:
    void click(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    std::string hint(const ToolContext& context) const override;
};

class NotchTool : public EdgeTool {
 public:
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    std::string hint(const ToolContext& context) const override;

 private:
    std::optional<PartRef> held_;  // the notch being dragged
};

class CurveTool : public EdgeTool {
 public:
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    void double_click(ToolContext& context, const SheetPointer& pointer) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    PickOptions wanted(const ToolContext& context) const;

    Pick pressed_;       // an edge or a handle
    sim::Panel before_;  // the panel before the drag
    bool is_dragging_ = false;
};

// Preview of a dart's legs on the sheet: mouth, apex, mouth. Width and depth in m.
std::vector<Vec2d> dart_lines(const PanelShape& shape, const EdgePoint& place, double width, double depth);

class DartTool : public EdgeTool {
 public:
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    void make(ToolContext& context);

    std::optional<EdgePoint> mouth_;  // position of the dart that was begun
    double width_ = 0.03;             // m, kept for the next dart
    double depth_ = 0.10;             // m
};

// Bending an edge by dragging a point of it.

// Moves the control points so that the curve point at the fraction t of its length moves to `to` (held frame, m). A
// line becomes a quadratic; an arc stays an arc. The curve parameter is clamped to [0.1, 0.9], because near the ends
// the control points would move very far.
sim::OutlineEdge bent_through(const sim::Panel& panel, const sim::OutlineEdge& edge, double t, const Vec2d& to);

// A circular arc between the edge's ends through the point `to`; a line if the three points are collinear.
sim::OutlineEdge arc_through(const sim::Panel& panel, const sim::OutlineEdge& edge, const Vec2d& to);

// A cubic with the same shape as a line, quadratic or cubic edge. An arc becomes a straight cubic.
sim::OutlineEdge as_cubic_edge(const sim::Panel& panel, const sim::OutlineEdge& edge);

}  // namespace selvedge::editor
