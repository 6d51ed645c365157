#include "sim/collide/thin_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace selvedge::sim {
namespace {

constexpr float kCell = 0.02F;  // m, about the width of a finger

using Cell = std::array<int, 3>;
using Cells = std::map<Cell, Eigen::AlignedBox3f>;

Cell cell_of(const Vec3f& x) {
    const auto index = [](float metres) { return static_cast<int>(std::floor(metres / kCell)); };
    return {index(x.x()), index(x.y()), index(x.z())};
}

// Inside a thick body the distance at a depth of one band is one band. Where it is clearly less, the other side is
// near.
bool is_thin_below(const DistanceField& field, const Vec3f& x, const Vec3f& outward) {
    constexpr float kClearly = 0.75F;
    return field.sample(x - field.band() * outward).distance > -kClearly * field.band();
}

Cells thin_cells(const SurfaceBvh& surface, const DistanceField& field) {
    Cells cells;
    for (std::uint32_t t = 0; t < surface.triangles().size(); ++t) {
        if (!surface.has_area(t)) continue;
        const auto& [a, b, c] = surface.triangles()[t];
        const std::array<Vec3f, 3> x{surface.points()[a], surface.points()[b], surface.points()[c]};
        const Vec3f normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized(), middle = (x[0] + x[1] + x[2]) / 3;
        if (!is_thin_below(field, middle, normal)) continue;
        cells[cell_of(middle)].extend(box_around(x));
    }
    return cells;
}

// Moves the cell, and all that are connected with it, to the part.
void collect(Cells& cells, const Cell& from, ThinPart& part) {
    std::vector<Cell> open{from};
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        const auto found = cells.find(cell);
        if (found == cells.end()) continue;
        part.box.extend(found->second);
        part.cells.push_back(found->second);
        cells.erase(found);
        for (int i = 0; i < 27; ++i)
            open.push_back({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1});
    }
}

}  // namespace

std::vector<ThinPart> find_thin_parts(const SurfaceBvh& surface, const DistanceField& field) {
    Cells cells = thin_cells(surface, field);
    std::vector<ThinPart> parts;
    while (!cells.empty()) collect(cells, Cell(cells.begin()->first), parts.emplace_back());
    return parts;
}

bool is_near(std::span<const ThinPart> parts, const Eigen::AlignedBox3f& box) {
    return std::ranges::any_of(parts, [&](const ThinPart& part) {
        return part.box.intersects(box) &&
               std::ranges::any_of(part.cells, [&](const Eigen::AlignedBox3f& cell) { return cell.intersects(box); });
    });
}

}  // namespace selvedge::sim
