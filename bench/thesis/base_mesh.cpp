#include "bench/thesis/base_mesh.h"

#include <cstdlib>
#include <limits>

#include "sim/mesh/sew.h"

namespace selvedge::bench {

double edge_length_for(const sim::Pattern& pattern, int triangles, int tolerance) {
    constexpr double kUsual = 0.05;               // m, where the pattern names none
    constexpr double kStep = 0.005, kTries = 60;  // share of the pattern's own length
    const double own = pattern.edge_length.value_or(kUsual);
    double best = own;
    int least = std::numeric_limits<int>::max();
    for (int i = 0; i <= kTries && least > tolerance; ++i) {
        const double length = own * (1 + kStep * (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2));
        const auto count = static_cast<int>(assemble(pattern, {.target_edge = length}).triangles.size());
        if (std::abs(count - triangles) >= least) continue;
        least = std::abs(count - triangles);
        best = length;
    }
    return best;
}

}  // namespace selvedge::bench
