#pragma once
// The version of these headers, for the preprocessor, and of the library that the program runs with. They have the same
// major and minor number: the name of the shared library, libselvedge.so.MAJOR.MINOR, holds both.
#include <string_view>

#include "selvedge/export.h"

#define SELVEDGE_VERSION_MAJOR 0
#define SELVEDGE_VERSION_MINOR 1
#define SELVEDGE_VERSION_PATCH 0

namespace selvedge {

// Of the library: "0.1.0".
SELVEDGE_API std::string_view version() noexcept;

}  // namespace selvedge
