#pragma once
// The blocks of refined triangles, a part of solver_lists.h: one-sided limits with what they carry.
#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge {

struct Cloth;
struct Kernels;

void make_limits(Cloth& cloth, int level);
void change_limits(Cloth& cloth, const LeafChanges& changes);

// The centres of split edges that may move, level by level.
void list_centres(Cloth& cloth);

// What the corners of refined triangles weigh now, level by level. Pre: centres are listed.
void list_limit_masses(Cloth& cloth);

// Gains of dirty blocks, from the masses and from what the leaves' blocks have got as theirs.
void weigh_limits(Cloth& cloth, const Kernels& loops);

}  // namespace selvedge
