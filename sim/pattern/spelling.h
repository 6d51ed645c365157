#pragma once
// Words that are nearly spelt like another one.
#include <span>
#include <string_view>

namespace selvedge::sim {

// The nearest of the words, of which at most every third letter is another, whatever their case. Empty: there is none.
std::string_view nearly_spelt(std::string_view word, std::span<const std::string_view> words);

}  // namespace selvedge::sim
