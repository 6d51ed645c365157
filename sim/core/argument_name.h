#pragma once
// Places of errors that are options of the command line, for callers who have no command line: the Python module and
// the library.
#include <algorithm>
#include <string>
#include <string_view>

namespace selvedge::sim {

// The argument's name for such a place: "--sett-size" gives "sett_size", "--body-unit" gives "unit". Others stay.
inline std::string argument_name(std::string place) {
    if (!place.starts_with("--")) return place;
    place.erase(0, 2);
    std::replace(place.begin(), place.end(), '-', '_');
    constexpr std::string_view kBody = "body_";
    return place.starts_with(kBody) ? place.substr(kBody.size()) : place;
}

}  // namespace selvedge::sim
