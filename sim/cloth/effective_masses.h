#pragma once
// Gains of the solver's blocks: what a constraint moves its vertices by, from their inverse masses.
//
// A block's gains depend on its constraints and on the masses of its vertices alone, and an adaptation changes few of
// either. So the masses are compared with those that the gains were made for, and only the blocks round a vertex whose
// mass changed, or in which a constraint was added or removed, get theirs anew: the same bits as all anew. Coarse
// bending is weighed anew as a whole, for what is handed up to it changes nearly everywhere.
namespace selvedge {

struct Cloth;

// Of the blocks that are marked as dirty and of those round changed masses. Pre: masses are those of the present
// leaves.
void update_effective_masses(Cloth& cloth);

}  // namespace selvedge
