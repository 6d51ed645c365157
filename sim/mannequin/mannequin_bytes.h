#pragma once
// The readings of a mannequin as bytes, for its store and for processes that pass them.
#include "sim/core/flat_bytes.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::sim {

// Of every measure, in the order of measure_names(), and of the stance.
void write(FlatWriter& writer, const MannequinReadings& readings);

// Pre: write() wrote them; of other bytes the reader is not sound afterwards, or the numbers are any.
MannequinReadings read_readings(FlatReader& reader);

}  // namespace selvedge::sim
