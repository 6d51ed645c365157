#include "sim/collide/thin_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace selvedge::sim {
namespace {

constexpr float kCell = 0.02F;  // m, about the width of a finger

using Cell = std::array<int, 3>;
using Triangles = std::vector<std::uint32_t>;

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

// Where the ray that enters the body through the triangle leaves it soon.
bool is_thin_through(const SurfaceBvh& surface, const Vec3f& x, const Vec3f& outward) {
    constexpr float kThin = 0.03F;         // m
    constexpr float kRounding = 0.00005F;  // m: begins below the triangle itself
    return surface.first_hit(x - kRounding * outward, x - kThin * outward).has_value();
}

using IsThin = std::function<bool(const Vec3f& x, const Vec3f& outward)>;

// Cells of thin triangles that belong together, with the triangles of each.
class ThinCells {
 public:
    ThinCells(const SurfaceBvh& surface, const IsThin& is_thin) {
        for (std::uint32_t t = 0; t < surface.triangles().size(); ++t) {
            if (!surface.has_area(t)) continue;
            const auto& [a, b, c] = surface.triangles()[t];
            const Vec3f middle = (surface.points()[a] + surface.points()[b] + surface.points()[c]) / 3;
            if (is_thin(middle, surface.face_normal(t))) cells_[cell_of(middle)].push_back(t);
        }
    }

    bool is_empty() const { return cells_.empty(); }

    // Takes a cell, and all that are connected with it.
    std::vector<Triangles> take_part() {
        std::vector<Triangles> part;
        std::vector<Cell> open{cells_.begin()->first};
        while (!open.empty()) {
            const Cell cell = open.back();
            open.pop_back();
            const auto found = cells_.find(cell);
            if (found == cells_.end()) continue;
            part.push_back(std::move(found->second));
            cells_.erase(found);
            for (int i = 0; i < 27; ++i)
                open.push_back({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1});
        }
        return part;
    }

 private:
    std::map<Cell, Triangles> cells_;
};

}  // namespace

std::vector<ThinPart> find_thin_parts(const SurfaceBvh& surface, const DistanceField& field) {
    ThinCells cells(surface, [&](const Vec3f& x, const Vec3f& outward) { return is_thin_below(field, x, outward); });
    std::vector<ThinPart> parts;
    while (!cells.is_empty()) {
        ThinPart& part = parts.emplace_back();
        for (const Triangles& cell : cells.take_part()) {
            Eigen::AlignedBox3f& box = part.cells.emplace_back();
            for (const std::uint32_t t : cell)
                for (const std::uint32_t v : surface.triangles()[t]) box.extend(surface.points()[v]);
            part.box.extend(box);
        }
    }
    return parts;
}

MovingThinParts::MovingThinParts(const SurfaceBvh& at_rest) {
    ThinCells cells(at_rest,
                    [&](const Vec3f& x, const Vec3f& outward) { return is_thin_through(at_rest, x, outward); });
    while (!cells.is_empty()) {
        std::vector<Vertices>& part = parts_.emplace_back();
        for (const Triangles& cell : cells.take_part()) {
            Vertices& vertices = part.emplace_back();
            for (const std::uint32_t t : cell)
                vertices.insert(vertices.end(), at_rest.triangles()[t].begin(), at_rest.triangles()[t].end());
            std::ranges::sort(vertices);
            vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        }
    }
}

std::vector<ThinPart> MovingThinParts::between(std::span<const Vec3f> from, std::span<const Vec3f> to) const {
    std::vector<ThinPart> parts(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        for (const Vertices& vertices : parts_[i]) {
            Eigen::AlignedBox3f& box = parts[i].cells.emplace_back();
            for (const std::uint32_t v : vertices) box.extend(from[v]).extend(to[v]);
            parts[i].box.extend(box);
        }
    }
    return parts;
}

bool is_near(std::span<const ThinPart> parts, const Eigen::AlignedBox3f& box) {
    return std::ranges::any_of(parts, [&](const ThinPart& part) {
        return part.box.intersects(box) &&
               std::ranges::any_of(part.cells, [&](const Eigen::AlignedBox3f& cell) { return cell.intersects(box); });
    });
}

}  // namespace selvedge::sim
