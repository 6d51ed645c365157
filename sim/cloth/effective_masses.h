#pragma once
// Gains of the solver's blocks: what a constraint moves its vertices by, from their inverse masses.
//
// A block's gains depend on its constraints and on the masses of its vertices alone, and an adaptation changes few of
// either. So the masses are compared with those that the gains were made for, and only the blocks round a vertex whose
// mass changed, in which a constraint was added or removed, or, of coarse bending, that are asked for another share,
// get theirs anew: the same bits as all anew.
namespace selvedge {

struct Cloth;

// Of the blocks that are marked as dirty and of those round changed masses. Pre: masses are those of the present
// leaves.
void update_effective_masses(Cloth& cloth);

}  // namespace selvedge
