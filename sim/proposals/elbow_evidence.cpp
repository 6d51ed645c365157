#include "sim/proposals/elbow_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/proposals/chain_shape.h"

namespace selvedge::sim {
namespace {

// x of the middle between both sides of a panel at a height, m.
double middle_at(const Panel& panel, double y) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> points = outline_polyline(panel, edge, 1e-3);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Vec2d &a = points[i - 1], &b = points[i];
            if ((a.y() > y) == (b.y() > y)) continue;
            const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
            low = std::min(low, x);
            high = std::max(high, x);
        }
    }
    return (low + high) / 2;
}

// How far the elbow lies beside the line from the forearm to the underarm, along x, m. A vent lies below. underarm: y,
// m.
double bend_of_sleeve(const Panel& panel, double underarm) {
    constexpr double kForearm = 0.35, kElbow = 0.65, kUpperArm = 0.95;  // of the height up to the underarm
    const double hem = outline_box(panel, 1e-3).min().y();
    const auto middle = [&](double share) { return middle_at(panel, hem + share * (underarm - hem)); };
    return middle(kElbow) - (middle(kForearm) + middle(kUpperArm)) / 2;
}

// Where the places of a sleeve's panel lie that are sewn to one face, as a sum.
struct Places {
    double x = 0;  // m
    int count = 0;

    double mean() const { return x / count; }
};

}  // namespace

double odds_of_elbow(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& armhole,
                     const ChainView& cap) {
    constexpr double kWorth = 1;                   // odds of each panel
    constexpr double kLeastBend = 0.003;           // m
    constexpr int kLeastPlaces = 2;                // on each face
    std::map<int, std::map<Face, Places>> places;  // by panel of the sleeve
    std::map<int, double> underarms;               // y of the lowest place of the cap, m
    for (int i = 0; i < kChainSamples; ++i) {
        const double t = (i + 0.5) / kChainSamples;
        const ChainPlace at = place_on(boundary, cap, t), partner = place_on(boundary, armhole, 1 - t);
        const Face face = facts[as_size(boundary.atom(partner.atom).span.panel)].role.face;
        Places& own = places[boundary.atom(at.atom).span.panel][face];
        const Vec2d point = boundary.point(at.atom, at.t);
        own.x += point.x();
        ++own.count;
        const auto [underarm, is_new] = underarms.try_emplace(boundary.atom(at.atom).span.panel, point.y());
        underarm->second = std::min(underarm->second, point.y());
    }
    double odds = 0;
    for (auto& [panel, faces] : places) {
        const Places &front = faces[Face::Front], &back = faces[Face::Back];
        if (std::min(front.count, back.count) < kLeastPlaces) continue;
        const double bend = bend_of_sleeve(boundary.pattern().panels[as_size(panel)], underarms[panel]);
        if (!(std::abs(bend) >= kLeastBend) || !std::isfinite(bend)) continue;  // no elbow under so low an underarm
        odds += (bend > 0) == (back.mean() > front.mean()) ? kWorth : -kWorth;
    }
    return odds;
}

}  // namespace selvedge::sim
