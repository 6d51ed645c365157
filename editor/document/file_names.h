#pragma once
// What panels that were renamed are called in the file that a document came from: so they keep their place there, and
// what else the file says of them.
#include <map>
#include <string>

#include "sim/core/json.h"

namespace selvedge {

// By a panel's present name, where the file has another.
using FileNames = std::map<std::string, std::string>;

FileNames renamed(FileNames names, const std::string& from, const std::string& to);

// The file with the present names. What the file has under a name that now is another panel's goes: its own panel went.
Json with_present_names(Json specification, const FileNames& names);

}  // namespace selvedge
