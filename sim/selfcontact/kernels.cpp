#include "sim/selfcontact/kernels.h"

namespace selvedge::sim {

const SelfContactKernels& self_contact_kernels(SimdLevel level) {
    return for_level(level, self_contact_kernels_of<SimdLevel::Plain>(), self_contact_kernels_of<SimdLevel::Avx2>(),
                     self_contact_kernels_of<SimdLevel::Avx512>());
}

}  // namespace selvedge::sim
