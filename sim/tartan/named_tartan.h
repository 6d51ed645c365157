#pragma once
// Tartans that a file or an option names.
#include <string>

#include "sim/tartan/sett.h"

namespace selvedge::sim {

// find_tartan() (sim/tartan/tartan_file.h) of a name or threadcount that stands at this place of a file, or in an
// option (then no file): the InputError for a wrong one names them.
Sett named_tartan(const std::string& name, const std::string& file, const std::string& place);

}  // namespace selvedge::sim
