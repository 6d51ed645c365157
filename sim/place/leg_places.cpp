#include "sim/place/leg_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kOpenTube = 1.04;  // of a full turn, so that the edges do not meet

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

std::optional<LegTube> leg_tube(const Panel& panel, std::span<const int> crotch_edges) {
    constexpr double kMiddle = 0.2;  // of the width: a notch farther from the middle is none
    if (crotch_edges.empty()) return std::nullopt;
    Eigen::AlignedBox2d notch;
    LegTube tube{.crotch = {0, std::numeric_limits<double>::infinity()}};
    for (const int e : crotch_edges) {
        for (const double t : {0.0, 1.0}) {
            const Vec2d at = outline_point(panel, panel.edges[as_size(e)], t);
            notch.extend(at);
            if (at.y() < tube.crotch.y()) tube.crotch = at;
        }
    }
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    if (std::abs(notch.center().x() - box.center().x()) > kMiddle * box.sizes().x()) return std::nullopt;
    // Seen from between the legs, the front of the left leg is on the right.
    tube.is_of_left = notch.max().x() - tube.crotch.x() < tube.crotch.x() - notch.min().x();
    return tube;
}

std::optional<ArrangementPoint> place_of_tube(const Panel& panel, const LegTube& tube, const Limb& leg, double crotch) {
    constexpr double kWider = 1.15;   // than the thigh
    constexpr double kApart = 0.005;  // m, from the middle of the body
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    ArrangementPoint point;
    point.radius = kOpenTube * box.sizes().x() / (2 * std::numbers::pi);
    if (point.radius < kWider * leg.joints[0].radius) return std::nullopt;
    const double way = tube.is_of_left ? 1 : -1;
    const Vec3d hip = leg.joints[0].centre;
    point.outward = -way * Vec3d::UnitX();
    point.position = Vec3d(way * std::max(kApart, std::abs(hip.x()) - point.radius),
                           crotch + box.center().y() - tube.crotch.y(), hip.z());
    return point;
}

ArrangementPoint place_of_leg_cuff(const Panel& cuff, const Vec3d& hem, const Limb& leg) {
    constexpr double kBelow = 0.01;  // m, from the hem
    const Vec2d size = outline_box(cuff, 1e-3).sizes();
    const Vec3d ankle = leg.joints[2].centre;
    const double low = std::max(ankle.y(), hem.y() - kBelow - size.y());
    ArrangementPoint point;
    point.radius = kOpenTube * size.x() / (2 * std::numbers::pi);
    point.position = Vec3d(ankle.x(), low + size.y() / 2, ankle.z()) + point.radius * point.outward;
    return point;
}

}  // namespace selvedge::sim
