#include "sim/pattern/polyline.h"

#include <algorithm>
#include <limits>

#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {

double polyline_length(const std::vector<Vec2d>& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    return length;
}

double distance_to_polyline(const Vec2d& point, const std::vector<Vec2d>& line) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, distance_to_segment(point, line[i - 1], line[i]));
    return least;
}

Eigen::AlignedBox2d box_around(const std::vector<Vec2d>& points) {
    Eigen::AlignedBox2d box;
    for (const Vec2d& p : points) box.extend(p);
    return box;
}

}  // namespace selvedge::sim
