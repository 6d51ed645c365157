#include "bench/fabric/shadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace selvedge {

Shadow::Shadow(double half_width, double pixel)
    : half_width_(half_width),
      pixel_(pixel),
      size_(static_cast<int>(std::ceil(2 * half_width / pixel))),
      lit_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_), false) {}

void Shadow::draw(const std::array<Vec3d, 3>& triangle) {
    std::array<Vec2d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = Vec2d(triangle[k].x(), triangle[k].z());
    if (cross2(p[1] - p[0], p[2] - p[0]) < 0) std::swap(p[1], p[2]);
    const Vec2d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    const Vec2d high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const auto first = [&](double at) { return std::max(0, static_cast<int>((at + half_width_) / pixel_)); };
    const auto last = [&](double at) { return std::min(size_ - 1, static_cast<int>((at + half_width_) / pixel_)); };
    for (int row = first(low.y()); row <= last(high.y()); ++row) {
        for (int column = first(low.x()); column <= last(high.x()); ++column) {
            const Vec2d centre(centre_of(column), centre_of(row));
            bool is_inside = true;
            for (std::size_t k = 0; k < 3; ++k)
                is_inside = is_inside && cross2(p[(k + 1) % 3] - p[k], centre - p[k]) >= 0;
            if (is_inside) lit_[static_cast<std::size_t>(row * size_ + column)] = true;
        }
    }
}

double Shadow::area() const {
    return static_cast<double>(std::ranges::count(lit_, true)) * pixel_ * pixel_;
}

std::vector<double> Shadow::outline(int sectors) const {
    std::vector<double> farthest(static_cast<std::size_t>(sectors), 0.0);
    for (int row = 0; row < size_; ++row) {
        for (int column = 0; column < size_; ++column) {
            if (!is_lit(column, row)) continue;
            const Vec2d p(centre_of(column), centre_of(row));
            const double turn = std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) + 0.5;
            double& r = farthest[static_cast<std::size_t>(std::min(sectors - 1, static_cast<int>(turn * sectors)))];
            r = std::max(r, p.norm());
        }
    }
    return farthest;
}

double drape_coefficient(double shadow_area, double support_area, double specimen_area) {
    return 100 * (shadow_area - support_area) / (specimen_area - support_area);
}

// Twice round, and only the second time counts: by then it is known whether the outline rises or falls.
int count_folds(const std::vector<double>& outline, double prominence) {
    int folds = 0;
    bool is_rising = true;
    double extreme = outline.empty() ? 0 : outline[0];
    for (std::size_t i = 0; i < 2 * outline.size(); ++i) {
        const double r = outline[i % outline.size()];
        if (is_rising ? r > extreme : r < extreme) {
            extreme = r;
        } else if (std::abs(r - extreme) > prominence) {
            if (is_rising && i >= outline.size()) ++folds;
            is_rising = !is_rising;
            extreme = r;
        }
    }
    return folds;
}

}  // namespace selvedge
