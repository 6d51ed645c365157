#include "sim/body/parted_legs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "sim/core/disjoint_sets.h"
#include "sim/core/math.h"

namespace selvedge::sim {
namespace {

constexpr double kAtFloor = 0.1;       // of the height: a leg begins below
constexpr double kLowestCrotch = 0.3;  // of the height: toes and heels join far below
constexpr double kOpening = 0.04;      // m, below the crotch, over which the room opens
constexpr double kSlab = 0.005;        // m, height of the slabs in which thighs are compared
constexpr double kBand = 3;            // depth of the flesh that moves, relative to how far the thigh's side does

// The surface as it grows from the floor upwards.
struct LegsAtCrotch {
    double crotch = 0;      // m
    std::vector<int> side;  // per vertex below it: 1 of the left leg, -1 of the right one, else 0
};

class RisingSurface {
 public:
    explicit RisingSurface(const Body& body) : body_(body), groups_(body.x.size()), order_(body.x.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        std::ranges::stable_sort(order_, {}, [&](int v) { return height(v); });
        rank_.resize(order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) rank_[as_size(order_[i])] = i;
        neighbours_.resize(body.x.size());
        for (const auto& t : body.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                neighbours_[as_size(t[k])].push_back(t[(k + 1) % 3]);
                neighbours_[as_size(t[(k + 1) % 3])].push_back(t[k]);
            }
        }
        lowest_.resize(body.x.size());
        for (std::size_t v = 0; v < lowest_.size(); ++v) lowest_[v] = body.x[v].y();
    }

    std::optional<LegsAtCrotch> rise() {
        const HeightRange range = height_range(body_);
        const double tall = range.high - range.low, floor = range.low + kAtFloor * tall;
        for (const int v : order_) {
            for (const int w : neighbours_[as_size(v)]) {
                if (rank_[as_size(w)] > rank_[as_size(v)]) continue;
                const int a = groups_.find(v), b = groups_.find(w);
                if (a == b) continue;
                const bool are_legs = lowest_[as_size(a)] < floor && lowest_[as_size(b)] < floor;
                if (are_legs && height(v) > range.low + kLowestCrotch * tall) return legs_of(v, a, b);
                const double lowest = std::min(lowest_[as_size(a)], lowest_[as_size(b)]);
                groups_.join(a, b);
                lowest_[as_size(groups_.find(a))] = lowest;
            }
        }
        return std::nullopt;
    }

 private:
    double height(int v) const { return body_.x[as_size(v)].y(); }

    LegsAtCrotch legs_of(int crotch, int a, int b) {
        LegsAtCrotch legs{.crotch = height(crotch), .side = std::vector<int>(body_.x.size(), 0)};
        double across = 0;  // sum of x of a less that of b
        std::array<double, 2> sums{}, counts{};
        for (std::size_t i = 0; i < rank_[as_size(crotch)]; ++i) {
            const int v = order_[i], group = groups_.find(v);
            if (group != a && group != b) continue;
            const std::size_t which = group == a ? 0 : 1;
            legs.side[as_size(v)] = which == 0 ? 1 : -1;
            sums[which] += body_.x[as_size(v)].x();
            ++counts[which];
        }
        across = sums[0] / std::max(1.0, counts[0]) - sums[1] / std::max(1.0, counts[1]);
        if (across < 0) {
            for (int& side : legs.side) side = -side;
        }
        return legs;
    }

    const Body& body_;
    DisjointSets groups_;
    std::vector<int> order_;                    // vertices from below
    std::vector<std::size_t> rank_;             // of each vertex in it
    std::vector<std::vector<int>> neighbours_;  // with repetitions
    std::vector<double> lowest_;                // of each group, m
};

// Where the sides of both thighs are nearest to each other, by slabs downwards from the crotch.
struct ThighGap {
    double left = std::numeric_limits<double>::infinity();    // m, least x of the left leg
    double right = -std::numeric_limits<double>::infinity();  // m, largest of the right one

    double middle() const { return (left + right) / 2; }
    bool is_known() const { return left < std::numeric_limits<double>::infinity() && std::isfinite(right); }
};

std::vector<ThighGap> thigh_gaps(const Body& body, const LegsAtCrotch& legs) {
    const double low = height_range(body).low;
    std::vector<ThighGap> gaps(as_size(static_cast<int>((legs.crotch - low) / kSlab)) + 2);
    const auto add = [&](std::size_t slab, int side, double x) {
        if (slab >= gaps.size()) return;
        if (side > 0) gaps[slab].left = std::min(gaps[slab].left, x);
        if (side < 0) gaps[slab].right = std::max(gaps[slab].right, x);
    };
    // Each edge counts in all slabs that it crosses: a coarse surface has slabs without a vertex.
    for (const auto& t : body.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3], side = legs.side[as_size(a)];
            if (side == 0 || legs.side[as_size(b)] != side) continue;
            const Vec3d &from = body.x[as_size(a)], &to = body.x[as_size(b)];
            const double first = (legs.crotch - from.y()) / kSlab, last = (legs.crotch - to.y()) / kSlab;
            const auto [top, bottom] = std::minmax({first, last});
            for (double slab = std::floor(std::max(0.0, top)); slab <= bottom; ++slab) {
                const double share = last == first ? 0 : std::clamp((slab + 0.5 - first) / (last - first), 0.0, 1.0);
                add(static_cast<std::size_t>(slab), side, from.x() + share * (to.x() - from.x()));
            }
        }
    }
    return gaps;
}

// What a thigh lacks of its half of the room, and where the middle is, at a depth below the crotch, m.
struct Lack {
    double middle = 0;
    double room = 0;  // half
    double left = 0, right = 0;
};

Lack lack_at(const std::vector<ThighGap>& gaps, double depth) {
    const double at = std::max(0.0, depth / kSlab - 0.5);
    const auto below = std::min(static_cast<std::size_t>(at), gaps.size() - 1),
               above = std::min(below + 1, gaps.size() - 1);
    if (!gaps[below].is_known() || !gaps[above].is_known()) return {};
    const double share = at - std::floor(at);
    const auto mean = [&](double a, double b) { return (1 - share) * a + share * b; };
    Lack lack{.middle = mean(gaps[below].middle(), gaps[above].middle()),
              .room = kRoomForCloth / 2 * std::min(1.0, depth / kOpening)};
    lack.left = std::max(0.0, lack.middle + lack.room - mean(gaps[below].left, gaps[above].left));
    lack.right = std::max(0.0, mean(gaps[below].right, gaps[above].right) - lack.middle + lack.room);
    return lack;
}

}  // namespace

std::optional<double> crotch_of(const Body& body) {
    const auto legs = RisingSurface(body).rise();
    if (!legs) return std::nullopt;
    return legs->crotch;
}

double part_legs(Body& body) {
    const auto legs = RisingSurface(body).rise();
    if (!legs) return 0;
    const std::vector<ThighGap> gaps = thigh_gaps(body, *legs);
    double most = 0;
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        const int side = legs->side[v];
        if (side == 0) continue;
        Vec3d& x = body.x[v];
        const Lack lack = lack_at(gaps, legs->crotch - x.y());
        const double missing = side > 0 ? lack.left : lack.right;
        if (missing <= 0) continue;
        // From where the side is to kBand times as deep as it lacks: pressed together, in order.
        const double depth = side * (x.x() - lack.middle) - lack.room + missing, band = (kBand + 1) * missing;
        if (depth >= band) continue;
        const double back = missing * (1 - std::max(0.0, depth) / band);
        x.x() += side * back;
        most = std::max(most, back);
    }
    return most;
}

}  // namespace selvedge::sim
