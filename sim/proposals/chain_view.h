#pragma once
// A chain as one side of a seam: from where it is sewn, and how far.
#include <vector>

#include "sim/proposals/open_boundary.h"

namespace selvedge::sim {

struct ChainView {
    Chain chain;
    int first = 0;            // of a loop: the atom in chain.atoms at which the seam begins
    double from = 0, to = 1;  // the part that is sewn, as fractions of the chain's length from `first` on
};

// The length of the part that is sewn, m.
double length_of(const ChainView& view);

// The atom and its fraction at the fraction t of a view.
struct ChainPlace {
    int atom = 0;
    double t = 0;
};
ChainPlace place_on(const OpenBoundary& boundary, const ChainView& view, double t);

// A notch on a chain: on which of its atoms, and at which fraction of that.
struct AtomNotch {
    std::size_t atom = 0;  // index into Chain::atoms
    double t = 0;
    int count = 1;  // see Notch::count
};
std::vector<AtomNotch> notches_of(const OpenBoundary& boundary, const Chain& chain);

// The fractions of a view at which its atoms begin and end, without 0 and 1, ascending.
std::vector<double> joints_of(const OpenBoundary& boundary, const ChainView& view);

}  // namespace selvedge::sim
