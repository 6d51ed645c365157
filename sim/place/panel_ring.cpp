#include "sim/place/panel_ring.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <optional>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/place/placement.h"
#include "sim/proposals/panel_role.h"

namespace selvedge::sim {
namespace {

// The panel that is sewn to one side of this one (side 1: its right, -1: its left), and by how much higher its origin
// lies.
struct Neighbour {
    std::size_t panel = 0;
    double rise = 0;  // m
};
std::optional<Neighbour> neighbour_of(const Pattern& pattern, const SewnEdges& sewn, std::size_t p, double side) {
    const Panel& own = pattern.panels[p];
    const double axis = outline_box(own, 1e-3).center().x();
    std::optional<Neighbour> found;
    int count = 0;
    for (const SewnEdge& one : sewn[p]) {
        const auto other = as_size(one.panel);
        const OutlineEdge& edge = own.edges[as_size(one.own.edge)];
        const Vec2d along = outline_point(own, edge, 1) - outline_point(own, edge, 0);
        const Vec2d at = middle_of_edge(pattern, one.own);
        if (other == p || std::abs(along.y()) < std::abs(along.x()) || side * (at.x() - axis) <= 0) continue;
        if (found && found->panel != other) continue;
        if (!found) found = Neighbour{.panel = other};
        found->rise += at.y() - middle_of_edge(pattern, one.other).y();
        ++count;
    }
    if (found) found->rise /= count;
    return found;
}

// How wide a panel is at a height, m.
double width_at(const Panel& panel, double y) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> points = outline_polyline(panel, edge, 1e-3);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vec2d &a = points[i], &b = points[i + 1];
            if ((a.y() - y) * (b.y() - y) > 0 || a.y() == b.y()) continue;
            const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
            low = std::min(low, x);
            high = std::max(high, x);
        }
    }
    return std::max(0.0, high - low);
}

// The height in the first panel at which the ring is narrowest, m.
double narrowest(const Pattern& pattern, const std::deque<RingPlace>& ring, const RingPlace& first) {
    constexpr int kLevels = 24;
    constexpr double kEnds = 0.2;  // of the height, at its ends, which are no waist
    const Eigen::AlignedBox2d box = outline_box(pattern.panels[first.panel], 1e-3);
    double best = box.center().y(), least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kLevels; ++i) {
        const double y = box.min().y() + (kEnds + (1 - 2 * kEnds) * i / kLevels) * box.sizes().y();
        double round = 0;
        for (const RingPlace& place : ring) round += width_at(pattern.panels[place.panel], y + first.rise - place.rise);
        if (round < least) least = round, best = y;
    }
    return best;
}

}  // namespace

std::vector<RingPlace> ring_of(const Pattern& pattern, const SewnEdges& sewn, std::size_t first,
                               const std::function<bool(std::size_t)>& may_be) {
    std::deque<RingPlace> ring{{.panel = first}};
    for (const double side : {1.0, -1.0}) {
        for (;;) {
            const RingPlace end = side > 0 ? ring.back() : ring.front();
            const auto next = neighbour_of(pattern, sewn, end.panel, side);
            if (!next || !may_be(next->panel) || std::ranges::find(ring, next->panel, &RingPlace::panel) != ring.end())
                break;
            const RingPlace place{.panel = next->panel, .rise = end.rise + next->rise};
            side > 0 ? ring.push_back(place) : ring.push_front(place);
        }
    }
    if (ring.size() < 2) return {};
    const auto has_image = [&](const RingPlace& place) {
        return std::ranges::any_of(
            pattern.panels, [&](const Panel& other) { return are_mirror_images(pattern.panels[place.panel], other); });
    };
    const auto width = [&](const RingPlace& place) {
        return outline_box(pattern.panels[place.panel], 1e-3).sizes().x();
    };
    double round = 0;
    for (const RingPlace& place : ring) round += width(place);
    auto front = std::ranges::find_if_not(ring, has_image);
    if (front == ring.end()) front = ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2);
    double reached = 0, middle = 0;  // m
    for (RingPlace& place : ring) {
        place.turn = reached + width(place) / 2;
        reached += width(place);
        if (place.panel == front->panel) middle = place.turn;
    }
    const double waist = narrowest(pattern, ring, *front), rise = front->rise;
    for (RingPlace& place : ring) {
        place.turn = (place.turn - middle) / round * 2 * std::numbers::pi;
        place.rise -= rise + waist;
    }
    return {ring.begin(), ring.end()};
}

void arrange_ring(Pattern& pattern, const std::vector<RingPlace>& ring, const Vec3d& waist, double least_radius) {
    double round = 0;
    for (const RingPlace& place : ring) round += outline_box(pattern.panels[place.panel], 1e-3).sizes().x();
    for (const RingPlace& place : ring) {
        Panel& panel = pattern.panels[place.panel];
        ArrangementPoint point;
        point.radius = std::max(least_radius, round / (2 * std::numbers::pi));
        point.position = waist + point.radius * point.outward;
        point.position.y() += place.rise + outline_box(panel, 1e-3).center().y();
        arrange(panel, turned(point, waist, place.turn));
    }
}

}  // namespace selvedge::sim
