#pragma once
// How SVG and DXF files of Selvedge say where a panel starts round the body: phrases in any order, lengths in mm,
// angles in degrees, edges counted from 0.
//   start e x y                   edge e of the sewing line begins at (x, y) of the panel frame; 2 to 16 of them
//   at x y z                      Panel::translation
//   turned x y z                  Panel::rotation: about x, then y, then z
//   mirrored                      Panel::is_mirrored
//   cylinder r | cone x y sine    Panel::wrap_radius | Panel::wrap_cone
//   layer n, label TEXT           as in Panel
//   pin e                         the panel is pinned where edge e begins
//   unworn                        the panel is cut, but not worn
// and of the body: its height and Pattern::body.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

// Whether the pattern's placements mean something without another file: its body is a mannequin.
bool has_portable_placement(const Pattern& pattern);

std::vector<std::string> placement_phrases(const Panel& panel);
std::string body_phrase(const Pattern& pattern);

// Adds what a phrase says to the placement; false: it is none, is broken, or says more.
bool read_placement_phrase(std::string_view phrase, DrawnPlacement& placement);

// None: the text is broken, or names a file.
std::optional<DrawnBody> read_body_phrase(std::string_view phrase);

// Gives the panel its frame and its start. `outline`: the panel's, as it is drawn, m. Returns false, and changes
// nothing, if the outline has other edges, was scaled, or the panel would lie too far from the origin. Pre: the outline
// runs counter-clockwise; one that was mirrored does not.
bool place_as_drawn(Panel& panel, const DrawnPath& outline, const DrawnPlacement& placement);

}  // namespace selvedge::sim
