#include "bench/collide/grid_collider.h"

#include <algorithm>
#include <cmath>

#include "sim/core/assert.h"

namespace selvedge::bench {
GridCollider::GridCollider(const sim::SurfaceBvh& surface, float reach)
    : surface_(surface),
      reach_(reach),
      cell_size_(((surface.high() - surface.low()) / float(kCells)).cwiseMax(1e-6F)),
      first_(std::size_t(kCells) * kCells * kCells + 1, 0) {
    SELVEDGE_ASSERT(reach > 0);
    list_triangles();
}

GridCollider::CellRange GridCollider::cells_in(const Vec3f& low, const Vec3f& high) const {
    CellRange range{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = std::ptrdiff_t(axis);
        const auto cell = [&](float at) { return (at - surface_.low()[a]) / cell_size_[a]; };
        // Clamped to one cell outside the grid on either side, so that it fits an int. The upper border of the body's
        // box belongs to the last cell.
        range.first[axis] = int(std::clamp(std::floor(cell(low[a])), 0.0F, float(kCells)));
        range.last[axis] = int(std::clamp(std::floor(cell(high[a])), -1.0F, float(kCells - 1)));
        if (range.first[axis] == kCells && low[a] <= surface_.high()[a]) range.first[axis] = kCells - 1;
    }
    return range;
}

void GridCollider::list_triangles() {
    std::vector<std::vector<std::uint32_t>> lists(first_.size() - 1);
    const std::span<const Vec3f> x = surface_.points();
    for (std::uint32_t t = 0; t < surface_.triangles().size(); ++t) {
        if (!surface_.has_area(t)) continue;
        const auto [a, b, c] = surface_.triangles()[t];
        const CellRange range = cells_in(x[a].cwiseMin(x[b]).cwiseMin(x[c]), x[a].cwiseMax(x[b]).cwiseMax(x[c]));
        for (int k = range.first[2]; k <= range.last[2]; ++k)
            for (int j = range.first[1]; j <= range.last[1]; ++j)
                for (int i = range.first[0]; i <= range.last[0]; ++i) lists[place(i, j, k)].push_back(t);
    }
    for (std::size_t cell = 0; cell < lists.size(); ++cell) {
        const std::span<const std::uint32_t> list = lists[cell];
        for (std::size_t i = 0; i < list.size(); i += sim::TrianglePacket::kLanes) {
            const std::size_t count = std::min(sim::TrianglePacket::kLanes, list.size() - i);
            packets_.push_back(sim::make_packet(x, surface_.triangles(), list.subspan(i, count)));
        }
        first_[cell + 1] = std::uint32_t(packets_.size());
    }
}

float GridCollider::squared_distance(const CellIndex& cell, const Vec3f& p) const {
    const Vec3f low = surface_.low() + Vec3f(float(cell[0]), float(cell[1]), float(cell[2])).cwiseProduct(cell_size_);
    return (low - p).cwiseMax(p - (low + cell_size_)).cwiseMax(0).squaredNorm();
}

void GridCollider::test_cell(std::size_t cell, const Vec3f& p, sim::NearestTriangle& best) const {
    for (std::uint32_t packet = first_[cell]; packet < first_[cell + 1]; ++packet)
        best.test(*kernels_, packets_[packet], p);
}

// Searches the point's own cell first, then those cells within the reach that may contain a nearer triangle.
sim::Contact GridCollider::contact(const Vec3f& p) const {
    sim::NearestTriangle best{.squared = reach_ * reach_};
    const CellRange own = cells_in(p, p);
    std::size_t tested = first_.size();
    if (!own.is_empty()) {
        tested = place(own.first[0], own.first[1], own.first[2]);
        test_cell(tested, p, best);
    }
    const CellRange range = cells_in(p - Vec3f::Constant(reach_), p + Vec3f::Constant(reach_));
    constexpr float kHair = 1.0001F;  // tolerance for the rounding of a cell's box
    for (int k = range.first[2]; k <= range.last[2]; ++k)
        for (int j = range.first[1]; j <= range.last[1]; ++j)
            for (int i = range.first[0]; i <= range.last[0]; ++i) {
                const std::size_t cell = place(i, j, k);
                if (cell == tested || first_[cell] == first_[cell + 1]) continue;
                if (squared_distance({i, j, k}, p) <= best.squared * kHair) test_cell(cell, p, best);
            }
    if (!best.found()) return {reach_, Vec3f::Zero()};
    const sim::ClosestPoint closest = surface_.closest_on(best.triangle, p);
    return {closest.distance, closest.normal};
}

std::size_t GridCollider::bytes() const {
    return first_.size() * sizeof(std::uint32_t) + packets_.size() * sizeof(sim::TrianglePacket);
}

sim::Contact BvhCollider::contact(const Vec3f& p) const {
    const std::optional<sim::ClosestPoint> closest = surface_.closest(p, reach_);
    if (!closest || closest->distance >= reach_) return {reach_, Vec3f::Zero()};
    return {closest->distance, closest->normal};
}

}  // namespace selvedge::bench
