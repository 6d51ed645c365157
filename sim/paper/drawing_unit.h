#pragma once
// The unit of a drawing whose file names none.
#include "sim/paper/drawing.h"

namespace selvedge::sim {

// Between these lies the largest part of a garment, m: of a baby's bonnet, and of a train.
inline constexpr double kSmallestLargest = 0.12, kLargestLargest = 3;

// m. Throws InputError for what is no unit of --unit.
double metres_of_unit(const std::string& option);

// The first of the units that the file may mean, or of mm, cm, inch, px, pt and m, in which the largest part is as
// large as panels of a garment are; else the first of them.
DrawingUnit guess_unit(const Drawing& drawing);

// What a person should know of the size of a pattern's largest part, m, which `metres_per_unit` gave it: that no
// garment has such a part, and in which unit it would have; empty: nothing.
std::string doubt_of_size(double largest, double metres_per_unit);

// The longer side of the box of a path, in file units: of the curve itself, for a handle may reach far beyond it.
double size_of(const DrawnPath& path);

}  // namespace selvedge::sim
