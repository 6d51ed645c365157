#pragma once
// Builds DrawnPaths from pen movements, as SVG paths and FreeSewing's operations give them: lines, Bezier curves and
// circular arcs, in the units of the file.
#include <optional>
#include <string>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

class PathBuilder {
 public:
    void move(const Vec2d& to);  // begins a new path; the one before stays open
    void line(const Vec2d& to);
    void quadratic(const Vec2d& control, const Vec2d& to);
    void cubic(const Vec2d& control1, const Vec2d& control2, const Vec2d& to);
    void arc(double radius, bool is_large, bool turns_right, const Vec2d& to);
    void close();  // with a line if there is a gap

    // All paths with an edge, the builder is empty then. Edges that are not longer than `shortest` are dropped.
    // Ends that are at most `gap` apart are one point, and the path is closed.
    std::vector<DrawnPath> take(double shortest, double gap);

    Vec2d position() const { return position_; }

 private:
    void add(OutlineEdge edge, const Vec2d& to);

    std::vector<DrawnPath> paths_;
    Vec2d position_ = Vec2d::Zero();
};

// Turns y up: (x, y) becomes (x, -y).
void flip(DrawnPath& path);

// The path under a map of the plane. Pre: the map is a similarity if the path has arcs.
void transform(DrawnPath& path, const Eigen::Affine2d& map);

// Of a path that is not closed, how far its ends lie apart, file units.
double gap_of(const DrawnPath& path);

// "open by 1.2 mm"; "open by 12 units" where the file names no unit.
std::string open_by(double gap, const std::optional<double>& metres_per_unit);

// Whether an open path was meant for an outline: it has corners, and its ends nearly meet.
bool nearly_closes(const DrawnPath& path);

// The path as an outline, for the functions of sim/pattern/outline.h. It may be open.
Panel as_panel(const DrawnPath& path);

}  // namespace selvedge::sim
