#pragma once
// What the pages of a tiled print say of their place in the grid.
#include <string>
#include <utility>
#include <vector>

#include "sim/paper/pdf_pages.h"

namespace selvedge::sim {

// Two numbers for each page, from 0, which are different for all pages: 0 and 1 for "A2", "row 1, column 2" or "1-2".
// Which is the column, pages do not say. Empty: they have no such labels.
std::vector<std::pair<int, int>> page_labels(const std::vector<const std::vector<PdfText>*>& pages);

// Whether a text is of the page, not of the pattern: such a label, "page 3 of 12", "3/12", alone or before other words.
bool is_page_text(const std::string& text);

}  // namespace selvedge::sim
