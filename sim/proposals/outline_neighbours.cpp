#include "sim/proposals/outline_neighbours.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/polyline.h"
#include "sim/proposals/chain_shape.h"

namespace selvedge::sim {
namespace {

struct Stretch {
    std::vector<Vec2d> points;  // m
    std::vector<double> ends;   // m, how far along it each of its edges ends, from the edge that it is next to
};

// The stretch of the outline next to an edge, up to the next corner: a curve may be drawn as many pieces, each of them
// nearly straight.
Stretch stretch_beside(const Panel& panel, std::size_t edge, bool is_after) {
    constexpr double kCorner = 28 * std::numbers::pi / 180;  // rad: turns by less are no corners
    const std::size_t count = panel.edges.size(), step = is_after ? 1 : count - 1;
    Stretch stretch;
    std::size_t at = edge;
    for (std::size_t k = 0; k + 1 < count; ++k) {
        const std::size_t next = (at + step) % count;
        const OutlineEdge &before = panel.edges[is_after ? at : next], &after = panel.edges[is_after ? next : at];
        const Vec2d in = curve_direction(panel, before, EdgeEnd::End);
        const Vec2d out = curve_direction(panel, after, EdgeEnd::Start);
        if (k > 0 && std::abs(std::atan2(cross2(in, out), in.dot(out))) > kCorner) break;
        std::vector<Vec2d> piece = outline_polyline(panel, panel.edges[next], 1e-3);
        stretch.points.insert(is_after ? stretch.points.end() : stretch.points.begin(), piece.begin(), piece.end());
        const double begin = stretch.ends.empty() ? 0 : stretch.ends.back();
        stretch.ends.push_back(begin + outline_length(panel, panel.edges[next]));
        at = next;
    }
    return stretch;
}

}  // namespace

bool is_sleeve_hem(const OpenBoundary& boundary, const ChainView& view) {
    constexpr double kCurved = 0.012;
    constexpr double kRound = 0.05;  // bulge; seams that bend at the elbow have half of that
    const EdgeSpan& first = boundary.atom(view.chain.atoms.front()).span;
    const EdgeSpan& last = boundary.atom(view.chain.atoms.back()).span;
    const Panel& panel = boundary.pattern().panels[as_size(first.panel)];
    const std::size_t count = panel.edges.size();
    const auto is_curved = [&](std::size_t edge, bool is_after) {
        const std::size_t next = (edge + (is_after ? 1 : count - 1)) % count;
        return std::abs(bulge(outline_polyline(panel, panel.edges[next], 1e-3))) > kCurved ||
               std::abs(bulge(stretch_beside(panel, edge, is_after).points)) > kRound;
    };
    return !is_curved(as_size(first.edge), false) && !is_curved(as_size(last.edge), true);
}

bool leaves_no_armhole(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, const ChainView& a,
                       const ChainView& b) {
    constexpr double kUp = 0.75, kStraight = 0.99, kShortest = 0.03;  // of the length; m
    constexpr double kAlike = 0.02;                                   // of the length
    constexpr double kInside = 1e-7;  // of a side, so that its end is on the edge that is meant
    const auto panel_of = [&](const ChainView& side) {
        return as_size(boundary.atom(place_on(boundary, side, 0.5).atom).span.panel);
    };
    const PanelFacts &of_a = facts[panel_of(a)], &of_b = facts[panel_of(b)];
    if (of_a.role.part != GarmentPart::Torso || of_b.role.part != GarmentPart::Torso ||
        of_a.role.face == of_b.role.face)
        return false;
    const double rise_a = rise_along(boundary, a), rise_b = rise_along(boundary, b);
    if (std::abs(rise_a) < kUpright || std::abs(rise_b) < kUpright) return false;
    // Outlines run counter-clockwise: a side that rises has its shoulder after it, one that falls before it. A level
    // shoulder may go on in the neckline, and end at one of the vertices of that line.
    const auto shoulders = [&](const ChainView& side, double rise, const PanelFacts& facts_of_panel) {
        const ChainPlace top = place_on(boundary, side, rise > 0 ? 1 - kInside : kInside);
        const EdgeSpan& span = boundary.atom(top.atom).span;
        auto [points, lengths] =
            stretch_beside(boundary.pattern().panels[as_size(span.panel)], as_size(span.edge), rise > 0);
        const double length = polyline_length(points);
        const bool is_top = points.front().x() - points.back().x() > kUp * length && straightness(points) > kStraight;
        std::erase_if(lengths, [&](double one) {
            return !is_top || one < kShortest || one > kWidestShoulder * facts_of_panel.width;
        });
        return lengths;
    };
    const std::vector<double> one = shoulders(a, rise_a, of_a), other = shoulders(b, rise_b, of_b);
    return std::ranges::any_of(one, [&](double length) {
        return std::ranges::any_of(other, [&](double like) { return std::abs(like - length) < kAlike * length; });
    });
}

}  // namespace selvedge::sim
