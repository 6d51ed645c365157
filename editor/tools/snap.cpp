#include "editor/tools/snap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace selvedge::editor {
namespace {

double to_grid(double value, double step) {
    return step > 0 ? std::round(value / step) * step : value;
}

// Calls use(point, kind) for every point that can be snapped to.
template <class Use>
void for_each_point(const SheetGeometry& geometry, const SnapOptions& options, Use&& use) {
    for (const Vec2d& point : options.more_points) use(point, SnapKind::Point);
    for (const PanelShape& shape : geometry.panels()) {
        if (shape.is_hidden || options.moving_panels.contains(shape.panel.name)) continue;
        for (std::size_t i = 0; i < shape.panel.vertices.size(); ++i) {
            if (options.moving.contains({shape.panel.name, static_cast<int>(i)})) continue;
            use(shape.on_sheet(shape.panel.vertices[i]), SnapKind::Point);
        }
        for (std::size_t e = 0; e < shape.edges.size(); ++e) {
            const sim::OutlineEdge& edge = shape.panel.edges[e];
            if (options.moving.contains({shape.panel.name, edge.start}) ||
                options.moving.contains({shape.panel.name, edge.end})) {
                continue;
            }
            use(shape.on_sheet(shape.edges[e].at(0.5)), SnapKind::Midpoint);
        }
    }
}

struct Nearest {
    std::optional<Vec2d> point;
    double distance = 0;

    void offer(const Vec2d& offered, double away) {
        if (point && away >= distance) return;
        point = offered;
        distance = away;
    }
};

// The points nearest to the vertical and to the horizontal line through `wanted`, within the tolerance.
struct Lines {
    Nearest upright;  // on the vertical line: same x
    Nearest level;    // on the horizontal line: same y
};

Lines find_lines(const SheetGeometry& geometry, const Vec2d& wanted, const SnapOptions& options) {
    Lines lines;
    const auto offer = [&](const Vec2d& point) {
        const Vec2d away = (point - wanted).cwiseAbs();
        // A small weight of the other distance selects the nearest of several points on one line.
        if (away.x() <= options.tolerance) lines.upright.offer(point, away.x() + 1e-3 * away.y());
        if (away.y() <= options.tolerance) lines.level.offer(point, away.y() + 1e-3 * away.x());
    };
    for_each_point(geometry, options, [&](const Vec2d& point, SnapKind kind) {
        if (kind == SnapKind::Point) offer(point);
    });
    if (options.origin) offer(*options.origin);
    return lines;
}

Snap snap_to_direction(const SheetGeometry& geometry, const Vec2d& wanted, const SnapOptions& options) {
    const Vec2d origin = *options.origin;
    const Vec2d away = wanted - origin;
    if (away.norm() == 0) return {wanted, SnapKind::Direction, {}};
    const double step = std::numbers::pi / 4;
    const long eighth = std::lround(std::atan2(away.y(), away.x()) / step);
    const double diagonal = std::sqrt(0.5);
    const std::array<Vec2d, 8> directions{
        Vec2d(1, 0),  Vec2d(diagonal, diagonal),   Vec2d(0, 1),  Vec2d(-diagonal, diagonal),
        Vec2d(-1, 0), Vec2d(-diagonal, -diagonal), Vec2d(0, -1), Vec2d(diagonal, -diagonal)};
    const Vec2d& direction = directions[static_cast<std::size_t>((eighth + 8) % 8)];
    double length = away.dot(direction);
    Snap result{Vec2d::Zero(), SnapKind::Direction, {}};
    std::optional<Vec2d> met;
    if (options.is_on) {
        SnapOptions others = options;
        others.origin = {};
        const Lines lines = find_lines(geometry, origin + length * direction, others);
        if (lines.upright.point && std::abs(direction.x()) > 0.5) {
            met = lines.upright.point;
            length = (met->x() - origin.x()) / direction.x();
        } else if (lines.level.point && std::abs(direction.y()) > 0.5) {
            met = lines.level.point;
            length = (met->y() - origin.y()) / direction.y();
        } else {
            length = to_grid(length, options.grid);
        }
    }
    result.point = origin + length * direction;
    result.guides.push_back({origin, result.point});
    if (met) result.guides.push_back({*met, result.point});
    return result;
}

}  // namespace

Snap snap(const SheetGeometry& geometry, const Vec2d& wanted, const SnapOptions& options) {
    if (options.to_directions && options.origin) return snap_to_direction(geometry, wanted, options);
    if (!options.is_on) return {wanted, SnapKind::None, {}};
    if (options.to_points) {
        Nearest vertex, middle;
        for_each_point(geometry, options, [&](const Vec2d& point, SnapKind kind) {
            const double away = (point - wanted).norm();
            if (away <= options.tolerance) (kind == SnapKind::Point ? vertex : middle).offer(point, away);
        });
        if (vertex.point) return {*vertex.point, SnapKind::Point, {}};
        if (middle.point) return {*middle.point, SnapKind::Midpoint, {}};
    }
    const Vec2d gridded(to_grid(wanted.x(), options.grid), to_grid(wanted.y(), options.grid));
    Snap result{gridded, options.grid > 0 ? SnapKind::Grid : SnapKind::None, {}};
    if (!options.to_guides) return result;
    const Lines lines = find_lines(geometry, wanted, options);
    if (lines.upright.point) result.point.x() = lines.upright.point->x();
    if (lines.level.point) result.point.y() = lines.level.point->y();
    for (const Nearest& line : {lines.upright, lines.level}) {
        if (!line.point) continue;
        result.kind = SnapKind::Guide;
        result.guides.push_back({*line.point, result.point});
    }
    return result;
}

double snap_along(const EdgeShape& edge, double t, const SnapOptions& options) {
    if (!options.is_on || !(edge.length > 0)) return t;
    for (const double share : {1.0 / 2, 1.0 / 3, 2.0 / 3, 1.0 / 4, 3.0 / 4}) {
        if (std::abs(t - share) * edge.length <= options.tolerance / 2) return share;
    }
    constexpr double kMillimetre = 0.001;
    const double from_start = t * edge.length;
    const double near = t <= 0.5 ? from_start : edge.length - from_start;
    const double rounded = to_grid(near, kMillimetre);
    return std::clamp(t <= 0.5 ? rounded / edge.length : 1 - rounded / edge.length, 0.0, 1.0);
}

}  // namespace selvedge::editor
