#include "sim/cloth/kernel_loops.h"
#include "sim/cloth/kernels_of.h"

namespace selvedge {

const Kernels& kernels_plain() {
    return kLoops;
}

}  // namespace selvedge
