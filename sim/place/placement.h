#pragma once
// Adapts the 3D placement of panels to a body other than the one they were placed for, and clears a way for the seams.
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

class BodyCollider;

// Shifts each panel: its height scales with stature, and it moves with the centre of the torso's section at that
// height. `from` is the body that the pattern names. Does not change the pattern when both bodies are equal.
void anchor_panels(Pattern& pattern, const Body& from, const Body& onto);

// Moves each panel that intersects the body outward along its front normal until it is clear, by at most 40 cm. Returns
// one note per moved or stuck panel.
std::vector<std::string> clear_panels(GarmentMesh& unsewn, const BodyCollider& body);

// The vertical shift of the whole unsewn garment (m, negative: down) with which its seams can close. The body blocks a
// shoulder seam that is too low or an underarm seam that is too high. The shift minimises how deep the straight lines
// between linked vertices run through the body.
double seam_clearing_lift(const GarmentMesh& unsewn, const BodyCollider& body);

// Applies seam_clearing_lift() and then clear_panels(). Returns notes on what was changed.
std::vector<std::string> make_sewable(GarmentMesh& unsewn, const BodyCollider& body);

}  // namespace selvedge::sim
