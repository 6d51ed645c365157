#pragma once
// Lets poppler interpret a PDF and records what it draws, without rendering it: no font file is opened and no picture
// decoded. Poppler's own output interface is used, not its converter to SVG: that one draws texts as outlines of
// letters, joins layers, and turns what is transparent into pictures.
#include <string_view>

#include "sim/paper/pdf_pages.h"

namespace selvedge::sim {

// Call it in the guarded child process only. The failure says what is wrong, with the page. Throws std::bad_alloc.
PdfAnswer record_pdf(std::string_view bytes, const PdfLimits& limits);

}  // namespace selvedge::sim
