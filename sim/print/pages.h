#pragma once
// Divides a large sheet into pages of a printer that overlap, so that they can be glued to one.
#include <string>
#include <string_view>
#include <vector>

#include "sim/print/paper_sheet.h"

namespace selvedge::sim {

struct PageSize {
    std::string name;            // "A4", "200x300 mm"
    Vec2d size = Vec2d::Zero();  // m, upright
};

// "a4", "a3", "a2", "a1", "a0", "letter", "legal", "tabloid", or WIDTHxHEIGHT in mm; case does not matter. Throws
// InputError (place: --paper) that lists them, or if a side is outside 0.15 to 5 m.
PageSize parse_page_size(std::string_view text);

struct PageGrid {
    Vec2d paper = Vec2d::Zero();  // m, as the page is printed: upright or landscape
    double margin = 0.01;         // m, that a printer leaves empty
    double overlap = 0.01;        // m, of neighbours
    int columns = 0;
    int rows = 0;    // from the top of the sheet
    double top = 0;  // m, y of the sheet's upper edge

    Vec2d printable() const { return paper - Vec2d::Constant(2 * margin); }
    Eigen::AlignedBox2d area(int column, int row) const;  // m, of the sheet: what the page shows
    // The part of it that no neighbour overlaps.
    Eigen::AlignedBox2d own_area(int column, int row) const;
};

struct Page {
    int column = 0;
    int row = 0;
    std::string name;  // "A1": column and row
};

struct PagedSheet {
    PaperSheet sheet = {};
    PageGrid grid = {};
    std::vector<Page> pages = {};  // those that show a part of a piece, row by row
};

// The pieces laid out for the fewest pages, upright or landscape; each label on one page if that has room for it.
PagedSheet lay_out_pages(const Pattern& pattern, const std::vector<PaperPiece>& pieces, const PageSize& paper);

// The grid over a sheet, and its pages.
PageGrid grid_over(const PaperSheet& sheet, const Vec2d& paper);
std::vector<Page> pages_of(const PaperSheet& sheet, const PageGrid& grid);

}  // namespace selvedge::sim
