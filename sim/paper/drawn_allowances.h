#pragma once
// The seam allowances of a panel whose cut line is drawn beside its sewing line.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The allowance of an edge is its distance from the cut lines, m, square to it, where that is even. The panel's is the
// one that most of its outline has; the others' are set. Without an even distance the panel stays as it is.
void measure_allowances(Panel& panel, const std::vector<Panel>& cut_lines);

}  // namespace selvedge::sim
