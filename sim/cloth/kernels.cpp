#include "sim/cloth/kernels.h"

#include "sim/cloth/kernels_of.h"

namespace selvedge {

const Kernels& kernels(SimdLevel level) {
    switch (level) {
        case SimdLevel::Avx512:
            return kernels_avx512();
        case SimdLevel::Avx2:
            return kernels_avx2();
        case SimdLevel::Plain:
            break;
    }
    return kernels_plain();
}

}  // namespace selvedge
