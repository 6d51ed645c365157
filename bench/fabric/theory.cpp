#include "bench/fabric/theory.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::bench {
namespace {

constexpr int kSteps = 500;

// A strip whose width grows along its length: 1 + growth s, with s from 0 at the clamp to 1 at the free end.
struct Sector {
    double q;
    double growth;

    double width(double s) const { return 1 + growth * s; }
    double beyond(double s) const { return (1 - s) * (1 + growth * (1 + s) / 2); }  // area beyond s
};

// Angle from the vertical, bending moment, reach and drop at s. The moment balances the weight beyond s:
// angle' = -moment / width, moment' = -q beyond(s) sin(angle).
using State = Eigen::Vector4d;

State slope(const Sector& strip, double s, const State& y) {
    return {-y[1] / strip.width(s), -strip.q * strip.beyond(s) * std::sin(y[0]), std::sin(y[0]), std::cos(y[0])};
}

// Integrates from the free end, where the moment is zero and the angle is `tip`, to the clamp (4th-order Runge-Kutta).
// Stops early where the strip becomes horizontal.
State from_tip(const Sector& strip, double tip) {
    State y(tip, 0, 0, 0);
    const double h = -1.0 / kSteps;
    for (int i = 0; i < kSteps && y[0] <= std::numbers::pi / 2; ++i) {
        const double s = 1 + i * h;
        const State k1 = slope(strip, s, y);
        const State k2 = slope(strip, s + h / 2, y + k1 * (h / 2));
        const State k3 = slope(strip, s + h / 2, y + k2 * (h / 2));
        const State k4 = slope(strip, s + h, y + k3 * h);
        y += (k1 + 2 * k2 + 2 * k3 + k4) * (h / 6);
    }
    return y;
}

// Finds the tip angle for which the strip is horizontal at the clamp. The bisection is over the logarithm of the angle,
// because the tip of a soft strip is almost vertical.
Deflection solve(const Sector& strip) {
    double low = -400;
    double high = std::log(std::numbers::pi / 2);
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (from_tip(strip, std::exp(middle))[0] > std::numbers::pi / 2 ? high : low) = middle;
    }
    const State clamp = from_tip(strip, std::exp(low));
    return {.reach = -clamp[2], .drop = -clamp[3]};
}

}  // namespace

Deflection deflection(double q) {
    return solve({q, 0});
}

double chord_angle(const Deflection& deflection) {
    return std::atan2(deflection.drop, deflection.reach);
}

double q_of_chord_angle(double angle) {
    double low = std::log(1e-4);
    double high = std::log(1e5);
    for (int i = 0; i < 28; ++i) {
        const double middle = (low + high) / 2;
        (chord_angle(deflection(std::exp(middle))) > angle ? high : low) = middle;
    }
    return std::exp((low + high) / 2);
}

Deflection sector_deflection(double q, double inner) {
    return solve({q, 1 / inner});
}

double drape_floor(double bending_length, double support_radius, double radius) {
    const double length = radius - support_radius;
    const double q = std::pow(length / bending_length, 3);
    const double shadow = support_radius + length * sector_deflection(q, support_radius / length).reach;
    const auto squared = [](double r) { return r * r; };
    return 100 * (squared(shadow) - squared(support_radius)) / (squared(radius) - squared(support_radius));
}

Shadow::Shadow(double half_width, double pixel)
    : half_width_(half_width),
      pixel_(pixel),
      size_(static_cast<int>(std::ceil(2 * half_width / pixel))),
      lit_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_), false) {}

void Shadow::draw(const std::array<Vec3d, 3>& triangle) {
    std::array<Vec2d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = Vec2d(triangle[k].x(), triangle[k].z());
    if (sim::cross2(p[1] - p[0], p[2] - p[0]) < 0) std::swap(p[1], p[2]);
    const Vec2d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    const Vec2d high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const auto first = [&](double at) { return std::max(0, static_cast<int>((at + half_width_) / pixel_)); };
    const auto last = [&](double at) { return std::min(size_ - 1, static_cast<int>((at + half_width_) / pixel_)); };
    for (int row = first(low.y()); row <= last(high.y()); ++row) {
        for (int column = first(low.x()); column <= last(high.x()); ++column) {
            const Vec2d centre(centre_of(column), centre_of(row));
            bool is_inside = true;
            for (std::size_t k = 0; k < 3; ++k)
                is_inside = is_inside && sim::cross2(p[(k + 1) % 3] - p[k], centre - p[k]) >= 0;
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

// Goes round twice and counts only the second time: after the first it is known whether the outline rises or falls.
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

}  // namespace selvedge::bench
