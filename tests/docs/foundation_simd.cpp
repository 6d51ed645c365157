// The kernels of foundation.h, compiled once for each SimdLevel.
#include "sim/cloth/loop_parts.h"
#include "tests/docs/foundation.h"

namespace selvedge::sim {
// [loops]
namespace {

void update_masses(std::span<FoundationBlock> blocks, std::span<FoundationRecord> records,
                   const float* inverse_masses) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            Floats sum = load_at(records[i].compliance[0], at);
            for (const BlockPoints& corners : blocks[i].vertices)
                sum = sum + value_at(corners, at, inverse_masses) * (1.0F / 9);
            lanes::store(&blocks[i].gain[at], 1.0F / 3 / sum);
        }
    }
}

void solve(std::span<const FoundationBlock> blocks, float plane, float* points) {
    for (const FoundationBlock& block : blocks) {
        for (std::size_t at = 0; at < kBlock; at += lanes::kCount) {
            Corners c = corners_of(block, at, points);
            const Floats sum = lanes::transposed(c.x0).y + lanes::transposed(c.x1).y + lanes::transposed(c.x2).y;
            const Floats up = (lanes::broadcast(plane) - sum * (1.0F / 3)) * load_at(block.gain, at);
            const Rows by = lanes::rows_of({Floats{}, up, Floats{}});
            c = {pushed(c.x0, by), pushed(c.x1, by), pushed(c.x2, by)};
            put_corners(block, at, c, points);
        }
    }
}

constexpr FoundationKernels kLoops{.update_masses = update_masses, .solve = solve};

}  // namespace

template <>
const FoundationKernels& foundation_kernels_of<lanes::kLevel>() {
    return kLoops;
}
// [/loops]
}  // namespace selvedge::sim
