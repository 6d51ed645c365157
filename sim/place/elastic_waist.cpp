#include "sim/place/elastic_waist.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

#include "sim/core/gravity.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kLeastFriction = 0.1;  // less slips down whatever holds it

bool is_worn_part(const Pattern& pattern, const std::vector<PanelRole>& roles, int panel, GarmentPart part) {
    return pattern.panels[as_size(panel)].is_worn && roles[as_size(panel)].part == part;
}

double total_length(const Pattern& pattern, const std::vector<SeamSide>& edges) {
    double length = 0;
    for (const SeamSide& side : edges) {
        const Panel& panel = panel_of(pattern, side);
        length += outline_length(panel, panel.edges[as_size(side.edge)]);
    }
    return length;
}

// Both long edges of a waistband that closes to a ring; empty: it does not.
std::vector<SeamSide> edges_of_band(const Pattern& pattern, const std::vector<PanelRole>& roles,
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

// The free edges at the top of trousers; empty: something else is worn above them.
std::vector<SeamSide> upper_edges_of_legs(const Pattern& pattern, const std::vector<PanelRole>& roles,
                                          const SewnEdges& sewn) {
    constexpr double kTop = 0.75;    // of the panel's height, from which on an edge is its upper one
    constexpr double kLevel = 0.75;  // least run of a level edge over its length
    std::vector<SeamSide> upper;
    for (int p = 0; p < static_cast<int>(roles.size()); ++p) {
        const Panel& panel = pattern.panels[as_size(p)];
        if (!panel.is_worn) continue;
        if (roles[as_size(p)].part == GarmentPart::Cuff) continue;
        if (roles[as_size(p)].part != GarmentPart::Leg) return {};
        const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
        for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) {
            const OutlineEdge& edge = panel.edges[as_size(e)];
            const Vec2d from = outline_point(panel, edge, 0), to = outline_point(panel, edge, 1);
            const bool is_free =
                std::ranges::none_of(sewn[as_size(p)], [&](const SewnEdge& one) { return one.own.edge == e; });
            // Outlines run counter-clockwise: upper edges to the left.
            const bool is_upper = from.x() - to.x() > kLevel * outline_length(panel, edge);
            const double low = box.min().y() + kTop * box.sizes().y();
            if (is_free && is_upper && std::min(from.y(), to.y()) > low) upper.push_back({.panel = p, .edge = e});
        }
    }
    return upper;
}

// N, of a ring that holds up what is worn by friction: it presses on what it goes round with 2 pi times its tension,
// however it is wide. Where it slips down, the body is wider, and it pulls more.
double tension_that_holds(const Pattern& pattern) {
    double weight = 0, friction = std::numeric_limits<double>::infinity();  // N; the least of all fabrics
    for (const Panel& panel : pattern.panels) {
        if (!panel.is_worn) continue;
        const Fabric fabric = find_fabric(panel.fabric.empty() ? pattern.fabric : panel.fabric);
        weight += kGravity * fabric.area_density * outline_area(panel);
        friction = std::min(friction, fabric.friction);
    }
    constexpr double kMargin = 1.25;  // for what pulls besides: folds that lie on each other, the jerk of a fall
    return kMargin * weight / (2 * std::numbers::pi * std::max(friction, kLeastFriction));
}

}  // namespace

ClosedWaist closed_waist(const Pattern& pattern, const std::vector<PanelRole>& roles, const SewnEdges& sewn) {
    ClosedWaist waist{.edges = edges_of_band(pattern, roles, sewn)};
    waist.length = total_length(pattern, waist.edges) / 2;
    if (!waist.edges.empty()) return waist;
    waist.edges = upper_edges_of_legs(pattern, roles, sewn);
    waist.length = total_length(pattern, waist.edges);
    return waist;
}

bool gather_waist(Pattern& pattern, const ClosedWaist& band, double waist, double hip) {
    constexpr double kOverHips = 0.97;  // of the hips' girth: flesh and cloth give way by 3 %
    constexpr double kAtRest = 0.9;     // of the waist: cutters make an elastic by a tenth shorter than the waist
    constexpr double kShortest = 0.2;   // of its edge (Elastic::share)
    if (band.edges.empty() || !(waist > 0) || band.length < kOverHips * hip) return false;
    constexpr double kStrain = 1 / kAtRest - 1;                      // round the waist
    const double stiffness = tension_that_holds(pattern) / kStrain;  // of each edge: one may lie on folds
    for (const SeamSide& side : band.edges) {
        std::optional<Elastic>& elastic = pattern.panels[as_size(side.panel)].edges[as_size(side.edge)].elastic;
        if (!elastic)
            elastic = Elastic{.share = std::max(kShortest, kAtRest * waist / band.length), .stiffness = stiffness};
    }
    return true;
}

}  // namespace selvedge::sim
