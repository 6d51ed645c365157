#pragma once
// A selection without what is not there.
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

Selection clean_selection(Selection selection, const Pattern& pattern);

}  // namespace selvedge
