#include "sim/body/mannequin_stance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/body/section.h"

namespace selvedge {

void set_stance(Joints& joints, double stance) {
    const Vec3d hip = joints[Joint::LeftUpperLeg];
    Vec3d& knee = joints[Joint::LeftLowerLeg];
    Vec3d& ankle = joints[Joint::LeftFoot];
    const double drop = hip.y() - ankle.y();
    const double inward = (ankle.x() - hip.x()) - drop * std::tan(stance);  // of the ankle
    knee.x() -= inward * (hip.y() - knee.y()) / drop;
    ankle.x() -= inward;
    joints[Joint::LeftToe].x() -= inward;
}

LegGap measure_leg_gap(const Body& body, double crotch, const Joints& joints) {
    constexpr double kBelowCrotch = 0.04;  // m; above it the thighs grow together
    const double top = crotch - kBelowCrotch;
    double nearest = std::numeric_limits<double>::max();
    double height = 0;
    const auto look_at = [&](const Vec3d& x) {
        if (x.y() > top + 1e-9 || std::abs(x.x()) >= nearest) return;
        nearest = std::abs(x.x());
        height = x.y();
    };
    for (const Vec3d& x : body.x) look_at(x);
    for (const SectionLoop& loop : section(body, {.point = Vec3d(0, top, 0)})) {
        for (const Vec3d& x : loop.points) look_at(x);
    }
    return {.width = 2 * nearest, .drop = joints[Joint::LeftUpperLeg].y() - height};
}

std::optional<double> better_stance(double stance, double wanted, const LegGap& gap) {
    constexpr double kAim = kLeastLegGap + 0.0005;   // m
    constexpr double kAmple = kLeastLegGap + 0.001;  // m
    constexpr double kLongestStep = radians(3);
    const bool is_narrow = gap.width < kLeastLegGap && stance < kMostStance;
    const bool is_needlessly_open = gap.width > kAmple && stance > wanted;
    if (!is_narrow && !is_needlessly_open) return std::nullopt;
    const double step = (kAim - gap.width) / (2 * gap.drop);  // both legs turn
    return std::clamp(stance + std::clamp(step, -kLongestStep, kLongestStep), wanted, kMostStance);
}

}  // namespace selvedge
