#pragma once
// What a package brings with it because the system may lack it: fonts.
#include <filesystem>

namespace selvedge::render {

// share/selvedge in the tree of a program, which lies in its bin, or beside the Python module. Empty: this one was not
// packed, and uses the system's.
std::filesystem::path shipped_folder();

// Lets Fontconfig find the shipped fonts beside the system's, unless the environment names a configuration
// (FONTCONFIG_FILE, FONTCONFIG_PATH). Changes the environment: before any thread starts.
void use_shipped_fonts();

}  // namespace selvedge::render
