#pragma once
// Reads patterns as PDF: pages of home sewing patterns, tiled or whole, and of plotters. Their lines, texts and layers
// become a plain drawing (plain_drawing.h), as those of SVG do. Pages that hold only a scan come as pictures.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/paper/pdf_pages.h"

namespace selvedge::sim {

// As draw_pages() does (pdf_pictures.h).
using PageDrawing = std::function<void(std::vector<DrawnPicture>& pages)>;

// Throws InputError for a file that is no sound PDF (read_pdf_file()), or that holds neither a scan nor a closed
// outline; also if there are scans beside lines that are no closed outline. Scans that cannot be drawn are left out
// where panels were read, and told.
Drawing read_pdf(std::string_view bytes, const std::string& file);

// The same from the pages. Without `draw`, the pictures have no pixels.
Drawing drawing_of_pdf(const PdfFile& pdf, const std::string& file, const PageDrawing& draw = {});

}  // namespace selvedge::sim
