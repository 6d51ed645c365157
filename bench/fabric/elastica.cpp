#include "bench/fabric/elastica.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {
namespace {

constexpr int kSteps = 500;

// How the section's width grows along the strip: 1 + growth s, s from 0 at the clamp to 1.
struct Sector {
    double q;
    double growth;

    double width(double s) const { return 1 + growth * s; }
    double beyond(double s) const { return (1 - s) * (1 + growth * (1 + s) / 2); }  // area beyond s
};

// Angle to the plumb line, bending moment, reach and drop at s. The moment carries what hangs beyond s:
// angle' = -moment / width, moment' = -q beyond(s) sin(angle).
using State = Eigen::Vector4d;

State slope(const Sector& strip, double s, const State& y) {
    return {-y[1] / strip.width(s), -strip.q * strip.beyond(s) * std::sin(y[0]), std::sin(y[0]), std::cos(y[0])};
}

// From the free end, where the moment is nil and the angle is `tip`, back to the clamp (Runge-Kutta). Stops where the
// strip would be level before it gets there.
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

// The tip's angle for which the clamp is level. Soft strips end within next to nothing of the plumb line: so it is
// sought by its logarithm.
Droop solve(const Sector& strip) {
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

Droop droop(double q) {
    return solve({q, 0});
}

double chord_angle(const Droop& droop) {
    return std::atan2(droop.drop, droop.reach);
}

double q_of_chord_angle(double angle) {
    double low = std::log(1e-4);
    double high = std::log(1e5);
    for (int i = 0; i < 28; ++i) {
        const double middle = (low + high) / 2;
        (chord_angle(droop(std::exp(middle))) > angle ? high : low) = middle;
    }
    return std::exp((low + high) / 2);
}

Droop sector_droop(double q, double inner) {
    return solve({q, 1 / inner});
}

double drape_floor(double bending_length, double support_radius, double radius) {
    const double length = radius - support_radius;
    const double q = std::pow(length / bending_length, 3);
    const double shadow = support_radius + length * sector_droop(q, support_radius / length).reach;
    const auto squared = [](double r) { return r * r; };
    return 100 * (squared(shadow) - squared(support_radius)) / (squared(radius) - squared(support_radius));
}

}  // namespace selvedge
