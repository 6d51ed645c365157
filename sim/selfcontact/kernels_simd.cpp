// Collects the kernels of one SIMD level. CMake compiles this source once for each SimdLevel, so everything but the
// last function has internal linkage (sim/core/simd_level.h).
#include "sim/selfcontact/kernels.h"
#include "sim/selfcontact/pair_loops.h"
#include "sim/selfcontact/search_loops.h"

namespace selvedge::sim {
namespace {

constexpr SelfContactKernels kLoops{.bound_packet = bound_packet,
                                    .find_pairs = find_pairs,
                                    .find_piercing = find_piercing,
                                    .measure_pairs = measure_pairs,
                                    .refresh_pairs = refresh_pairs,
                                    .solve_contacts = solve_contacts,
                                    .find_undivided = find_undivided};

}  // namespace

template <>
const SelfContactKernels& self_contact_kernels_of<lanes::kLevel>() {
    return kLoops;
}

}  // namespace selvedge::sim
