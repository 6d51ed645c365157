#pragma once
// Text in lower case, to compare names that may be written in either.
#include <cctype>
#include <string>
#include <string_view>

namespace selvedge::sim {

// Changes letters of ASCII only.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

}  // namespace selvedge::sim
