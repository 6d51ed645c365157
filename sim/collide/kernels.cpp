#include "sim/collide/kernels.h"

namespace selvedge::sim {
namespace {

// A packet has eight triangles, which would fill only half of sixteen lanes: use the AVX2 kernel.
CollideKernels fastest_of_avx512() {
    CollideKernels kernels = collide_kernels_of<SimdLevel::Avx512>();
    kernels.squared_distances = collide_kernels_of<SimdLevel::Avx2>().squared_distances;
    return kernels;
}

}  // namespace

const CollideKernels& collide_kernels(SimdLevel level) {
    static const CollideKernels avx512 = fastest_of_avx512();
    return for_level(level, collide_kernels_of<SimdLevel::Plain>(), collide_kernels_of<SimdLevel::Avx2>(), avx512);
}

}  // namespace selvedge::sim
