#pragma once
// The grid of a tiled print whose pages end at their borders: which page lies where, and which part of each page is its
// cell.
#include <optional>
#include <utility>
#include <vector>

#include "sim/paper/pdf_tiles.h"

namespace selvedge::sim {

struct GridFit {
    Eigen::AlignedBox2d cell = {};                 // mm, of each page
    std::vector<std::pair<int, int>> places = {};  // column and row from the lower left, per page
    int matched = 0;                               // lines that go on across a border
    int unmatched = 0;                             // lines that end at one
};

// Of pages of one size. is_furniture: per page and shape, what belongs to the print and not to the pattern; its lines
// and marks tell where borders can be. None: no grid has lines that go on across its borders.
std::optional<GridFit> fit_page_grid(const std::vector<const TilePage*>& pages,
                                     const std::vector<std::vector<bool>>& is_furniture);

}  // namespace selvedge::sim
