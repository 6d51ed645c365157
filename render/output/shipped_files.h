#pragma once
// What a package brings with it because the system may lack it: fonts.
#include <filesystem>

namespace selvedge::render {

// Where it lies, relative to the program or to the Python module: ../share/selvedge of a program in bin, and share
// beside a module. Empty: this one was not packed, and uses the system's.
std::filesystem::path shipped_folder();

// Lets Fontconfig find the shipped fonts beside the system's, unless the environment names a configuration
// (FONTCONFIG_FILE, FONTCONFIG_PATH). Changes the environment: before any thread starts.
void use_shipped_fonts();

}  // namespace selvedge::render
