#include "sim/pattern/segment_distance.h"

#include <algorithm>
#include <limits>

namespace selvedge::sim {

double nearest_fraction(const Vec2d& point, const Vec2d& start, const Vec2d& end) {
    const Vec2d along = end - start;
    const double squared = along.squaredNorm();
    return squared > 0 ? std::clamp((point - start).dot(along) / squared, 0.0, 1.0) : 0.0;
}

double distance_to_segment(const Vec2d& point, const Vec2d& start, const Vec2d& end) {
    const double t = nearest_fraction(point, start, end);
    return (point - start - t * (end - start)).norm();
}

double distance_to_outline(const Vec2d& point, std::span<const Vec2d> outline) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        nearest = std::min(nearest, distance_to_segment(point, outline[i], outline[(i + 1) % outline.size()]));
    }
    return nearest;
}

}  // namespace selvedge::sim
