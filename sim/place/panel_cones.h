#pragma once
// The cones to which panels can be bent round the body: of a skirt by the arc of its waist, of a sleeve by the lines of
// its underarm seam.
#include <optional>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/place/body_anchors.h"
#include "sim/place/panel_flanks.h"

namespace selvedge::sim {

// The circle of the most hollow edge: the waist of a skirt that is a sector of a disc.
struct WaistArc {
    Vec2d centre = Vec2d::Zero();
    double radius = 0;  // m; 0: there is none
    double angle = 0;   // rad, of all edges on the circle
};
WaistArc waist_arc(const Panel& panel);

// A skirt of one piece whose waist is an arc is bent to a cone round the body, its waist at that height (m). There it
// stands clear of the body, so that it stays open at the back if its waist is too short to go all the way round.
// Returns whether it is such a skirt.
bool bend_round_waist(Panel& panel, const TrunkSection& waist, double height);

// The cone of a panel that narrows downwards between two sides, its apex where the lines from end to end of these meet,
// its sine as if it closed; none if it does not narrow, or by so little that a cylinder fits. Sides: indices of edges,
// of one at least.
std::optional<WrapCone> tapering_cone(const Panel& panel, const std::vector<int>& side,
                                      const std::vector<int>& other_side);

// That of a sleeve, by the seam that closes it; none: no seam of its own does.
std::optional<WrapCone> cone_of_sleeve(const Pattern& pattern, const SewnEdges& sewn, std::size_t p);

// The part of a panel below that y, m, where the panel is placed; its edges are straight there.
Panel part_below(const Panel& panel, double top);

}  // namespace selvedge::sim
