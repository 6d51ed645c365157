#pragma once
// A line that is drawn point by point: what polygon, internal line, cut and others have in common.
#include <vector>

#include "editor/tools/tool.h"

namespace selvedge {

struct PathPoint {
    Vec2d at = Vec2d::Zero();  // on the sheet, m
    bool is_curve = false;     // the line runs through it in a curve
};

class PathDraft {
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
// Throws DraftError for fewer than three points, or two with no curve between them.
Panel outline_through(std::vector<PathPoint> points);

// The same as a polyline, open or closed, for showing.
std::vector<Vec2d> polyline_through(const std::vector<PathPoint>& points, bool is_closed);

// Puts the panel before the body, at chest height, so that it is not born inside of it; beside those there are.
Panel placed_before_body(const Pattern& pattern, Panel panel);

}  // namespace selvedge
