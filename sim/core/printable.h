#pragma once
// Text of a file as one line of a terminal. A name in a file may hold anything: escape sequences that clear the screen
// or move the cursor, line feeds, a million letters. JSON output does not use this: it stays exact.
#include <cstddef>
#include <string>
#include <string_view>

namespace selvedge::sim {

inline constexpr std::size_t kMostPrinted = 400;  // characters

// The text with all that is not printable escaped: line feeds and tabs as \n and \t, other control characters of ASCII
// and bytes that are not UTF-8 as \x1b, other control characters, and those that reorder text, as \u{202e}. Letters of
// any script stay as they are. Of a longer text, "..." stands for its middle, so that at most `most` characters are
// left. Pre: most >= 5.
std::string printable(std::string_view text, std::size_t most = kMostPrinted);

// What is wrong in a file, as one printable line, "file: place: problem"; an empty file or place is omitted.
std::string fault_line(std::string_view file, std::string_view place, std::string_view problem);

// "1 edge", "2 edges". For nouns that only take an s.
std::string count_text(std::size_t count, std::string_view noun);

}  // namespace selvedge::sim
