#pragma once
// Where panels stand round a body they were not placed for.  (SPEC 3.1)
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

class BodyCollider;

// Shifts each panel with the body: its level scales by stature, and it follows the torso's section centre there.
// `from` is the body that the pattern names. Equal bodies leave it as it is.
void anchor_panels(Pattern& pattern, const Body& from, const Body& onto);

// Moves panels that a body pokes through out along their front normal until they are clear of it, and returns what was
// done as notes ("panel 'front' moved 42 mm outward").
std::vector<std::string> clear_panels(GarmentMesh& unsewn, const BodyCollider& body);

// How far up (m, negative: down) the whole unsewn garment should go so that its seams can close: the body stands
// between the two sides of a shoulder seam that lies too low, and of an underarm seam that lies too high. The lift is
// the one for which the straight lines between linked vertices run least deep through the body.
double seam_clearing_lift(const GarmentMesh& unsewn, const BodyCollider& body);

// Both of these: where the unsewn garment can be sewn. Returns what was done.
std::vector<std::string> make_sewable(GarmentMesh& unsewn, const BodyCollider& body);

}  // namespace selvedge::sim
