#include "sim/adaptive/configuration.h"

#include "sim/adaptive/configuration_tables.h"

namespace selvedge {

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

Configuration least_work(Configuration from, SplitMask split) {
    return kLeastWork[index_of(from)][split];
}

}  // namespace selvedge
