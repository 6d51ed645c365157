#pragma once
// Tools that draw something new: polygon, rectangle and ellipse, internal line, cut.
#include <vector>

#include "editor/tools/tool.h"

namespace selvedge::editor {

// A line that is drawn point by point: what polygon, internal line, cut and others have in common.

struct PathPoint {
    Vec2d at = Vec2d::Zero();  // on the sheet, m
    bool is_curve = false;     // the line runs through it in a curve
};

class PathInProgress {
 public:
    // Where the next point would come: snapped, or so far along as is typed.
    void aim(const ToolContext& context, const SheetPointer& pointer);

    void aim_at(const Vec2d& at) { aimed_ = {at, SnapKind::Point, {}}; }

    // Pre: it was aimed.
    void add(bool is_curve);
    void add_at(const Vec2d& at) { points_.push_back({at, false}); }

    // The next point at a length (m) in the direction of the cursor.
    void add_at_length(double length);

    bool remove_last();
    void clear() { points_.clear(); }

    bool is_empty() const { return points_.empty(); }
    const std::vector<PathPoint>& points() const { return points_; }
    std::vector<Vec2d> places() const;
    const Vec2d& aimed() const { return aimed_.point; }

    // Whether the aimed point is the first one again, with three or more drawn.
    bool is_closing(double tolerance) const;

    void draw(const ToolContext& context, ToolOverlay& overlay, bool is_closed) const;

 private:
    std::vector<PathPoint> points_;
    Snap aimed_;
};

// The outline through the points, counter-clockwise; runs of one or two curve points bend the edge that they are on,
// further ones become vertices. Vertices are relative to the middle of the whole, where the panel's sheet_position is.
// Throws GeometryError for fewer than three points, or two with no curve between them.
sim::Panel outline_through(std::vector<PathPoint> points);

// The same as a polyline, open or closed, for showing.
std::vector<Vec2d> polyline_through(const std::vector<PathPoint>& points, bool is_closed);

// Puts the panel before the body, at chest height, so that it is not born inside of it; beside those there are.
sim::Panel placed_before_body(const sim::Pattern& pattern, sim::Panel panel);

// Click by click; Backspace takes the last point back, Enter ends, a typed length sets the next point.
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
    virtual bool is_done(const ToolContext& context) const = 0;  // with the point that was just added
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

// The axis of a mirror: two clicks.
class MirrorTool : public PathTool {
 public:
    std::string hint(const ToolContext& context) const override;
    void draw(const ToolContext& context, ToolOverlay& overlay) const override;

 protected:
    bool is_done(const ToolContext& context) const override;
    Command command(const ToolContext& context) const override;
};

enum class BoxShape { Rectangle, Ellipse };

// Drags a box open; or click a corner, then click the other or type width x height.
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
    bool is_new_ = false;  // the corner was set by the press that is under way
    Snap aimed_;
};

}  // namespace selvedge::editor
