#include "sim/exchange/uv_atlas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

// A box with its margins, in texels.
struct Extent {
    int width = 0;
    int height = 0;
};

struct Spot {
    int x = 0;
    int y = 0;
    bool is_turned = false;
};

// The upper border of what is placed, from left to right. The first step begins at 0; each ends where the next begins.
class Skyline {
 public:
    explicit Skyline(int side) : side_(side), steps_{{0, 0}} {}

    // The spot where the extent's top is lowest, then the one furthest to the left; none if it fits nowhere.
    std::optional<Spot> find(const Extent& extent) const {
        std::optional<Spot> best;
        int lowest_top = 0;
        for (const bool is_turned : {false, true}) {
            const Extent turned = is_turned ? Extent{extent.height, extent.width} : extent;
            for (std::size_t i = 0; i < steps_.size() && steps_[i].x + turned.width <= side_; ++i) {
                const int y = height_under(i, turned.width), top = y + turned.height;
                if (top > side_ || (best && std::tie(top, steps_[i].x) >= std::tie(lowest_top, best->x))) continue;
                best = Spot{steps_[i].x, y, is_turned};
                lowest_top = top;
            }
        }
        return best;
    }

    void add(const Spot& spot, const Extent& extent) {
        const int width = spot.is_turned ? extent.height : extent.width, right = spot.x + width;
        const int top = spot.y + (spot.is_turned ? extent.width : extent.height);
        std::vector<Step> steps;
        int height_at_right = 0;
        for (const Step& step : steps_) {
            if (step.x <= right) height_at_right = step.y;
            if (step.x < spot.x || step.x > right) steps.push_back(step);
        }
        steps.push_back({spot.x, top});
        if (right < side_) steps.push_back({right, height_at_right});
        std::ranges::sort(steps, {}, &Step::x);
        steps_ = std::move(steps);
    }

 private:
    struct Step {
        int x = 0;
        int y = 0;
    };

    int height_under(std::size_t first, int width) const {
        int height = 0;
        for (std::size_t i = first; i < steps_.size() && steps_[i].x < steps_[first].x + width; ++i)
            height = std::max(height, steps_[i].y);
        return height;
    }

    int side_;
    std::vector<Step> steps_;
};

// texels_per_metre: the scale.
std::vector<Extent> extents_at(double texels_per_metre, std::span<const MaterialBox> boxes, int margin_px) {
    const auto whole = [&](double length) {
        return std::max(static_cast<int>(std::ceil(length * texels_per_metre)), 1) + 2 * margin_px;
    };
    std::vector<Extent> extents;
    extents.reserve(boxes.size());
    for (const MaterialBox& box : boxes) extents.push_back({whole(box.sizes().x()), whole(box.sizes().y())});
    return extents;
}

std::optional<std::vector<Spot>> pack(const std::vector<Extent>& extents, int side) {
    std::vector<std::size_t> order(extents.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        const auto key = [&](const Extent& e) {
            return std::pair(std::max(e.width, e.height), std::min(e.width, e.height));
        };
        return key(extents[a]) > key(extents[b]);
    });
    Skyline skyline(side);
    std::vector<Spot> spots(extents.size());
    for (const std::size_t i : order) {
        const std::optional<Spot> spot = skyline.find(extents[i]);
        if (!spot) return {};
        spots[i] = *spot;
        skyline.add(*spot, extents[i]);
    }
    return spots;
}

struct Packing {
    double texels_per_metre = 0;
    std::vector<Spot> spots;
};

// Bisects the scale's logarithm. Whether boxes fit is not monotonic in the scale, so the largest scale that was tried
// and fits is taken.
Packing find_largest(std::span<const MaterialBox> boxes, const AtlasOptions& options) {
    constexpr double kLeastSide = 1e-6;  // m; of boxes without a side
    constexpr int kBisections = 30;      // from six decades to 1e-8 of the scale
    double longest = kLeastSide;
    for (const MaterialBox& box : boxes) longest = std::max(longest, box.sizes().maxCoeff());
    const auto attempt = [&](double scale) {
        return pack(extents_at(scale, boxes, options.margin_px), options.size_px);
    };
    double high = std::max(options.size_px - 2 * options.margin_px, 1) / longest, low = high / options.size_px;
    if (auto spots = attempt(high)) return {high, std::move(*spots)};
    Packing best;
    if (auto spots = attempt(low)) best = {low, std::move(*spots)};
    if (best.spots.empty()) {
        throw InputError("", "texture size",
                         std::to_string(options.size_px) + " px have no room for " + std::to_string(boxes.size()) +
                             " panels with margins of " + std::to_string(options.margin_px) + " px");
    }
    for (int i = 0; i < kBisections; ++i) {
        const double middle = std::sqrt(low * high);
        auto spots = attempt(middle);
        (spots ? low : high) = middle;
        if (spots) best = {middle, std::move(*spots)};
    }
    return best;
}

// A quarter turn anticlockwise.
Vec2d turned_left(const Vec2d& v) {
    return {-v.y(), v.x()};
}

}  // namespace

Vec2d UvChart::uv(const Vec2d& material) const {
    return offset + scale * (is_turned ? turned_left(material) : material);
}

Vec2d UvChart::material(const Vec2d& uv) const {
    const Vec2d from_origin = (uv - offset) / scale;
    return is_turned ? Vec2d(from_origin.y(), -from_origin.x()) : from_origin;
}

bool is_sound(const UvChart& chart) {
    constexpr double kLargest = 1e6;
    return chart.scale >= 1 / kLargest && chart.scale <= kLargest && chart.offset.cwiseAbs().maxCoeff() <= kLargest;
}

std::vector<UvChart> pack_charts(std::span<const MaterialBox> boxes, const AtlasOptions& options) {
    SELVEDGE_ASSERT(options.size_px > 0 && options.margin_px >= 0);
    if (boxes.empty()) return {};
    const Packing packing = find_largest(boxes, options);
    std::vector<UvChart> charts;
    charts.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Spot& spot = packing.spots[i];
        UvChart chart{.scale = packing.texels_per_metre / options.size_px, .is_turned = spot.is_turned};
        // The material coordinates whose texture coordinates are lowest.
        const Vec2d low = spot.is_turned ? Vec2d(boxes[i].min().x(), boxes[i].max().y()) : boxes[i].min();
        chart.offset = Vec2d(spot.x + options.margin_px, spot.y + options.margin_px) / options.size_px - chart.uv(low);
        charts.push_back(chart);
    }
    return charts;
}

}  // namespace selvedge::sim
