#include "sim/dress/work_count.h"

#include <utility>

#include "sim/cloth/contact_surface.h"
#include "sim/cloth/solver_state.h"

namespace selvedge::sim {
namespace {

// Pairs of triangles that contact of the cloth with itself has looked at since the cloth was made.
long pairs_seen(const Cloth& cloth) {
    return cloth.solver->self_contact->contact.counts().triangle_pairs;
}

}  // namespace

WorkCount::WorkCount(const Cloth& cloth) : pairs_(pairs_seen(cloth)) {}

double WorkCount::of_steps(const Cloth& cloth, int steps) {
    const long now = pairs_seen(cloth), before = std::exchange(pairs_, now);
    return static_cast<double>(steps) * static_cast<double>(cloth.mesh.leaf_triangles().size()) +
           static_cast<double>(now - before);
}

}  // namespace selvedge::sim
