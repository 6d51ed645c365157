#include "sim/body/collider.h"

namespace selvedge {

void Collider::contacts(std::span<ContactBlock> blocks, float /*reach*/) const {
    for (ContactBlock& block : blocks)
        for (std::size_t i = 0; i < kContactLanes; ++i) {
            const Contact found = contact({block.x[i], block.y[i], block.z[i]});
            block.distance[i] = found.distance;
            block.nx[i] = found.normal.x();
            block.ny[i] = found.normal.y();
            block.nz[i] = found.normal.z();
        }
}

}  // namespace selvedge
