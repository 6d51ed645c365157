#include "sim/dress/outline_match.h"

#include <algorithm>

#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kSamePoint = 1e-9;  // of a stretch's length, closer corners are one

// The edges of a run, with the fractions of its length at which each begins and ends.
void measure(const Panel& panel, int first, int count, int stretch, std::vector<StretchPiece>& pieces) {
    double whole = 0, reached = 0;
    const auto edge_at = [&](int i) { return as_size((first + i) % static_cast<int>(panel.edges.size())); };
    for (int i = 0; i < count; ++i) whole += outline_length(panel, panel.edges[edge_at(i)]);
    for (int i = 0; i < count; ++i) {
        const double from = count == 1 ? 0 : reached / whole;
        reached += outline_length(panel, panel.edges[edge_at(i)]);
        pieces[edge_at(i)] = {stretch, from, i + 1 == count ? 1 : reached / whole};
    }
}

// The point at the fraction of the stretch's length.
Vec2d point_at(const Panel& panel, const std::vector<StretchPiece>& pieces, int first, int count, double t) {
    for (int i = 0; i < count; ++i) {
        const std::size_t edge = as_size((first + i) % static_cast<int>(panel.edges.size()));
        const StretchPiece& piece = pieces[edge];
        if (t > piece.to && i + 1 < count) continue;
        const double share = count == 1 ? t : (t - piece.from) / (piece.to - piece.from);
        return outline_point(panel, panel.edges[edge], std::clamp(share, 0.0, 1.0));
    }
    return Vec2d::Zero();
}

}  // namespace

OutlineMatch::OutlineMatch(const Panel& before, const Panel& after)
    : before_(before.edges.size()), after_(after.edges.size()) {
    const bool have_keys = has_keys(before) && has_keys(after);
    if (!have_keys && before.edges.size() != after.edges.size()) return;
    stretches_ = shared_stretches(before, after);
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
        const OutlineStretch& stretch = stretches_[i];
        measure(before, stretch.first, stretch.count, static_cast<int>(i), before_);
        measure(after, stretch.other_first, stretch.other_count, static_cast<int>(i), after_);
    }
}

std::vector<std::pair<Vec2d, Vec2d>> OutlineMatch::points(const Panel& before, const Panel& after, int count) const {
    std::vector<std::pair<Vec2d, Vec2d>> points;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
        const OutlineStretch& stretch = stretches_[i];
        std::vector<double> corners{1};
        for (const std::vector<StretchPiece>* pieces : {&before_, &after_}) {
            for (const StretchPiece& piece : *pieces) {
                if (piece.stretch == static_cast<int>(i)) corners.push_back(piece.from);
            }
        }
        std::ranges::sort(corners);
        const auto is_same = [](double one, double other) { return other - one < kSamePoint; };
        corners.erase(std::unique(corners.begin(), corners.end(), is_same), corners.end());
        for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
            for (int j = 0; j < count; ++j) {
                const double t = corners[k] + (corners[k + 1] - corners[k]) * (double(j) / count);
                points.emplace_back(point_at(before, before_, stretch.first, stretch.count, t),
                                    point_at(after, after_, stretch.other_first, stretch.other_count, t));
            }
        }
    }
    return points;
}

}  // namespace selvedge::sim
