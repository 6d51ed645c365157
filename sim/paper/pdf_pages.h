#pragma once
// The pages of a PDF as they are drawn: lines, texts and pictures, mm, y up, from each page's lower left corner.
// Poppler reads the file in a child process (sim/core/guarded_child.h), because a hostile file may crash or stop it.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/guarded_child.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// One stroke or fill of one path without a gap.
struct PdfShape {
    std::vector<Vec2d> points;           // the first point, then one for each line, three for each cubic Bezier
    std::vector<std::uint8_t> is_curve;  // per line or curve
    std::uint8_t is_closed = 0;
    std::uint8_t is_filled_only = 0;
    std::string style = {};                                          // equal for lines that are drawn alike
    std::vector<std::int32_t> layers = {};                           // indices of PdfFile::layers
    std::vector<Vec2d> seen = std::vector<Vec2d>(2, Vec2d::Zero());  // corners of what clipping leaves of the page
};

// A line of text.
struct PdfText {
    std::vector<Vec2d> ends = std::vector<Vec2d>(2, Vec2d::Zero());  // of its baseline
    double height = 0;                                               // of its face
    std::string text = {};
    std::vector<std::int32_t> layers = {};

    Vec2d middle() const;
};

struct PdfPage {
    Vec2d size = Vec2d::Zero();
    std::vector<PdfShape> shapes = {};
    std::vector<PdfText> texts = {};
    std::vector<Vec2d> pictures = {};  // lower left and upper right corners in turn, as they are seen
};

// An optional content group. One that the file hides has its content in the pages only if it is named as a size.
struct PdfLayer {
    std::string name;
    std::uint8_t is_hidden = 0;
};

struct PdfFile {
    std::string title = {};
    std::vector<PdfLayer> layers = {};
    std::vector<PdfPage> pages = {};
};

struct PdfLimits {
    ChildLimits child = {.processor_seconds = 10, .wall_seconds = 60, .answer_bytes = std::size_t(512) << 20};
    std::size_t pages = 500;
    std::size_t points = 2'000'000;  // of all pages
    std::size_t texts = 100'000;     // likewise
    std::size_t layers = 200;
};

bool looks_like_pdf(std::string_view bytes);

// Throws InputError for a file that is encrypted, broken, without pages, or beyond the limits; PassingError for one
// that takes too long. Post: numbers are finite and at most 1e6 in magnitude, indices are in range.
PdfFile read_pdf_file(std::string_view bytes, const std::string& file, const PdfLimits& limits = {});

// What the child process sends to its parent: the pages, or the reason for its failure.
struct PdfAnswer {
    std::string failure = {};  // empty on success
    PdfFile file = {};
};

std::string bytes_of_pdf_answer(const PdfAnswer& answer);
// nullopt when the bytes are not valid, or what they hold does not satisfy the postcondition of read_pdf_file().
std::optional<PdfAnswer> pdf_answer_of(std::string_view bytes);

}  // namespace selvedge::sim
