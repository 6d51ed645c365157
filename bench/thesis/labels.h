#pragma once
// Pictures side by side, each with its name above it.
#include <string>
#include <vector>

#include "render/image/image.h"

namespace selvedge::bench {

struct Tile {
    std::string label;
    render::Image picture;
};

// Row by row, `columns` tiles in each. Pictures of a row may have different widths and heights; each tile is as large
// as the largest. Pre: at least one tile, columns >= 1.
render::Image labelled_sheet(const std::vector<Tile>& tiles, int columns);

}  // namespace selvedge::bench
