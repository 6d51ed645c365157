#pragma once
// Arms that a motion of a slimmer person would put into the trunk of this body.
#include "sim/body/body.h"
#include "sim/body/clip.h"

namespace selvedge::sim {

struct ClearArmsOptions {
    double gap = 0.005;  // m, between arms and trunk
    double most = 0.7;   // rad, that the arms are opened at most
};

// Opens both arms at the shoulders outward by one angle for the whole clip, the smallest in steps of 2 degrees that
// keeps forearms, hands and the lower halves of the upper arms out of trunk and thighs; if none does, the one with the
// least overlap. Returns the angle, rad. Nothing is done if the body has no skin or its arms are not known by name.
double clear_arms(const Body& body, Clip& clip, const ClearArmsOptions& options = {});

}  // namespace selvedge::sim
