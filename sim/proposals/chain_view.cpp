#include "sim/proposals/chain_view.h"

#include <algorithm>

#include "sim/core/math.h"

namespace selvedge::sim {
namespace {}  // namespace

double length_of(const ChainView& view) {
    return (view.to - view.from) * view.chain.length;
}

ChainPlace place_on(const OpenBoundary& boundary, const ChainView& view, double t) {
    const std::size_t count = view.chain.atoms.size();
    const double along = view.from + t * (view.to - view.from);
    double reached = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const int a = view.chain.atoms[(as_size(view.first) + k) % count];
        const double share = boundary.atom(a).length / view.chain.length;
        if (along <= reached + share || k + 1 == count)
            return {a, std::clamp(share > 0 ? (along - reached) / share : 0.0, 0.0, 1.0)};
        reached += share;
    }
    return {};
}

std::vector<AtomNotch> notches_of(const OpenBoundary& boundary, const Chain& chain) {
    std::vector<AtomNotch> found;
    for (std::size_t i = 0; i < chain.atoms.size(); ++i) {
        const EdgeSpan& span = boundary.atom(chain.atoms[i]).span;
        for (const Notch& notch : boundary.pattern().panels[as_size(span.panel)].notches) {
            if (notch.edge != span.edge || notch.t < span.from || notch.t > span.to) continue;
            found.push_back({i, (notch.t - span.from) / (span.to - span.from), notch.count});
        }
    }
    return found;
}

std::vector<double> joints_of(const OpenBoundary& boundary, const ChainView& view) {
    std::vector<double> joints;
    double reached = 0;
    const std::size_t count = view.chain.atoms.size();
    for (std::size_t k = 0; k + 1 < count; ++k) {
        reached += boundary.atom(view.chain.atoms[(as_size(view.first) + k) % count]).length / view.chain.length;
        const double t = (reached - view.from) / (view.to - view.from);
        if (t > 1e-6 && t < 1 - 1e-6) joints.push_back(t);
    }
    return joints;
}

}  // namespace selvedge::sim
