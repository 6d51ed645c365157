#include "sim/body/collider.h"

namespace selvedge {

void Collider::contacts(std::span<ContactBlock> blocks, float /*reach*/) const {
    for (ContactBlock& block : blocks)
        for (std::size_t i = 0; i < kContactLanes; ++i) block.set(i, contact(block.point(i)));
}

}  // namespace selvedge
