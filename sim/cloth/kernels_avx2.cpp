#include "sim/cloth/kernel_loops.h"
#include "sim/cloth/kernels_of.h"

namespace selvedge {

const Kernels& kernels_avx2() {
    return kLoops;
}

}  // namespace selvedge
