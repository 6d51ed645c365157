#pragma once
// Which way is up in pieces that are laid out along the cloth, which runs across the table.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// Whether the outline is its own image in the vertical (axis 0) or the horizontal (axis 1) through its middle.
bool is_mirrored_in_itself(const Panel& panel, Eigen::Index axis);

// Turns panels so that their grain is upright; where it lies level, their shapes tell which end is up. Without grain
// lines, symmetric pieces tell: their axis is upright, and the hem is their wider end. Strips, as waistbands and
// bindings, stay. Returns whether pieces without grain were turned.
bool turn_upright(std::vector<Panel>& panels);

}  // namespace selvedge::sim
