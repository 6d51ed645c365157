#pragma once
// The faults of what was dressed, alike for a whole run (sim/session/dress.h) and for a session.
#include <optional>

#include "sim/dress/dressing.h"
#include "sim/inspection/inspection.h"

namespace selvedge::sim {

// Adds the faults of the cloth and of its sewing to the report. The collider has the wearer in the cloth's pose.
void report_faults(const Cloth& cloth, Dressing& dressing, const BodyCollider& collider, const DrapeResult& result,
                   const std::optional<TightLevel>& too_small, DressReport& report);

}  // namespace selvedge::sim
