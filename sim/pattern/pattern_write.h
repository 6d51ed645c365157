#pragma once
// From a Pattern back to its GarmentCode specification.  (patterns/FORMAT.md)
#include <string>

#include "sim/core/json.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// `base` with what differs in the pattern written over it; a null base gives a new specification, in centimetres.
// Panels are found by name: those that the pattern no longer has go, new ones are added at the end.
Json pattern_as_json(const Pattern& pattern, const Json& base);

// Gives a panel of a specification another name, in its place and with all that it holds; stitches and what we add that
// speak of it follow. For a pattern whose panel was renamed, so that pattern_as_json finds it again. Nothing happens
// when there is no panel `from`, or a panel `to` already.
void rename_panel_in_file(Json& specification, const std::string& from, const std::string& to);

}  // namespace selvedge
