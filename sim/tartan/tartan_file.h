#pragma once
// Tartans by name: those that ship with the program (patterns/tartans), each a threadcount with its own palette.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge::sim {

inline constexpr const char* kDefaultTartan = "royal_stewart";

// A shipped tartan by its name ("Black Watch", "black_watch"), or a threadcount ("K/8 R24 W/4").
// Throws InputError: for an unknown name it lists those that ship, for a threadcount it names the stripe.
Sett find_tartan(const std::string& name_or_threadcount);

// A tartan with its repeat brought to a size (m), where one is given; an empty name is the default tartan. Throws
// InputError as find_tartan() does.
Sett find_sett(const std::string& name_or_threadcount, std::optional<double> repeat_size);

// The sett that a pattern names.
Sett sett_of(const Pattern& pattern);

// Names as find_tartan takes them, in alphabetical order.
std::vector<std::string> shipped_tartans();

// A tartan file: {"name", "threadcount", "weft", "weave", "palette": {"K": "#101010"}, "repeat_cm", "register":
// {"name", "number"}}; all but the first two may be left out. Throws InputError(file, path, ...).
Sett parse_tartan(std::string_view json, const std::string& file);

}  // namespace selvedge::sim
