#pragma once
// The colours of the explanatory drawings: of lines, dots and text, and a pale one that fills.
#include <string_view>

namespace selvedge::bench {

inline constexpr std::string_view kInk = "#22303f", kSoftInk = "#6d6a64", kRedInk = "#b5432a", kBlueInk = "#2f6d8f",
                                  kGreenInk = "#2e8b3a", kGoldInk = "#c98a1b", kPaleFill = "#eef2f6";

}  // namespace selvedge::bench
