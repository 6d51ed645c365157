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
    switch (level) {
        case SimdLevel::Avx512:
            return avx512;
        case SimdLevel::Avx2:
            return collide_kernels_of<SimdLevel::Avx2>();
        case SimdLevel::Plain:
            break;
    }
    return collide_kernels_of<SimdLevel::Plain>();
}

}  // namespace selvedge::sim
