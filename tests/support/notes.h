#pragma once
// Whether notes, as those of a report or of a drawing, say something.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace selvedge {

inline bool has_note(const std::vector<std::string>& notes, std::string_view words) {
    return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(words) != note.npos; });
}

}  // namespace selvedge
