#pragma once
// Bands of ribbing are folded in half along their length: both long edges are sewn to the hem that they end, and the
// fold is the edge of the garment. A drawing shows them whole.
#include <span>
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// Gives the bands among these panels the outline that they have when they are folded; the other half becomes the
// allowance of the fold, so that they are cut as they are drawn. A band is a rectangle one of whose sides is sewn to
// other panels, and the opposite one to none. Returns a note for each.
std::vector<std::string> fold_ribbing(Pattern& pattern, std::span<const std::string> panels);

}  // namespace selvedge::sim
