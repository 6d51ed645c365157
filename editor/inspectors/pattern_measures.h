#pragma once
// Measurements of a pattern for display, and the transforms and curves that typed values define. Lengths in m, angles
// in rad.
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// Centre of the bounding box of all placed panels' vertices (GT XYZ, thesis fig. 4.2); the origin if there are none.
Vec3d garment_centre(const sim::Pattern& pattern);

// Euler angles about x, y and z with rotation = Rz Ry Rx. x and z lie in (-pi, pi], y in [-pi/2, pi/2]. At y = +-pi/2,
// x is 0.
Vec3d angles_of(const Eigen::Matrix3d& rotation);
Eigen::Matrix3d rotation_of(const Vec3d& angles);

double panel_perimeter(const sim::Panel& panel);

// Scales by `factors` (S XY, thesis fig. 4.2) about a point of the sheet.
PlaneMap scale_about(const Vec2d& centre, const Vec2d& factors);

// Converts the edge to another kind of curve that approximates its shape.
sim::OutlineEdge with_kind(const sim::Panel& panel, const sim::OutlineEdge& edge, sim::CurveKind kind);

// The shift of the edge's end point that changes its length as `change` says; the start and the chord's direction stay.
// `edge` may hold a previewed length. Zero if one of the lengths is not positive.
struct LengthChange {
    double before = 0;  // m
    double after = 0;   // m
};
Vec2d shift_for_length(const sim::Panel& panel, const sim::OutlineEdge& edge, const LengthChange& change);

// How an edge takes another length. Ends move along the chord; Parallel: both slide along the neighbouring edges, so
// that the edge keeps its direction.
enum class LengthMove { End, Start, Both, Parallel };

// The command that gives the edge another length. Throws GeometryError where that is not possible.
Command command_for_length(const sim::Pattern& pattern, const PartRef& edge, LengthMove move,
                           const LengthChange& change);

// The smallest radius of an arc through the edge's ends: half the chord, m.
double min_arc_radius(const sim::Panel& panel, const sim::OutlineEdge& edge);

struct SeamMeasures {
    std::string name;
    std::vector<std::string> parts{};  // the seams of a sewing that has several, by name
    double first = 0;                  // m
    double second = 0;                 // m
    bool is_uneven = false;
    bool is_eased = false;

    double difference() const { return second - first; }  // m
    bool is_wrong() const { return is_uneven && !is_eased; }
};

// Of the seam's whole sewing (editor/geometry/sewing.h), under the sewing's name. Pre: the seams' panels and edges
// exist.
SeamMeasures seam_measures(const sim::Pattern& pattern, int seam);

// For example "+3.2 mm": the length of the second side minus that of the first.
std::string difference_text(const SeamMeasures& measures);

}  // namespace selvedge::editor
