#include "sim/core/region.h"

#include <algorithm>
#include <bit>

namespace selvedge::sim {

// use(at): at(i) is the number at the i'th corner along a line.
template <class Use>
void Region::for_lines(int axis, const Use& use) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    Cell corner = Cell::Zero();
    for (corner[second] = 0; corner[second] <= size_[second]; ++corner[second]) {
        for (corner[third] = 0; corner[third] <= size_[third]; ++corner[third]) {
            use([&](int i) -> std::int32_t& {
                corner[axis] = i;
                return sum(corner);
            });
        }
    }
}

// Two cells are as wide as `near`: so many on each side of a point's cell hold what is near it.
Region::Region(std::span<const Vec3f> points, float near) : is_everywhere_(false) {
    constexpr int kBeside = 2;
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : points)
        if (p.allFinite()) box.extend(p);
    if (box.isEmpty()) return;
    cell_ = std::max(near / kBeside, box.sizes().maxCoeff() / (kMostCells - 2 * kBeside - 1));
    low_ = box.min() - Vec3f::Constant(kBeside * cell_);
    size_ = (cell_of(box.max()) + 1 + kBeside).min(kMostCells);
    sums_.assign(index_of(size_) + 1, 0);
    for (const Vec3f& p : points)
        if (p.allFinite()) sum((cell_of(p) + 1).min(size_)) = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const int count = size_[axis];
        for_lines(axis, [count](const auto& at) {
            std::uint64_t is_near = 0;  // by cell
            for (int i = 0; i < count; ++i)
                for (int k = std::max(0, i - kBeside); at(i + 1) != 0 && k <= std::min(i + kBeside, count - 1); ++k)
                    is_near |= std::uint64_t{1} << k;
            for (int i = 0; i < count; ++i) at(i + 1) = static_cast<std::int32_t>(is_near >> i & 1U);
        });
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int count = size_[axis];
        for_lines(axis, [count](const auto& at) {
            for (int i = 1; i <= count; ++i) at(i) += at(i - 1);
        });
    }
}

bool Region::meets(const Eigen::AlignedBox3f& box) const {
    if (is_everywhere_) return true;
    if (sums_.empty()) return false;
    const auto cell_at = [&](const Vec3f& p) {
        const Eigen::Array3f at = ((p - low_) / cell_).array().floor();
        return Cell(at.max(-1).min(static_cast<float>(kMostCells)).cast<int>());
    };
    const Vec3f more = Vec3f::Constant(grown_);
    const Cell first = cell_at(box.min() - more).max(0).min(size_);
    const Cell last = (cell_at(box.max() + more) + 1).max(0).min(size_);
    if ((last <= first).any()) return false;
    // Inclusion and exclusion.
    std::int32_t inside = 0;
    for (int i = 0; i < 8; ++i) {
        const Cell corner(i & 1 ? first.x() : last.x(), i & 2 ? first.y() : last.y(), i & 4 ? first.z() : last.z());
        inside += (std::popcount(static_cast<unsigned>(i)) % 2 == 0 ? 1 : -1) * sums_[index_of(corner)];
    }
    return inside > 0;
}

Region Region::grown(float by) const {
    Region result = *this;
    result.grown_ += by;
    return result;
}

}  // namespace selvedge::sim
