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

bool is_crossed_rightwards(const Vec2d& point, const Vec2d& start, const Vec2d& end) {
    if ((start.y() > point.y()) == (end.y() > point.y())) return false;
    return start.x() + (point.y() - start.y()) / (end.y() - start.y()) * (end.x() - start.x()) > point.x();
}

double distance_to_outline(const Vec2d& point, std::span<const Vec2d> outline) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        nearest = std::min(nearest, distance_to_segment(point, outline[i], outline[(i + 1) % outline.size()]));
    }
    return nearest;
}

bool segment_meets_box(const Vec2d& start, const Vec2d& end, const Eigen::AlignedBox2d& box) {
    const Vec2d along = end - start;
    double low = 0, high = 1;
    for (const Eigen::Index axis : {0, 1}) {
        const double below = box.min()[axis] - start[axis], above = box.max()[axis] - start[axis];
        if (along[axis] == 0) {
            if (below > 0 || above < 0) return false;
            continue;
        }
        low = std::max(low, std::min(below / along[axis], above / along[axis]));
        high = std::min(high, std::max(below / along[axis], above / along[axis]));
    }
    return low <= high;
}

}  // namespace selvedge::sim
