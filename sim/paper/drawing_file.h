#pragma once
// Reads a 2D pattern file of another program, whatever its format: told by content, not by extension.
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

// SVG, FreeSewing's data, DXF or PDF. Throws InputError that says where the text is wrong, or that names the formats.
Drawing parse_drawing(std::string_view text, const std::string& file);
// A DXF file with its grade rules, which lie beside it under the same name with the extension .rul.
Drawing read_drawing(const std::filesystem::path& path);

}  // namespace selvedge::sim
