#pragma once
// Carries an edit of what the sources of a pattern give back to them (sim/pattern/sources.h).
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// Propagates an edit (the difference to `before`) to linked panels: mirror images and copies. Of a family of linked
// panels, the drawn one and all derived from it, the one that was edited leads; if several were, the one whose number
// of edges changed most; of equal ones the drawn one, else the first in the pattern. A panel that came with the edit
// follows. Their own fields may differ: names and sheet positions, of copies also their placement.
//
// Seams stay at their places, by the keys of their edges: where an edge was split or edges were joined, those of the
// rest of the family, and what they are sewn to, are split or joined too. Seams end where the edges that they are sewn
// to are no part of one that is there, or where edges were joined and those sewn to them meet in a corner. Darts are
// those of the panel that leads.
//
// The halves of a panel that are linked (sim/pattern/halves.h) are such a family too, that of the drawn half first.
// Points where they meet may move, and the axis with them, whichever half leads; an edit that removes one is refused.
// So is one that changes both halves, and differently.
//
// Throws GeometryError, with the pattern unchanged, if that is not possible. Pre: the panels of `before` have keys, and
// its linked panels are alike, as evaluate() gives them.
void update_links(sim::Pattern& pattern, const sim::Pattern& before);

}  // namespace selvedge::editor
