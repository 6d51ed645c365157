#include "sim/cloth/kernels.h"

namespace selvedge::sim {
namespace {

// Wider registers are not always faster: a kernel dominated by gathers and scatters runs faster with 8 lanes than with
// 16. Both levels give the same bits.
Kernels fastest_of_avx512() {
    Kernels loops = kernels_of<SimdLevel::Avx512>();
    const Kernels& narrower = kernels_of<SimdLevel::Avx2>();
    loops.solve_coarse_limits = narrower.solve_coarse_limits;
    return loops;
}

}  // namespace

const Kernels& kernels(SimdLevel level) {
    static const Kernels avx512 = fastest_of_avx512();
    return for_level(level, kernels_of<SimdLevel::Plain>(), kernels_of<SimdLevel::Avx2>(), avx512);
}

}  // namespace selvedge::sim
