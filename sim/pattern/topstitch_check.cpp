#include "sim/pattern/topstitch_check.h"

#include <cmath>
#include <vector>

#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

// A point of a line, and the unit vector to its left.
struct Beside {
    Vec2d at = Vec2d::Zero();
    Vec2d left = Vec2d::Zero();
};

Beside middle_of(const Vec2d& before, const Vec2d& at, const Vec2d& after) {
    const Vec2d along = (after - before).normalized();
    return {at, Vec2d(-along.y(), along.x())};
}

Beside middle_of(const Panel& panel, const OutlineEdge& edge) {
    constexpr double kStep = 0.01;  // of the edge's length, for its direction
    return middle_of(outline_point(panel, edge, 0.5 - kStep), outline_point(panel, edge, 0.5),
                     outline_point(panel, edge, 0.5 + kStep));
}

std::vector<Vec2d> polygon_of(const Panel& panel) {
    constexpr double kChordError = 1e-4;  // m
    std::vector<Vec2d> points;
    for (const OutlineEdge& edge : panel.edges) {
        const std::vector<Vec2d> line = outline_polyline(panel, edge, kChordError);
        points.insert(points.end(), line.begin(), line.end() - 1);
    }
    return points;
}

bool are_on_each_other(const Topstitch& rows) {
    return rows.rows > 1 && std::abs(rows.distances.y()) < rows.thread.thickness;
}

// The distance of a row from the line, m, to its left.
double distance_of(const Topstitch& rows, int row) {
    return rows.distances.x() + row * rows.distances.y();
}

// is_on_cloth tells it of a row's distance.
template <class IsOnCloth>
std::optional<std::string> problem_of(const std::optional<Topstitch>& rows, const IsOnCloth& is_on_cloth) {
    if (!rows) return std::nullopt;
    if (are_on_each_other(*rows)) return "the rows of stitches lie on each other";
    for (int row = 0; row < rows->rows; ++row) {
        if (!is_on_cloth(distance_of(*rows, row)))
            return "row " + std::to_string(row + 1) + " of the stitches lies off the cloth";
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> topstitch_problem(const Panel& panel, const OutlineEdge& edge) {
    if (!edge.topstitch) return std::nullopt;
    const std::vector<Vec2d> outline = polygon_of(panel);
    const Beside middle = middle_of(panel, edge);
    return problem_of(edge.topstitch,
                      [&](double distance) { return is_inside(middle.at + distance * middle.left, outline); });
}

std::optional<std::string> topstitch_problem(const Panel& panel, const InternalLine& line) {
    if (!line.topstitch || line.points.size() < 2) return std::nullopt;
    const std::vector<Vec2d> outline = polygon_of(panel);
    const std::size_t end = line.points.size() / 2;
    const Vec2d &from = line.points[end - 1], &to = line.points[end];
    if (from == to) return std::nullopt;
    const Beside middle = middle_of(from, (from + to) / 2, to);
    return problem_of(line.topstitch,
                      [&](double distance) { return is_inside(middle.at + distance * middle.left, outline); });
}

// The left is on the first panel, the right on the second.
std::optional<std::string> topstitch_problem(const Pattern& pattern, const Seam& seam) {
    if (!seam.topstitch) return std::nullopt;
    return problem_of(seam.topstitch, [&](double distance) {
        const SeamSide& side = distance >= 0 ? seam.first : seam.second;
        const Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
        const Beside middle = middle_of(panel, panel.edges[static_cast<std::size_t>(side.edge)]);
        return is_inside(middle.at + std::abs(distance) * middle.left, polygon_of(panel));
    });
}

}  // namespace selvedge::sim
