#pragma once
// Pages of a PDF as pictures, as poppler draws them: a page that holds only a scan has no lines, and is traced by hand.
// Drawn in a child process (sim/core/guarded_child.h), as the pages are read (pdf_pages.h).
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/guarded_child.h"
#include "sim/paper/drawing.h"

namespace selvedge::sim {

struct PdfPictureLimits {
    // A page of A4 that was scanned in colour takes about 0.3 s.
    ChildLimits child = {.processor_seconds = 30, .wall_seconds = 90, .answer_bytes = std::size_t(512) << 20};
    double resolution = 150;  // pixels per inch, at most: a pixel is 0.17 mm, and a pencil's line three pixels wide
    double pixels = 64e6;     // of all pages together: where they are more, the resolution is less
    double side_px = 16384;   // of one page: the longest that a picture is read with (render/image/image.h)
};

// Draws the pages whose numbers and sizes are given, and sets the rest of each. Texts in fonts that the file does not
// hold are left out: the fonts of the machine that reads it would stand for them. Throws InputError for a page that
// cannot be drawn, PassingError for pages that take too long. Post: the pixels cover the page, and at most one row and
// column more, below it and to its right.
void draw_pages(std::string_view bytes, const std::string& file, std::vector<DrawnPicture>& pages,
                const PdfPictureLimits& limits = {});

// As the lines beside them, where these are not drawn at true size: the pixels become larger or smaller.
void scale_pictures(std::vector<DrawnPicture>& pictures, double factor);

}  // namespace selvedge::sim
