#pragma once
// The cones to which panels can be bent round the body: of a skirt by the arc of its waist, of a sleeve by the lines of
// its underarm seam.
#include <optional>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The circle of the most hollow edge: the waist of a skirt that is a sector of a disc.
struct WaistArc {
    Vec2d centre = Vec2d::Zero();
    double radius = 0;  // m; 0: there is none
    double angle = 0;   // rad, of all edges on the circle
};
WaistArc waist_arc(const Panel& panel);

// The cone of a panel that narrows downwards between two edges, its apex where they meet, its sine as if it closed;
// none if it does not narrow, or by so little that a cylinder fits.
std::optional<WrapCone> tapering_cone(const Panel& panel, int edge, int other_edge);

}  // namespace selvedge::sim
