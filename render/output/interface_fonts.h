#pragma once
// The interface's fonts, searched among what is shipped and the system's packages at run time, and the font of legends,
// which is the same.
#include <filesystem>
#include <memory>
#include <vector>

#include "render/image/outline_font.h"

namespace selvedge::render {

struct FontFiles {
    std::filesystem::path regular;  // empty: none was found
    std::filesystem::path medium;   // for headings; the regular font if the family has no medium one
};

// Those that are shipped with the program, and the system's.
std::vector<std::filesystem::path> font_folders();

// The first family that is there: Inter, Noto Sans, DejaVu Sans; of a family, the one in the first folder.
FontFiles find_fonts(const std::vector<std::filesystem::path>& folders = font_folders());

// For legends in pictures and in the 3D view. Null: no font is installed, or its file cannot be read.
std::shared_ptr<const OutlineFont> read_legend_font(const FontFiles& files = find_fonts());

}  // namespace selvedge::render
