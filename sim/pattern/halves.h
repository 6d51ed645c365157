#pragma once
// Panels with linked halves (Panel::fold_key): each half of the outline is kept the mirror image of the other. The axis
// is the line through the two points where the halves meet, wherever these are. Edges of the half that was drawn have
// keys of EdgeRole::Drawn, and their images the same numbers as EdgeRole::Image.
#include <optional>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

bool has_linked_halves(const Panel& panel);

// The half with the edges of this role, closed by the fold: an edge with the number Panel::fold_key. Edges and points
// keep their order, and all edges are EdgeRole::Drawn there. Internal lines and drill points are split by half as
// whole_of() has them: first those of the drawn half, then as many of the other. None: the outline has no two halves.
std::optional<Panel> half_of(const Panel& panel, EdgeRole half);

// The edge of a half that is its fold. None: it has none, or the panel has no linked halves.
std::optional<int> fold_of(const Panel& half);

// The panel that is unfolded from a half over its fold. Pre: it has a fold.
Panel whole_of(const Panel& half);

// The reflection in the fold of a half, in the panel frame. Pre: it has a fold.
Eigen::Affine2d fold_reflection(const Panel& half);

}  // namespace selvedge::sim
