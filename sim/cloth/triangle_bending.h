#pragma once
// Bending constraints: makes and updates their blocks, for leaves and, level by level, for refined triangles, and
// computes their gains. The map from hinge angles to curvature is in curvature_map.h; docs/solver.md has the method.
#include <cstddef>
#include <cstdint>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct BendBlock;
struct Cloth;
struct Kernels;

void make_bending(Cloth& cloth);

// After an adaptation: updates triangles that were added or removed, those whose hinges changed, and their neighbours.
void change_bending(Cloth& cloth, const LeafChanges& changes);

// Update the gains from the masses: first of the leaves, then of the refined triangles level by level, fine to coarse.
// Each level takes over the rigidity that the finer level could not apply.
// Pre: SolverLists::inverse_masses and masses are up to date.
void update_bending_masses(Cloth& cloth, const Kernels& loops);
void update_coarse_bending_masses(Cloth& cloth, const Kernels& loops, int level);

// The slot of a triangle's bending constraint; block is null if there is none for its present corners.
struct BendSlot {
    const BendBlock* block = nullptr;
    std::size_t at = 0;
};
BendSlot bend_slot(const Cloth& cloth, TriangleId t);

// The present curvature of a triangle along warp, weft and of twist (doubled), 1/m, with the formula of the kernels.
Vec3f curvature_now(const Cloth& cloth, const BendBlock& block, std::size_t at);

}  // namespace selvedge::sim
