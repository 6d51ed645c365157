// Collects the kernels of one SIMD level. CMake compiles this source once for each SimdLevel, so everything but the
// last function has internal linkage (sim/core/simd_level.h).
#include "sim/cloth/constraint_loops.h"
#include "sim/cloth/contact_loops.h"
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
                         .keep_corrections = keep_corrections,
                         .solve_stretch = solve_stretch,
                         .limit_stretch = limit_stretch,
                         .solve_bend = solve_bend,
                         .solve_coarse_bend = solve_coarse_bend,
                         .limit_parents = limit_parents,
                         .restrict_centres = restrict_centres,
                         .restrict_stress = restrict_stress,
                         .update_bias = update_bias,
                         .update_parents = update_parents,
                         .rub = rub,
                         .hold_moves = hold_moves,
                         .answer_vertices = answer_vertices,
                         .look_at_samples = look_at_samples,
                         .answer_samples = answer_samples,
                         .push_samples = push_samples};

}  // namespace

template <>
const Kernels& kernels_of<lanes::kLevel>() {
    return kLoops;
}

}  // namespace selvedge::sim
