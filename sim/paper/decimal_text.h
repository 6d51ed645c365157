#pragma once
// Lengths and angles in SVG and DXF files.
#include <string>

namespace selvedge::sim {

// At most six decimals, whatever the locale.
std::string decimal_text(double value);

}  // namespace selvedge::sim
