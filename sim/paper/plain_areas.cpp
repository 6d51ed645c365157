#include "sim/paper/plain_areas.h"

#include <algorithm>
#include <cmath>

#include "sim/core/error.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/size_names.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/polyline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

double area_within(const std::vector<Vec2d>& points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) twice += cross2(points[i], points[(i + 1) % points.size()]);
    return std::abs(twice) / 2;
}

// Whether points are off a line: of an outline that crosses itself, lobes that turn left and right may cancel out.
bool has_lobes(const std::vector<Vec2d>& points) {
    double area = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        area += std::abs(cross2(points[i] - points[0], points[i + 1] - points[0]));
    return area > 0;
}

PlainArea area_of_shape(const DrawnPath& path, std::size_t shape) {
    PlainArea area{.shape = shape};
    const Panel panel = as_panel(path);
    area.box = box_around(path.vertices);
    const double error = std::max(1e-9, 1e-3 * area.box.sizes().maxCoeff());
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> line = outline_polyline(panel, edge, error);
        area.points.insert(area.points.end(), line.begin(), line.end() - 1);
    }
    area.box.extend(box_around(area.points));
    area.area = area_within(area.points);
    return area;
}

// Of many points, evenly chosen ones.
std::vector<Vec2d> sampled(const std::vector<Vec2d>& points) {
    constexpr std::size_t kMost = 2000;
    const std::size_t step = (points.size() + kMost - 1) / kMost;
    std::vector<Vec2d> some;
    for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
    return some;
}

// The same outline, drawn again.
bool repeats(const PlainArea& area, const PlainArea& other) {
    constexpr double kSame = 5e-4;  // of its size: a curve, and the lines of which another program made it
    const double near = kSame * other.box.diagonal().norm();
    if ((area.box.min() - other.box.min()).norm() > near || (area.box.max() - other.box.max()).norm() > near ||
        std::abs(area.area - other.area) > 4 * kSame * other.area)
        return false;
    return std::ranges::all_of(sampled(area.points),
                               [&](const Vec2d& p) { return distance_to_outline(p, other.points) <= 2 * near; });
}

// Whether an area lies in another, whose outline it may touch: two of its points, half an outline apart, that lie off
// that outline are within.
bool lies_in(const PlainArea& inner, const PlainArea& outer) {
    constexpr double kTouching = 1e-3;  // of the outer one's size
    const double near = kTouching * outer.box.diagonal().norm();
    const Eigen::AlignedBox2d reach(outer.box.min().array() - near, outer.box.max().array() + near);
    if (!reach.contains(inner.box)) return false;
    const std::size_t count = inner.points.size();
    int within = 0;
    for (std::size_t from : {std::size_t{0}, count / 2}) {
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2d& p = inner.points[(from + i) % count];
            const Vec2d middle = (p + inner.points[(from + i + 1) % count]) / 2;
            const bool is_off = distance_to_outline(p, outer.points) > near;
            if (!is_off && !(distance_to_outline(middle, outer.points) > near)) continue;
            if (!is_inside(is_off ? p : middle, outer.points)) return false;
            ++within;
            break;
        }
    }
    return within > 0;
}

}  // namespace

std::vector<PlainArea> find_areas(const std::vector<PlainShape>& shapes, const std::string& file) {
    constexpr std::size_t kMost = 3000;
    std::vector<PlainArea> areas;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const DrawnPath& path = shapes[i].path;
        if (!path.is_closed || path.edges.size() < 2) continue;
        PlainArea area = area_of_shape(path, i);
        if (!(area.area > 0) && !has_lobes(area.points)) continue;
        const auto is_same = [&](const PlainArea& other) {
            return repeats(area, other) && size_of_shape(shapes[i]) == size_of_shape(shapes[other.shape]);
        };
        if (std::ranges::any_of(areas, is_same)) continue;
        areas.push_back(std::move(area));
        if (areas.size() > kMost) throw InputError(file, "", "more than 3,000 closed paths");
    }
    for (std::size_t a = 0; a < areas.size(); ++a) {
        for (std::size_t b = 0; b < areas.size(); ++b) {
            const bool is_around = a != b && areas[b].area > areas[a].area && lies_in(areas[a], areas[b]);
            if (is_around && (!areas[a].parent || areas[b].area < areas[*areas[a].parent].area)) areas[a].parent = b;
        }
    }
    return areas;
}

namespace {

bool is_inset_within(const PlainArea& inner, const PlainArea& outer, double spread) {
    if (!(inner.area > 0.5 * outer.area)) return false;
    double sum = 0;
    std::vector<double> distances;
    for (const Vec2d& p : sampled(inner.points)) {
        distances.push_back(distance_to_outline(p, outer.points));
        sum += distances.back();
    }
    const double mean = sum / static_cast<double>(distances.size());
    std::ranges::sort(distances);
    const double low = distances[distances.size() / 10], high = distances[distances.size() * 9 / 10];
    const double size = std::sqrt(outer.area);
    return mean > 0 && high - low < spread * mean && mean < 0.15 * size;
}

}  // namespace

bool is_inset(const PlainArea& inner, const PlainArea& outer) {
    constexpr double kSpread = 0.35;  // of the mean distance
    return is_inset_within(inner, outer, kSpread);
}

bool is_even_inset(const PlainArea& inner, const PlainArea& outer) {
    constexpr double kSpread = 0.1;  // of the mean distance
    return is_inset_within(inner, outer, kSpread);
}

bool fills_its_box(const PlainArea& area) {
    constexpr double kMost = 0.75;  // an ellipse fills 0.785
    return area.area > kMost * area.box.sizes().prod();
}

bool is_upright_rectangle(const PlainArea& area, const PlainShape& shape) {
    constexpr double kNear = 0.01;  // of its size
    if (std::ranges::any_of(shape.path.edges, [](const OutlineEdge& edge) { return edge.kind != CurveKind::Line; }))
        return false;
    const double near = kNear * area.box.sizes().minCoeff();
    return area.area > (1 - 2 * kNear) * area.box.sizes().prod() &&
           std::ranges::all_of(area.points, [&](const Vec2d& p) {
               const Vec2d low = (p - area.box.min()).cwiseAbs(), high = (p - area.box.max()).cwiseAbs();
               return std::min(low.minCoeff(), high.minCoeff()) <= near;
           });
}

}  // namespace selvedge::sim
