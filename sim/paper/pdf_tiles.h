#pragma once
// Puts the pages of a tiled print together on one sheet. Where pages draw whole outlines and clip them, an outline that
// two pages share gives their offset. Where outlines end at the border of each page, pages lie in a grid, by their
// labels ("A1", "row 1, column 2") or in their order; borders are where frames, glue lines and marks are, and the grid
// is taken whose lines go on across most borders.
#include <string>
#include <vector>

#include "sim/paper/pdf_pages.h"
#include "sim/paper/plain_drawing.h"

namespace selvedge::sim {

struct TileShape {
    PlainShape plain;               // mm, in the page's frame; then in that of the sheet
    Eigen::AlignedBox2d box = {};   // around its points and handles
    Eigen::AlignedBox2d seen = {};  // what clipping leaves
};

struct TilePage {
    std::size_t number = 0;  // in the file, from 1
    Vec2d size = Vec2d::Zero();
    std::vector<TileShape> shapes = {};
    std::vector<PdfText> texts = {};
};

struct JoinedTiles {
    PlainDrawing plain = {};               // the sheet, mm, without frames, glue lines, marks and page numbers
    std::vector<std::size_t> joined = {};  // indices of the pages that were put together; empty: none
    std::vector<std::size_t> single = {};  // of pages that stand for themselves on the sheet
    std::vector<std::size_t> left = {};    // of covers and instructions, which are not on the sheet
    std::vector<std::string> notes = {};
};

JoinedTiles join_tiles(const std::vector<TilePage>& pages);

}  // namespace selvedge::sim
