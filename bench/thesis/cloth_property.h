#pragma once
// The global settings of a cloth in one place: stored together, and printed as one table.  (thesis 3.2.6, listing 3.5,
// table 5.1)
#include <string>

#include "bench/support/table.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

// By default the product's own settings.
struct ClothProperty {
    sim::Fabric fabric = sim::find_fabric("");
    sim::StepOptions stepping{};
    sim::AdaptClothOptions adapting{};
    int max_level = 3;
    double step_seconds = 1.0 / 120;
    int steps_per_adaptation = 4;
};

// Parameter, value, unit.
Table table_of(const ClothProperty& property, const std::string& name, const std::string& title);

}  // namespace selvedge::bench
