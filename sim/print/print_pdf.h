#pragma once
// Patterns as PDF at their true size: a cover with a test square and a map, then pages to glue together, or one large
// page for a plotter; and cutting layouts, as a plan on one page or at their true size.
#include <string>
#include <vector>

#include "sim/print/pages.h"

namespace selvedge::sim {

struct PrintOptions {
    PageSize paper;
    LayerChoice layers = kAllLayers;
    bool is_one_page = false;          // as wide as `paper` at most, as long as it takes
    bool draws_mirror_images = false;  // see PaperPieceOptions
    bool are_halved = false;           // likewise
};

struct PrintedPdf {
    std::string bytes;
    int covers = 0;
    int pages = 0;              // with parts of pieces
    int columns = 1, rows = 1;  // of the grid, of which pages without a part of a piece are left out
};

PrintedPdf print_pdf(const Pattern& pattern, const PrintOptions& options);

// A page for each layout. is_true_size: pages as large as the fabric; otherwise a plan on the paper.
PrintedPdf print_layouts(const std::vector<PaperSheet>& layouts, const PageSize& paper, bool is_true_size);

// "1.42 m of wool, 150 cm wide, 78 % used".
std::string describe_layout(const PaperSheet& layout);

// The side of the test square, m.
inline constexpr double kTestSquare = 0.1;

}  // namespace selvedge::sim
