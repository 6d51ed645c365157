#pragma once
// Reads patterns as PDF: pages of home sewing patterns, tiled or whole, and of plotters. Their lines, texts and layers
// become a plain drawing (plain_drawing.h), as those of SVG do. Pages that hold only a scan come as pictures.
#include <string>
#include <string_view>

#include "sim/paper/drawing.h"
#include "sim/paper/pdf_pages.h"

namespace selvedge::sim {

// Throws InputError for a file that is no sound PDF (read_pdf_file()), or that holds neither a scan nor a closed
// outline.
Drawing read_pdf(std::string_view bytes, const std::string& file);

// The same from the pages; the pictures have no pixels.
Drawing drawing_of_pdf(const PdfFile& pdf, const std::string& file);

}  // namespace selvedge::sim
