#pragma once
// Figures on a map: the range that a map spans, in round numbers, and the legend that says so.
#include <vector>

#include "render/legend.h"

namespace selvedge {

// The least of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is no less. Pre: value > 0, finite.
double round_up(double value);

// The map's ends in percent, its middle 0; the 99th percentile, the greatest and the least of `strains`, 0.01 being one
// percent. Pre: limit > 0, strains are not empty.
Legend strain_legend(const std::string& title, double limit, const std::vector<double>& strains);

// From 0 to `limit`, in mm; the figures are in m. Pre: as above.
Legend clearance_legend(double limit, const std::vector<double>& clearances);

}  // namespace selvedge
