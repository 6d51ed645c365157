#pragma once
// Fonts of the system for letters that the interface's own fonts lack, such as Japanese ones, found by Fontconfig.
#include <vector>

#include "editor/frame/letters.h"
#include "editor/frame/theme.h"

namespace selvedge::app {

// Fonts that together have as many of the letters as the installed ones do, most suitable first. Outline fonts in
// TrueType and OpenType files only; files that cannot be read are left out.
std::vector<editor::FallbackFont> find_fallback_fonts(const editor::Letters& letters);

}  // namespace selvedge::app
