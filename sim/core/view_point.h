#pragma once
// From where cloth is seen, for what may be coarse on its hidden side (sim/adaptive/back_face.h).
#include "sim/core/math.h"

namespace selvedge::sim {

struct ViewPoint {
    Vec3f eye = Vec3f::UnitZ();  // position of the viewer, m; orthographic: unit vector from the cloth to the viewer
    bool is_orthographic = false;
};

}  // namespace selvedge::sim
