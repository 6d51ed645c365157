#pragma once
// The blocks of hinges, a part of solver_lists.h.
#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge {

struct Cloth;
struct Kernels;

void make_hinges(Cloth& cloth);
void change_hinges(Cloth& cloth, const LeafChanges& changes);

// Gains of dirty blocks, from the masses, and how often hinges are visited.
void weigh_hinges(Cloth& cloth, const Kernels& loops);

}  // namespace selvedge
