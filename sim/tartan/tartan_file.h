#pragma once
// Finds tartans by name, and reads tartan files: a threadcount with its palette. Tartans that ship with the program are
// in patterns/tartans.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::sim {

inline constexpr const char* kDefaultTartan = "royal_stewart";

// A shipped tartan by name ("Black Watch", "black_watch"), or a threadcount ("K/8 R24 W/4"). Text with a digit that is
// not a name is a threadcount. Throws InputError that lists the shipped tartans, or names the wrong stripe of a
// threadcount.
Sett find_tartan(const std::string& name_or_threadcount);

// A tartan with its repeat scaled to a size (m), if one is given; an empty name is the default tartan. Throws
// InputError as find_tartan() does.
Sett find_sett(const std::string& name_or_threadcount, std::optional<double> repeat_size);

// The sett that a pattern names, at its size. Throws InputError if it names none, and as find_tartan() does.
Sett sett_of(const Pattern& pattern);

// The names of the shipped tartans for find_tartan(), in alphabetical order.
std::vector<std::string> shipped_tartans();

// Parses a tartan file: {"name", "threadcount", "weft", "weave", "palette": {"K": "#101010"}, "repeat_cm", "register":
// {"name", "number"}}. All keys but the first two are optional. Throws InputError(file, path, ...).
Sett parse_tartan(std::string_view json, const std::string& file);

}  // namespace selvedge::sim
