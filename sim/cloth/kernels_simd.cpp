// Collects the kernels of one SIMD level. CMake compiles this source once for each SimdLevel, so everything but the
// last function has internal linkage (sim/core/simd_level.h).
#include "sim/cloth/constraint_loops.h"
#include "sim/cloth/contact_loops.h"
#include "sim/cloth/moving_contact_loops.h"
#include "sim/cloth/triangle_bending_loops.h"
#include "sim/core/simd_lanes.h"

namespace selvedge::sim {
namespace {

constexpr Kernels kLoops{.update_stretch_masses = update_stretch_masses,
                         .update_bend_masses = update_bend_masses,
                         .update_coarse_bend_masses = update_coarse_bend_masses,
                         .update_limit_masses = update_limit_masses,
                         .predict = predict,
                         .add_momentum = add_momentum,
                         .store_corrections = store_corrections,
                         .solve_stretch = solve_stretch,
                         .limit_stretch = limit_stretch,
                         .solve_bend = solve_bend,
                         .solve_coarse_bend = solve_coarse_bend,
                         .solve_coarse_limits = solve_coarse_limits,
                         .prolong_centres = prolong_centres,
                         .prolong_stress = prolong_stress,
                         .update_bias = update_bias,
                         .update_limit_biases = update_limit_biases,
                         .apply_internal_damping = apply_internal_damping,
                         .project_vertices = project_vertices,
                         .store_query_and_project = store_query_and_project,
                         .locate_samples = locate_samples,
                         .store_query = store_query,
                         .push_samples = push_samples,
                         .push_samples_in_turn = push_samples_in_turn,
                         .longest_motion = longest_motion,
                         .hold_on_planes = hold_on_planes,
                         .push_samples_on_planes = push_samples_on_planes};

}  // namespace

template <>
const Kernels& kernels_of<lanes::kLevel>() {
    return kLoops;
}

}  // namespace selvedge::sim
