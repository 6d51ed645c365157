#pragma once
// A part of space, outside of which work may be left out: what is near some points.
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

class Region {
 public:
    // All of space.
    Region() = default;
    // What is within `near` (m) of one of the points along each axis, and up to half of that around it; more round
    // points that spread over more than 29 times as much. Points that are not finite have nothing near them.
    Region(std::span<const Vec3f> points, float near);

    bool contains(const Vec3f& p) const { return meets({p, p}); }
    bool meets(const Eigen::AlignedBox3f& box) const;
    // What is at most that much (m) outside of it.
    Region grown(float by) const;

 private:
    using Cell = Eigen::Array3i;
    static constexpr int kMostCells = 64;  // along each axis

    Cell cell_of(const Vec3f& p) const { return ((p - low_) / cell_).array().floor().cast<int>(); }
    template <class Use>
    void for_lines(int axis, const Use& use);
    std::int32_t& sum(const Cell& corner) { return sums_[index_of(corner)]; }
    std::size_t index_of(const Cell& corner) const {
        return static_cast<std::size_t>(corner.x() + (size_.x() + 1) * (corner.y() + (size_.y() + 1) * corner.z()));
    }

    bool is_everywhere_ = true;
    float grown_ = 0;  // m
    float cell_ = 1;   // m
    Vec3f low_ = Vec3f::Zero();
    Cell size_ = Cell::Zero();
    std::vector<std::int32_t> sums_;  // for each corner of the cells, how many below it are in the region
};

}  // namespace selvedge::sim
