#include "sim/place/elastic_waist.h"

#include <algorithm>

#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

bool is_worn_part(const Pattern& pattern, const std::vector<PanelRole>& roles, int panel, GarmentPart part) {
    return pattern.panels[as_size(panel)].is_worn && roles[as_size(panel)].part == part;
}

}  // namespace

std::vector<SeamSide> closed_waistband(const Pattern& pattern, const std::vector<PanelRole>& roles,
                                       const SewnEdges& sewn) {
    using enum GarmentPart;
    std::vector<SeamSide> band;
    bool bears = false;
    for (int p = 0; p < static_cast<int>(roles.size()); ++p) {
        if (!is_worn_part(pattern, roles, p, Waistband)) continue;
        const auto& own = sewn[as_size(p)];
        const auto is_end = [&](const SewnEdge& one) { return is_worn_part(pattern, roles, one.panel, Waistband); };
        constexpr int kEnds = 2;  // a seam of a panel with itself is there from both sides
        if (std::ranges::count_if(own, is_end) < kEnds) return {};
        bears =
            bears || std::ranges::any_of(own, [&](const SewnEdge& one) {
                return is_worn_part(pattern, roles, one.panel, Leg) || is_worn_part(pattern, roles, one.panel, Skirt);
            });
        for (int e = 0; e < static_cast<int>(pattern.panels[as_size(p)].edges.size()); ++e) {
            const auto joins_ends = [&](const SewnEdge& one) { return one.own.edge == e && is_end(one); };
            if (std::ranges::none_of(own, joins_ends)) band.push_back({.panel = p, .edge = e});
        }
    }
    return bears ? band : std::vector<SeamSide>();
}

bool gather_waistband(Pattern& pattern, const std::vector<SeamSide>& band, double waist, double hip) {
    constexpr double kOverHips = 0.97;  // of the hips' girth: flesh and cloth give way by 3 %
    constexpr double kAtRest = 0.9;     // of the waist: cutters make an elastic by a tenth shorter than the waist
    constexpr double kShortest = 0.2;   // of its edge (Elastic::share)
    double edges = 0;                   // m, both long edges
    for (const SeamSide& side : band) {
        const Panel& panel = panel_of(pattern, side);
        edges += outline_length(panel, panel.edges[as_size(side.edge)]);
    }
    const double length = edges / 2;
    if (band.empty() || !(waist > 0) || length < kOverHips * hip) return false;
    for (const SeamSide& side : band) {
        std::optional<Elastic>& elastic = pattern.panels[as_size(side.panel)].edges[as_size(side.edge)].elastic;
        if (!elastic) elastic = Elastic{.share = std::max(kShortest, kAtRest * waist / length)};
    }
    return true;
}

}  // namespace selvedge::sim
