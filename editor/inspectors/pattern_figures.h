#pragma once
// What is read off a pattern to be shown in boxes, and the maps and curves that typed figures stand for. Metres and
// radians.
#include <optional>
#include <string>

#include "editor/document/command.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// GT XYZ: the middle between the farthest points of all panels as they are placed; the origin where there are none.
Vec3d garment_centre(const sim::Pattern& pattern);

// Angles about x, y and z, of which Rz Ry Rx is the rotation: each in (-pi, pi], y in [-pi/2, pi/2]. Where y is a right
// angle, x is 0.
Vec3d angles_of(const Eigen::Matrix3d& rotation);
Eigen::Matrix3d rotation_of(const Vec3d& angles);

struct PlaneBox {
    Vec2d low = Vec2d::Zero();
    Vec2d high = Vec2d::Zero();

    Vec2d size() const { return high - low; }
    Vec2d centre() const { return (low + high) / 2; }
};

// About the outline with its curves, in the panel's frame.
PlaneBox panel_box(const sim::Panel& panel);

double panel_perimeter(const sim::Panel& panel);

// S XY about a point of the sheet.
PlaneMap scale_about(const Vec2d& centre, const Vec2d& factors);

// The edge as a curve of another kind that lies as near to it as is easily had.
sim::OutlineEdge with_kind(const sim::Panel& panel, const sim::OutlineEdge& edge, sim::CurveKind kind);

// How far the end of the edge, as it was, is to go for it to get another length, its start and direction kept. The edge
// may have been tried with other lengths meanwhile. Zero where one of them is not positive.
struct LengthChange {
    double before = 0;  // m
    double after = 0;   // m
};
Vec2d shift_for_length(const sim::Panel& panel, const sim::OutlineEdge& edge, const LengthChange& change);

// An arc through the ends of the edge has half the chord at least.
double least_arc_radius(const sim::Panel& panel, const sim::OutlineEdge& edge);

struct SeamFigures {
    std::string name;
    double first = 0;   // m
    double second = 0;  // m
    bool is_uneven = false;
    bool is_eased = false;

    double difference() const { return second - first; }  // m
    bool is_wrong() const { return is_uneven && !is_eased; }
};

// Pre: the seam's panels and edges are there.
SeamFigures seam_figures(const sim::Pattern& pattern, const sim::Seam& seam);

// "+3.2 mm": what the second side has more than the first.
std::string difference_text(const SeamFigures& figures);

// The seam of that edge.
std::optional<int> seam_along(const sim::Pattern& pattern, const sim::SeamSide& side);

// The panel's index, or none.
std::optional<int> panel_index(const sim::Pattern& pattern, const std::string& name);

}  // namespace selvedge::editor
