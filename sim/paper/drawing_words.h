#pragma once
// The words of texts and classes in drawings.
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

// Runs of letters and digits; ASCII in small letters, other letters as they are.
std::vector<std::string> words_of(std::string_view text);

}  // namespace selvedge::sim
