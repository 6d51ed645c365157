#include "sim/body/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "sim/core/assert.h"

namespace selvedge {

namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept {
        std::uint64_t hash = 0;
        for (const std::int64_t part : cell) hash = (hash ^ std::uint64_t(part)) * 0x9E3779B97F4A7C15U + (hash >> 29U);
        return std::size_t(hash);
    }
};

// Those that stand for themselves, by cell; the cells are much larger than the distance, so that most searches look
// into one. Nothing depends on the map's order.
class Representatives {
 public:
    Representatives(const std::vector<Vec3d>& x, double distance) : x_(x), distance_(distance), next_(x.size(), kNone) {
        cells_.reserve(x.size());
    }

    int find_or_add(int point) {
        const Vec3d& p = x_[std::size_t(point)];
        const Cell low = cell_of(p - Vec3d::Constant(distance_));
        const Cell high = cell_of(p + Vec3d::Constant(distance_));
        int best = kNone;
        Cell cell{};
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) best = earlier(best, search(cell, p));
        if (best != kNone) return best;
        const auto [head, is_new] = cells_.try_emplace(cell_of(p), kNone);
        next_[std::size_t(point)] = head->second;
        head->second = point;
        return point;
    }

 private:
    static constexpr int kNone = -1;

    static int earlier(int a, int b) { return a == kNone ? b : (b == kNone ? a : std::min(a, b)); }

    Cell cell_of(const Vec3d& p) const {
        const Vec3d scaled = p / (8 * distance_);
        return {std::int64_t(std::floor(scaled.x())), std::int64_t(std::floor(scaled.y())),
                std::int64_t(std::floor(scaled.z()))};
    }

    int search(const Cell& cell, const Vec3d& p) const {
        const auto head = cells_.find(cell);
        int best = kNone;
        for (int i = head == cells_.end() ? kNone : head->second; i != kNone; i = next_[std::size_t(i)])
            if ((x_[std::size_t(i)] - p).norm() <= distance_) best = earlier(best, i);
        return best;
    }

    const std::vector<Vec3d>& x_;
    double distance_;
    std::vector<int> next_;  // in the same cell
    std::unordered_map<Cell, int, CellHash> cells_;
};

}  // namespace

std::vector<int> weld(const std::vector<Vec3d>& x, double distance) {
    SELVEDGE_ASSERT(distance > 0);
    Representatives representatives(x, distance);
    std::vector<int> same(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) same[i] = representatives.find_or_add(int(i));
    return same;
}

}  // namespace selvedge
