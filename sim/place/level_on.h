#pragma once
// Where a height of one body lies on another.
#include <span>

namespace selvedge::sim {

// The same place between the levels of both bodies, m; linear between two levels, and beyond the ends. from, to: the
// same levels, such as hips and waist, on either body, m. Pre: at least two, ascending.
double level_on(double y, std::span<const double> from, std::span<const double> to);

}  // namespace selvedge::sim
