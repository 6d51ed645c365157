#pragma once
// The garments of a pattern that are worn over each other: which panels each has, which lies inside of which, and how
// another one is put on as the outermost or taken off.  (patterns/FORMAT.md)
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct Garment {
    std::string name;
    std::vector<int> panels;  // indices into Pattern::panels, ascending; never empty
    int lowest_layer = 0;     // of its panels
    int highest_layer = 0;
};

// Of the panel: Panel::garment, or else the pattern's name.
const std::string& garment_of(const Pattern& pattern, const Panel& panel);

// From the innermost to the outermost: by lowest layer, then in the order of their first panels.
std::vector<Garment> garments_of(const Pattern& pattern);

// The names of these, in the same order.
std::vector<std::string> garment_names(const Pattern& pattern);

// Per panel, the first of those that seams join it with.
std::vector<std::size_t> sewn_parts(const Pattern& pattern);

// Puts the garments of `outer` over those of `pattern`: adds its panels and seams, with all layers raised above those
// of `pattern`. Names of panels, seams and garments that are taken get the name of their garment, or a number. Panels
// keep their fabric, and where they are placed. Body, tartan and edge length are those of `pattern`; returns one note
// for each that differs in `outer`. Throws InputError if a layer would be over kHighestLayer.
std::vector<std::string> put_over(Pattern& pattern, Pattern outer);

// Removes the panels of that garment and all seams to them. Mirror images of removed panels stay as they are. Returns
// whether there was one.
bool take_off(Pattern& pattern, std::string_view garment);

}  // namespace selvedge::sim
