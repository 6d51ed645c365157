#pragma once
// A real font for the interface, from the system's packages, found when the program runs.
#include <filesystem>
#include <vector>

namespace selvedge {

struct FontFiles {
    std::filesystem::path regular;  // empty: none was found
    std::filesystem::path medium;   // for headings; the regular one where the family has no other
};

// The first family that is there: Inter, Noto Sans, DejaVu Sans. folders: where the system keeps its fonts.
FontFiles find_fonts(const std::vector<std::filesystem::path>& folders = {"/usr/share/fonts",
                                                                          "/usr/local/share/fonts"});

}  // namespace selvedge
