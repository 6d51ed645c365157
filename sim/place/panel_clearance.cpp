#include "sim/place/panel_clearance.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {

float clearance_of(const Panel& panel, const BodyCollider& body) {
    constexpr int kSpots = 16;            // along each side of the panel's box
    constexpr double kChordError = 1e-3;  // m
    const Eigen::AlignedBox2d box = outline_box(panel, kChordError);
    std::vector<Vec2d> outline;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> line = outline_polyline(panel, edge, kChordError);
        outline.insert(outline.end(), line.begin(), line.end() - 1);
    }
    float least = std::numeric_limits<float>::infinity();
    const auto take = [&](const Vec2d& u) {
        least = std::min(least, body.contact(panel.place(u).cast<float>()).distance);
    };
    for (const Vec2d& u : outline) take(u);
    for (int i = 0; i < kSpots * kSpots; ++i) {
        const Vec2d share((i % kSpots + 0.5) / kSpots, (i / kSpots + 0.5) / kSpots);
        const Vec2d u = box.min() + share.cwiseProduct(box.sizes());
        if (is_inside(u, outline)) take(u);
    }
    return least;
}

}  // namespace selvedge::sim
