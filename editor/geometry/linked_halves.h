#pragma once
// Panels with linked halves (sim/pattern/halves.h) as two panels each: the drawn half, in the panel's place, and the
// other half, which is a mirror image of it (Panel::mirror_of) and stands after all panels. So halves are kept alike as
// linked panels are. For update_links (linked_panels.h); for the sources of this module.
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

struct DividedPattern {
    sim::Pattern pattern;
    std::vector<int> divided;  // panels whose other halves are the last panels of `pattern`, in this order
};

// Internal lines and drill points that `before` has are of the half that they were of; others of that on whose side of
// the fold their middle lies. Throws GeometryError if halves that `before` has do not meet in two points any more;
// halves that were never there are left alone. Pre: all panels have keys.
DividedPattern divide_halves(const sim::Pattern& pattern, const sim::Pattern& before);

// Unfolds the drawn halves again. Seams to other halves are then seams to the images of their edges.
sim::Pattern joined_halves(const DividedPattern& parts);

// A message about parts, in which other halves are named as a person knows them.
std::string without_half_names(std::string text);

// The name of the panel that has this half; other names unchanged.
std::string whole_name(const std::string& name);

}  // namespace selvedge::editor
