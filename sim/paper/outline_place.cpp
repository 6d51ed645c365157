#include "sim/paper/outline_place.h"

#include <algorithm>

#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {

OutlinePlace place_on_edge(const Panel& panel, std::size_t edge, const Vec2d& p) {
    constexpr double kChordError = 1e-4;  // m
    const std::vector<Vec2d> line = outline_polyline(panel, panel.edges[edge], kChordError);
    OutlinePlace best{.edge = static_cast<int>(edge)};
    double total = 0, at = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2d along = line[i + 1] - line[i];
        const double length = along.norm(), s = nearest_fraction(p, line[i], line[i + 1]);
        const double distance = (line[i] + s * along - p).norm();
        if (distance < best.distance) best.distance = distance, at = total + s * length;
        total += length;
    }
    best.t = total > 0 ? std::clamp(at / total, 0.0, 1.0) : 0;
    return best;
}

OutlinePlace nearest_place(const Panel& panel, const Vec2d& p) {
    OutlinePlace best;
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        const OutlinePlace place = place_on_edge(panel, e, p);
        if (place.distance < best.distance) best = place;
    }
    return best;
}

}  // namespace selvedge::sim
