#pragma once
// Whether rows of topstitch lie where they can be sewn: on the cloth beside their line, and apart from each other.
#include <optional>
#include <string>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// What is wrong with the rows beside an edge, an internal line or a seam, for the user. None: nothing, or no rows. A
// row is looked for beside the middle of its line. Pre: the edges have a length.
std::optional<std::string> topstitch_problem(const Panel& panel, const OutlineEdge& edge);
std::optional<std::string> topstitch_problem(const Panel& panel, const InternalLine& line);
std::optional<std::string> topstitch_problem(const Pattern& pattern, const Seam& seam);

}  // namespace selvedge::sim
