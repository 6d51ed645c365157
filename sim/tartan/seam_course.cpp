#include "sim/tartan/seam_course.h"

#include <algorithm>
#include <cmath>

#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr double kEase = 1e-3;          // m; what checking a pattern calls a difference, too
constexpr double kPointSpacing = 1e-3;  // m: the finest lines of a tartan are some 2 mm wide
constexpr double kChordError = 1e-6;    // m

// An outline edge as a polyline that is walked by its length.
class Walk {
 public:
    Walk(const Panel& panel, const OutlineEdge& edge) : points_(outline_polyline(panel, edge, kChordError)) {
        reached_.push_back(0);
        for (std::size_t i = 1; i < points_.size(); ++i) {
            reached_.push_back(reached_.back() + (points_[i] - points_[i - 1]).norm());
        }
    }

    double length() const { return reached_.back(); }

    Vec2d at(double fraction) const {
        const double wanted = fraction * length();
        const auto above = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, wanted);
        const auto i = static_cast<std::size_t>(above - reached_.begin());
        const double span = reached_[i] - reached_[i - 1];
        const double t = span > 0 ? std::clamp((wanted - reached_[i - 1]) / span, 0.0, 1.0) : 0.0;
        return points_[i - 1] + t * (points_[i] - points_[i - 1]);
    }

 private:
    std::vector<Vec2d> points_;
    std::vector<double> reached_;  // m along the edge, per point
};

const Panel& panel_of(const Pattern& pattern, const SeamSide& side) {
    return pattern.panels[static_cast<std::size_t>(side.panel)];
}

const OutlineEdge& edge_of(const Pattern& pattern, const SeamSide& side) {
    return panel_of(pattern, side).edges[static_cast<std::size_t>(side.edge)];
}

Vec2d turned_to_grain(const Vec2d& u, double grain) {
    const double c = std::cos(grain), s = std::sin(grain);
    return {c * u.x() + s * u.y(), -s * u.x() + c * u.y()};
}

Vec2d direction(const Vec2d& from, const Vec2d& to) {
    const double length = (to - from).norm();
    return length > 0 ? Vec2d((to - from) / length) : Vec2d(0, 0);
}

void find_directions(SeamCourse& course) {
    std::vector<CoursePoint>& points = course.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const CoursePoint& before = points[i == 0 ? 0 : i - 1];
        const CoursePoint& after = points[std::min(i + 1, points.size() - 1)];
        const Vec2d first = direction(before.first, after.first);
        const Vec2d second = direction(before.second, after.second);
        points[i].crossing = 0.5 * (first.cwiseAbs() + second.cwiseAbs());
        course.agreement += first.cwiseProduct(second) / static_cast<double>(points.size());
    }
}

void find_anchor(const Panel& panel, const Vec2d& start, const Vec2d& end, SeamCourse& course) {
    const double rise = panel.place(end).y() - panel.place(start).y();
    course.is_eased = std::abs(course.first_length - course.second_length) > kEase;
    course.is_upright = std::abs(rise) >= 0.5 * course.first_length;
    const std::size_t last = course.points.size() - 1;
    course.anchor = !course.is_upright ? last / 2 : rise > 0 ? 0 : last;
}

}  // namespace

SeamCourse find_course(const Pattern& pattern, const Seam& seam) {
    const Panel& first_panel = panel_of(pattern, seam.first);
    const Panel& second_panel = panel_of(pattern, seam.second);
    const Walk first(first_panel, edge_of(pattern, seam.first));
    const Walk second(second_panel, edge_of(pattern, seam.second));
    SeamCourse course;
    course.first_length = first.length();
    course.second_length = second.length();
    const double longer = std::max(first.length(), second.length());
    const int steps = static_cast<int>(std::clamp(std::ceil(longer / kPointSpacing), 64.0, 1024.0));
    for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps;
        course.points.push_back(
            {.first = turned_to_grain(first.at(t), first_panel.grain_angle),
             .second = turned_to_grain(second.at(seam.is_reversed ? 1 - t : t), second_panel.grain_angle)});
    }
    find_directions(course);
    find_anchor(first_panel, first.at(0), first.at(1), course);
    return course;
}

}  // namespace selvedge
