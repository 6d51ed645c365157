#pragma once
// Makes the solver's blocks from the leaves of a cloth and from its hierarchy.
#include "sim/cloth/coloring.h"
#include "sim/cloth/solver_blocks.h"

namespace selvedge {

struct Cloth;

// Memory that is kept between two makings.
struct SolverScratch {
    BlockColoring coloring;
    std::vector<float> masses;  // by vertex, kg
};

// Makes all blocks anew, in the memory that they have. Biases are taken from Cloth::bias.
// Pre: masses are those of the present leaves.
void make_blocks(const Cloth& cloth, SolverBlocks& blocks, SolverScratch& scratch);

}  // namespace selvedge
