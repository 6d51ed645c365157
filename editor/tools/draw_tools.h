#pragma once
// Tools that draw a path or a box on the sheet: polygon, rectangle, ellipse, internal line, cut and mirror axis.
#include <vector>

#include "editor/tools/tool.h"

namespace selvedge::editor {

// A path drawn point by point, shared by polygon, internal line, cut and mirror.

struct PathPoint {
    Vec2d at = Vec2d::Zero();  // on the sheet, m
    bool is_curve = false;     // the path curves through this point
};

class PathInProgress {
 public:
    // Computes the next point: snapped, or at the typed length in the direction of the cursor.
    void aim(const ToolContext& context, const SheetPointer& pointer);

    void aim_at(const Vec2d& at) { aimed_ = {at, SnapKind::Point, {}}; }

    // Adds the aimed point. Pre: aim or aim_at was called.
    void add(bool is_curve);
    void add_at(const Vec2d& at) { points_.push_back({at, false}); }

    // Adds a point at this distance (m) from the last one, in the direction of the cursor.
    void add_at_length(double length);

    bool remove_last();
    void clear() { points_.clear(); }

    bool is_empty() const { return points_.empty(); }
    const std::vector<PathPoint>& points() const { return points_; }
    std::vector<Vec2d> places() const;
    const Vec2d& aimed() const { return aimed_.point; }

    // Whether the path has three points or more and the aimed point is within the tolerance (m) of the first.
    bool is_closing(double tolerance) const;

    void draw(const ToolContext& context, ToolOverlay& overlay, bool is_closed) const;

 private:
    std::vector<PathPoint> points_;
    Snap aimed_;
};

// A panel with a counter-clockwise outline through the points. One or two consecutive curve points shape the edge that
// they are on; further ones become vertices. Vertices are relative to the centre of the bounding box, which is the
// panel's sheet_position. Throws GeometryError for fewer than three points or fewer than two vertices.
sim::Panel outline_through(std::vector<PathPoint> points);

// The same path as a polyline, open or closed, for display.
std::vector<Vec2d> polyline_through(const std::vector<PathPoint>& points, bool is_closed);

// Base of the tools that draw a path. A click adds a point, Backspace removes the last one, Enter ends the path, a
// typed length (cm) sets the next point.
class PathTool : public Tool {
 public:
    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    void double_click(ToolContext& context, const SheetPointer& pointer) override;
    bool key(ToolContext& context, Key key, const Modifiers& modifiers) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;

 protected:
    virtual bool is_closed() const { return false; }
    virtual bool is_done(const ToolContext& context) const = 0;  // called after each added point
    virtual Command command(const ToolContext& context) const = 0;
    virtual void refine_aim(const ToolContext&, const SheetPointer&) {}

    PathInProgress path_;
    Modifiers modifiers_{};  // at the last click

 private:
    void finish(ToolContext& context);
};

class PolygonTool : public PathTool {
 public:
    void click(ToolContext& context, const SheetPointer& pointer) override;
    std::string hint(const ToolContext& context) const override;

 protected:
    bool is_closed() const override { return true; }
    bool is_done(const ToolContext& context) const override;
    Command command(const ToolContext& context) const override;
};

class InternalLineTool : public PathTool {
 public:
    std::string hint(const ToolContext& context) const override;

 protected:
    bool is_done(const ToolContext&) const override { return false; }
    Command command(const ToolContext& context) const override;
};

class CutTool : public PathTool {
 public:
    std::string hint(const ToolContext& context) const override;

 protected:
    bool is_done(const ToolContext& context) const override;
    Command command(const ToolContext& context) const override;
    void refine_aim(const ToolContext& context, const SheetPointer& pointer) override;
};

// Mirrors the selection over an axis given by two clicks.
class MirrorTool : public PathTool {
 public:
    std::string hint(const ToolContext& context) const override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;

 protected:
    bool is_done(const ToolContext& context) const override;
    Command command(const ToolContext& context) const override;
};

enum class BoxShape { Rectangle, Ellipse };

// Draws a rectangular or elliptic panel: drag a box, or click a corner and then click the opposite one or type width x
// height (cm).
class BoxTool : public Tool {
 public:
    explicit BoxTool(BoxShape shape) : shape_(shape) {}

    void hover(ToolContext& context, const SheetPointer& pointer) override;
    void press(ToolContext& context, const SheetPointer& pointer) override;
    void click(ToolContext& context, const SheetPointer& pointer) override;
    void drag(ToolContext& context, const SheetPointer& pointer) override;
    void drop(ToolContext& context, const SheetPointer& pointer) override;
    bool enter(ToolContext& context, const std::vector<double>& numbers) override;
    bool cancel(ToolContext& context) override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;
    std::string hint(const ToolContext& context) const override;

 private:
    void aim(const ToolContext& context, const SheetPointer& pointer);
    void make(ToolContext& context);

    BoxShape shape_;
    std::optional<Vec2d> from_;
    bool is_new_ = false;  // the current press set the first corner
    Snap aimed_;
};

}  // namespace selvedge::editor
