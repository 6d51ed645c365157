#pragma once
// Patterns as SVG at their true size: 1 user unit = 1 mm, a group per panel with a layer per kind of line, sewing lines
// edge by edge as the curves that they are. What a drawing program does not show is kept for reading it back
// (sim/paper/svg_drawing.h): the panel's data in data-selvedge-... attributes, seams and the body in the metadata
// element.
#include <string>

#include "sim/print/paper_sheet.h"

namespace selvedge::sim {

// The sheet's pieces, placed. Seams are written if every panel is on the sheet once. UTF-8; the same sheet gives the
// same bytes.
std::string svg_of(const Pattern& pattern, const PaperSheet& sheet, const LayerChoice& layers = kAllLayers);

}  // namespace selvedge::sim
