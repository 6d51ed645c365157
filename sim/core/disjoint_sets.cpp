#include "sim/core/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace selvedge::sim {

DisjointSets::DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::find(int element) {
    auto at = static_cast<std::size_t>(element);
    while (parent_[at] != static_cast<int>(at)) {
        parent_[at] = parent_[static_cast<std::size_t>(parent_[at])];
        at = static_cast<std::size_t>(parent_[at]);
    }
    return static_cast<int>(at);
}

void DisjointSets::join(int a, int b) {
    const int root_a = find(a);
    const int root_b = find(b);
    parent_[static_cast<std::size_t>(std::max(root_a, root_b))] = std::min(root_a, root_b);
}

}  // namespace selvedge::sim
