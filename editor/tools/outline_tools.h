#pragma once
// Tools that act at a point of an outline: add point, curve, notch, dart.
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/tool.h"

namespace selvedge::editor {

// A place on an edge that the cursor points to.
struct EdgePlace {
    PartRef edge;
    double t = 0;  // fraction of its length
};

// The edge under the cursor; at the length (m) from its end that is nearer to the cursor where one is typed, else
// snapped. None: no edge is near.
std::optional<EdgePlace> edge_place(const ToolContext& context, const SheetPointer& pointer);

// The same at a length from that end.
EdgePlace at_length(const SheetGeometry& geometry, const EdgePlace& place, double length);

class EdgeTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;

 protected:
    std::optional<EdgePlace> place_;
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
    std::optional<PartRef> held_;  // the notch that is dragged
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

// The legs of a dart before it is cut, to be shown: mouth, tip, mouth, on the sheet.
std::vector<Vec2d> dart_lines(const PanelShape& shape, const EdgePlace& place, double width, double depth);

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

    std::optional<EdgePlace> mouth_;  // where it was begun
    double width_ = 0.03;             // m, of the last one: the next is as wide
    double depth_ = 0.10;             // m
};

// Bending an edge by a point of it.

// The curve with its handles moved so that the point at the fraction t of its length comes to `to` (held frame, m). A
// line becomes a quadratic; an arc stays one. Near the ends the handles would fly off: t counts from 0.1 to 0.9.
sim::OutlineEdge bent_through(const sim::Panel& panel, const sim::OutlineEdge& edge, double t, const Vec2d& to);

// A circular arc from end to end through the point; a line where they are in line.
sim::OutlineEdge arc_through(const sim::Panel& panel, const sim::OutlineEdge& edge, const Vec2d& to);

// A quadratic or cubic of the same shape as a line or quadratic: handles to take hold of.
sim::OutlineEdge as_cubic_edge(const sim::Panel& panel, const sim::OutlineEdge& edge);

}  // namespace selvedge::editor
