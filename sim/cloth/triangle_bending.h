#pragma once
// The blocks of triangles that bend, of leaves and, level by level, of refined ones: a part of solver_lists.h.
#include <cstddef>
#include <cstdint>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct BendBlock;
struct Cloth;
struct Kernels;

void make_bending(Cloth& cloth);

// After an adaptation: of triangles that came or went, of those whose hinges changed, and of their neighbours.
void change_bending(Cloth& cloth, const LeafChanges& changes);

// Gains from the masses: first of the leaves, then level by level of the refined triangles, fine to coarse, which take
// what the level below hands up.
// Pre: SolverLists::inverse_masses and masses are those of now.
void update_bending_masses(Cloth& cloth, const Kernels& loops);
void update_coarse_bending_masses(Cloth& cloth, const Kernels& loops, int level);

// Where a triangle's bending stands, if it was made for its present corners; block: none if it was not.
struct BendSlot {
    const BendBlock* block = nullptr;
    std::size_t at = 0;
};
BendSlot bend_slot(const Cloth& cloth, TriangleId t);

// How much a triangle is bent now, as the kernels measure it: along warp, weft and twist, 1/m.
Vec3f curvature_now(const Cloth& cloth, const BendBlock& block, std::size_t at);

}  // namespace selvedge::sim
