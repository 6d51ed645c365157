#pragma once
// The program's version, for reports.
#include <string_view>

namespace selvedge::sim {

// For example "0.1.0" (CMakeLists.txt).
std::string_view program_version();

}  // namespace selvedge::sim
