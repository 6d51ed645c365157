#pragma once
// Reads SVG: FreeSewing's export, files of Selvedge, and plain drawings of Inkscape or Illustrator, where closed paths
// are parts and names of layers, ids or classes tell what other lines mean.  (W3C, "Scalable Vector Graphics 2")
#include <string>
#include <string_view>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

bool looks_like_svg(std::string_view text);

// Throws InputError for text that is no XML, for path data that are wrong (names the element), for a file that uses
// itself without end or is beyond the limits (64 MB, 200,000 elements, 2 million edges), and if nothing is drawn.
Drawing read_svg(std::string_view text, const std::string& file);

}  // namespace selvedge::sim
