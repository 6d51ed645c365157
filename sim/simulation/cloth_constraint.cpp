#include "sim/simulation/cloth_constraint.h"

#include "sim/cloth/solver_blocks.h"

namespace selvedge::sim {

float compliance_of_spring(const Cloth& cloth, float stiffness) {
    return 1 / ((1 - kMomentum) * stiffness * cloth.substep * cloth.substep);
}

}  // namespace selvedge::sim
