#include "sim/proposals/twin_evidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/core/math.h"
#include "sim/pattern/polyline.h"
#include "sim/proposals/chain_shape.h"

namespace selvedge::sim {
namespace {

constexpr double kNever = -100;
constexpr double kSure = 3.5, kLikely = 1.2, kPossible = 0.5;  // odds

// Whether the chain is the panel's edge in the middle of the body, where its name tells its side and its face; none: it
// does not.
std::optional<bool> is_towards_middle(const PanelFacts& facts, const std::vector<Vec2d>& points) {
    if (facts.role.flank == Flank::None || facts.role.face == Face::None) return std::nullopt;
    // Seen from outside, a left front and a right back have the middle on their left.
    const bool is_left = (facts.role.face == Face::Front) == (facts.role.flank == Flank::Left);
    constexpr double kNear = 0.25;  // of the panel's width
    const double out = (points[points.size() / 2].x() - facts.axis) * (is_left ? -1 : 1);
    return out > (0.5 - kNear) * facts.width;
}

// The crotch is in the upper part of a leg: both ends lie high. On a panel that goes round the leg, it is a notch
// between front and back, deeper than it is wide by half.
double odds_of_crotch(const OpenBoundary& boundary, int own, const std::vector<Vec2d>& points) {
    constexpr double kLowest = 0.25;  // of the panel's height
    const Panel& panel = boundary.pattern().panels[as_size(own)];
    const auto [low, high] = std::ranges::minmax(panel.vertices, {}, [](const Vec2d& v) { return v.y(); });
    const double least = low.y() + kLowest * (high.y() - low.y());
    if (points.front().y() < least || points.back().y() < least) return kNever;
    // Bulge, straightness: a notch bulges the less, the narrower it is; of one that is four times as deep as it is wide
    // -0.04.
    constexpr double kDeep = -0.04, kBent = 0.6;
    if (bulge(points) < kDeep && straightness(points) < kBent) return kSure;
    return std::abs(rise(points)) < 0.4 ? kNever : kLikely;
}

// The middle seam of a hood is its long round edge, unless a strip lies between its sides.
double odds_of_hood(const std::vector<PanelFacts>& facts, const std::vector<Vec2d>& points) {
    const bool has_strip = std::ranges::any_of(
        facts, [](const PanelFacts& one) { return one.role.part == GarmentPart::Hood && one.is_symmetric; });
    if (has_strip) return kNever;
    return bulge(points) > 0.05 ? kLikely : kNever;
}

// Halves of collars and bands meet at the end that is square.
double odds_of_band(const OpenBoundary& boundary, const PanelFacts& facts, int own, int twin, const Chain& chain,
                    const std::vector<Vec2d>& points) {
    constexpr double kSquare = 0.2;  // rad, from a right angle
    const double right = std::numbers::pi / 2;
    const std::vector<int> joined = boundary.joined_panels(own);
    if (std::ranges::find(joined, twin) != joined.end()) return kNever;
    if (const auto is_middle = is_towards_middle(facts, points); is_middle && !*is_middle) return kNever;
    if (facts.role.face == Face::Front && facts.role.part == GarmentPart::Collar) return kNever;
    if (polyline_length(points) > 0.6 * std::max(facts.width, facts.height)) return kNever;
    const bool is_square =
        std::abs(chain.angle_before - right) < kSquare && std::abs(chain.angle_after - right) < kSquare;
    if (is_towards_middle(facts, points)) return kSure;
    return is_square ? kPossible : -1;
}

// A seam in the middle of the front or the back is upright, and the panel's other side has found its seam.
double odds_of_middle(const OpenBoundary& boundary, const PanelFacts& facts, int own, int twin,
                      const std::vector<Vec2d>& points) {
    constexpr double kTorso = 0.94;  // rise, 20 degrees from upright: fronts that lie over each other slant more
    const double least = facts.role.part == GarmentPart::Torso ? kTorso : kUpright;
    if (facts.is_outer || std::abs(rise(points)) < least) return kNever;
    if (facts.rank > 1 && facts.rank < facts.row_length) return kNever;
    constexpr double kShort = 0.15;  // of the panel's height: as the corner of a lapel
    if (facts.role.part == GarmentPart::Torso && polyline_length(points) < kShort * facts.height) return kNever;
    if (facts.role.face == Face::Front && facts.role.part == GarmentPart::Torso && facts.has_opening) return -4;
    if (straightness(points) < 0.97 || bulge(points) < -0.02) return kNever;  // an armhole, or a neckline
    if (const auto is_middle = is_towards_middle(facts, points))
        return *is_middle && std::abs(rise(points)) > 0.95 ? kSure : kNever;
    const double x = points[points.size() / 2].x();
    bool is_other_side_sewn = false;
    for (const int other : boundary.joined_panels(own)) {
        if (other == twin) continue;
        for (const int atom : boundary.atoms_between(own, other)) {
            const Vec2d from = boundary.point(atom, 0), to = boundary.point(atom, 1);
            if (std::abs(to.y() - from.y()) < kUpright * (to - from).norm()) continue;
            if (std::abs((from.x() + to.x()) / 2 - x) > 0.3 * facts.width) is_other_side_sewn = true;
        }
    }
    return is_other_side_sewn ? kLikely : -2.5;
}

}  // namespace

double odds_of_twins(const OpenBoundary& boundary, const std::vector<PanelFacts>& facts, int own, int twin,
                     const Chain& chain, const std::vector<Vec2d>& points) {
    using enum GarmentPart;
    const PanelFacts& one = facts[as_size(own)];
    switch (one.role.part) {
        case Leg:
            return odds_of_crotch(boundary, own, points);
        case Hood:
            return odds_of_hood(facts, points);
        case Collar:
        case CollarStand:
        case Waistband:
        case Yoke:
            return odds_of_band(boundary, one, own, twin, chain, points);
        case Torso:
        case Skirt:
        case Unknown:
            return odds_of_middle(boundary, one, own, twin, points);
        case Sleeve:
        case Cuff:
        case Binding:
        case Accessory:
            break;
    }
    return kNever;
}

}  // namespace selvedge::sim
