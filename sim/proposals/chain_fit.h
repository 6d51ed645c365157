#pragma once
// How well two chains fit each other, whatever they are: their lengths, their notches, the angles at their ends, and
// the seams that end at both.
#include <algorithm>
#include <initializer_list>
#include <string>

#include "sim/proposals/chain_view.h"
#include "sim/proposals/open_boundary.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

// What speaks for and against a seam, as the logarithm of odds and in words.
struct Evidence {
    double odds = 0;  // natural logarithm
    std::string reason;
    bool is_dart = false;     // both sides are the legs of a dart
    bool is_possible = true;  // false: whatever the odds are, it is no seam
};

inline void add(Evidence& evidence, double odds, const std::string& reason = {}) {
    evidence.odds += odds;
    if (!reason.empty()) evidence.reason += (evidence.reason.empty() ? "" : "; ") + reason;
}

inline bool is_one_of(GarmentPart part, std::initializer_list<GarmentPart> parts) {
    return std::ranges::find(parts, part) != parts.end();
}

inline bool are_parts(GarmentPart a, GarmentPart b, GarmentPart one, GarmentPart other) {
    return (a == one && b == other) || (a == other && b == one);
}

// are_of_one_kind: each side lies on one panel, or on halves of one.
void weigh_lengths(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b,
                   const PanelRole& role_a, const PanelRole& role_b, bool are_of_one_kind);

// The part of the length by which a notch may lie elsewhere, for ease lies between notches.
// may_differ: a front is compared with a back, and a single notch there may be a double one here, which says "back".
void weigh_notches(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b,
                   bool may_differ);

// Across a seam, the outline goes on without a corner.
void weigh_ends(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b);

// A seam that ends where both chains begin goes on along them, as that of a raglan sleeve from the front to the back.
void weigh_going_on(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b);

// Seams that end at the same place of both chains: a side seam under the middle of a sleeve's.
void weigh_joints(Evidence& evidence, const OpenBoundary& boundary, const ChainView& a, const ChainView& b);

}  // namespace selvedge::sim
