#include "sim/place/leg_lean.h"

#include <algorithm>
#include <cmath>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

// The middle between the outermost corners of the lower end of a panel.
Vec2d middle_of_hem(const Panel& panel) {
    constexpr double kLowEnd = 0.1;  // of the panel's height
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    Eigen::AlignedBox2d low;
    for (const Vec2d& v : panel.vertices) {
        if (v.y() <= box.min().y() + kLowEnd * box.sizes().y()) low.extend(v);
    }
    return low.isEmpty() ? Vec2d(box.center().x(), box.min().y()) : low.center();
}

// Of the line through the joints of a limb, at a height.
double x_of_limb(const Limb& limb, double y) {
    for (std::size_t i = 0; i + 1 < limb.joints.size(); ++i) {
        const Vec3d &from = limb.joints[i].centre, &to = limb.joints[i + 1].centre;
        if (from.y() >= y && y >= to.y() && from.y() > to.y())
            return std::lerp(from.x(), to.x(), (from.y() - y) / (from.y() - to.y()));
    }
    const LimbJoint& end = y > limb.joints.front().centre.y() ? limb.joints.front() : limb.joints.back();
    return end.centre.x();
}

}  // namespace

std::optional<Vec2d> crotch_of(const Panel& leg, double side) {
    const auto outmost = std::ranges::max_element(leg.vertices, {}, [&](const Vec2d& v) { return side * v.x(); });
    return side == 0 || outmost == leg.vertices.end() ? std::nullopt : std::optional(*outmost);
}

void lean_to_leg(Panel& panel, const Vec2d& crotch, const Limb& leg) {
    constexpr double kMost = 0.3;  // rad: what hangs farther out is no leg
    const Vec3d pivot = panel.place(crotch), hem = panel.place(middle_of_hem(panel));
    const double drop = pivot.y() - hem.y();
    if (drop <= 0) return;
    const double wanted = std::atan2(x_of_limb(leg, hem.y()) - pivot.x(), drop);
    const double now = std::atan2(hem.x() - pivot.x(), drop);
    const Eigen::AngleAxisd turn(std::clamp(wanted - now, -kMost, kMost), Vec3d::UnitZ());
    panel.rotation = turn.toRotationMatrix() * panel.rotation;
    panel.translation = pivot + turn * (panel.translation - pivot);
}

}  // namespace selvedge::sim
