#pragma once
// What options of a dressing may be: of the program, the Python module and the library.
#include "sim/core/numbers.h"
#include "sim/pattern/limits.h"

namespace selvedge::sim {

// In the units of the command line.
inline constexpr Limits<double> kEdgeLengthsCm{kShortestMeshEdge * 100, kLongestMeshEdge * 100};
inline constexpr Limits<int> kLevels{0, 8};  // with the shortest edge 0.1 cm: to 1 mm
inline constexpr Limits<double> kShortestEdgesCm{0.1, 50};
inline constexpr Limits<int> kTriangleBudgets{100, 10'000'000};
inline constexpr Limits<int> kThreadCounts{1, 1024};
inline constexpr Limits<double> kDrapeSeconds{0.01, 600};

}  // namespace selvedge::sim
