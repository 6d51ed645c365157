#include "sim/mesh/interior_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/mesh/planar.h"

namespace selvedge {
namespace {

constexpr double kGrowth = 0.35;        // of the wanted length, per metre from the outline
constexpr double kOffOutline = 0.6;     // of the wanted length: nearer to the outline no point is placed
constexpr double kOffNeighbours = 0.8;  // of the wanted length: nearer to another point no finer one is placed
constexpr int kMostLevels = 5;          // of the grid, each half as wide as the one before

struct Box {
    Vec2d low;
    Vec2d high;
};

Box box_of(std::span<const Vec2d> points) {
    Box box{points[0], points[0]};
    for (const Vec2d& p : points) {
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
    }
    return box;
}

// All points of a hexagonal grid over the box, row by row.
std::vector<Vec2d> hexagonal_grid(const Box& box, double edge, const GridPose& pose) {
    const Vec2d extent = pose.is_turned ? Vec2d((box.high - box.low).reverse()) : Vec2d(box.high - box.low);
    const double row_height = edge * std::numbers::sqrt3 / 2;
    const int rows = static_cast<int>(extent.y() / row_height) + 2;
    const int columns = static_cast<int>(extent.x() / edge) + 2;
    std::vector<Vec2d> points;
    for (int row = -1; row < rows; ++row) {
        for (int column = -1; column < columns; ++column) {
            const Vec2d p((column + pose.along + (row % 2 == 0 ? 0.0 : 0.5)) * edge, (row + pose.across) * row_height);
            points.push_back(box.low + (pose.is_turned ? Vec2d(p.reverse()) : p));
        }
    }
    return points;
}

bool has_room(const Vec2d& point, double wanted, std::span<const Vec2d> outline, std::span<const Vec2d> placed) {
    if (distance_to_outline(point, outline) < kOffOutline * wanted) return false;
    const double nearest = kOffNeighbours * wanted;
    return std::ranges::none_of(placed,
                                [&](const Vec2d& other) { return (other - point).squaredNorm() < nearest * nearest; });
}

}  // namespace

SizeField::SizeField(std::span<const Vec2d> outline, double target_edge)
    : outline_(outline), target_edge_(target_edge) {
    // The geometric mean: where a short edge meets a long one, it leads to better angles than the average.
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2d& before = outline[(i + outline.size() - 1) % outline.size()];
        const Vec2d& after = outline[(i + 1) % outline.size()];
        spacing_.push_back(std::sqrt((outline[i] - before).norm() * (after - outline[i]).norm()));
    }
}

double SizeField::at(const Vec2d& point) const {
    double wanted = target_edge_;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        if (spacing_[i] >= wanted) continue;
        wanted = std::min(wanted, spacing_[i] + kGrowth * (outline_[i] - point).norm());
    }
    return wanted;
}

double SizeField::smallest() const {
    return std::min(target_edge_, *std::ranges::min_element(spacing_));
}

std::vector<Vec2d> place_interior_points(std::span<const Vec2d> outline, const SizeField& size, double target_edge,
                                         const GridPose& pose) {
    const Box box = box_of(outline);
    std::vector<Vec2d> placed;
    double edge = target_edge;
    for (int level = 0; level < kMostLevels; ++level) {
        for (const Vec2d& point : hexagonal_grid(box, edge, pose)) {
            if (!is_inside(point, outline)) continue;
            const double wanted = size.at(point);
            if (wanted > 1.8 * edge) continue;  // a coarser grid has served this place
            if (has_room(point, wanted, outline, placed)) placed.push_back(point);
        }
        if (edge < 1.2 * size.smallest()) break;
        edge /= 2;
    }
    return placed;
}

}  // namespace selvedge
