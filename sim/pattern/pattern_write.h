#pragma once
// From a Pattern back to its GarmentCode specification.  (patterns/FORMAT.md)
#include "sim/core/json.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// `base` with what differs in the pattern written over it; a null base gives a new specification, in centimetres.
// Panels are found by name: those that the pattern no longer has go, new ones are added at the end.
Json pattern_as_json(const Pattern& pattern, const Json& base);

}  // namespace selvedge
