#pragma once
// Which side of the body a panel of a pair lies on, by what it is sewn to.
#include <cstddef>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

// An edge of a panel, and the edge that it is sewn to.
struct SewnEdge {
    int panel = 0;  // the other one; the same one if it closes a tube
    SeamSide own;
    SeamSide other;
    bool is_reversed = true;  // as in Seam
};
using SewnEdges = std::vector<std::vector<SewnEdge>>;  // per panel

SewnEdges sewn_edges(const Pattern& pattern);

Vec2d middle_of_edge(const Pattern& pattern, const SeamSide& side);  // m, panel frame

// Where the middle of the body lies, as seen on the panel: -1 on its left, 1 on its right, 0 not known.
double middle_side(const Pattern& pattern, const SewnEdges& sewn, const std::vector<PanelRole>& roles, std::size_t p);

// Sets the flank of each panel that lies on one side of the body: it has a mirror image, or its name says so.
void find_flanks(const Pattern& pattern, const SewnEdges& sewn, std::vector<PanelRole>& roles);

// Which part of the body each panel belongs to (Panel::label): sleeves and their cuffs to arms; legs, and theirs, never
// close round one.
void label_panels(Pattern& pattern, const SewnEdges& sewn, const std::vector<PanelRole>& roles);

}  // namespace selvedge::sim
