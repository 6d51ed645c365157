#include "sim/adaptive/configuration.h"

#include "sim/adaptive/configuration_tables.h"
#include "sim/core/assert.h"

namespace selvedge::sim {

using namespace configuration_tables;

const Layout& layout(Configuration c) {
    return kLayouts[index_of(c)];
}

const Transition& transition(Configuration from, Configuration to) {
    return kTransitions[index_of(from)][index_of(to)];
}

std::size_t state_of(SplitMask split) {
    return kStateOfSplit[split];
}

std::size_t state_of(Configuration c) {
    return state_of(layout(c).split);
}

bool is_ambiguous(SplitMask split) {
    const std::size_t state = state_of(split);
    return 4 <= state && state <= 6;
}

AmbiguousSplit ambiguous_split(SplitMask split) {
    SELVEDGE_ASSERT(is_ambiguous(split));
    const std::size_t first = 2 * state_of(split) - 4;  // S4: C4 and C5
    AmbiguousSplit ways{{static_cast<Configuration>(first), static_cast<Configuration>(first + 1)}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        const Layout& own = kLayouts[first + i];
        for (std::size_t k = 0; k < own.edge_count; ++k) {
            if (slot_of(kLayouts[first + 1 - i], own.edges[k]) == kNoSlot) ways.diagonals[i] = own.edges[k];
        }
    }
    return ways;
}

Configuration minimal_change(Configuration from, SplitMask split) {
    return kMinimalChange[index_of(from)][split];
}

}  // namespace selvedge::sim
