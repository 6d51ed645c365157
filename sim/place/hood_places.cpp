#include "sim/place/hood_places.h"

#include <numbers>

#include "sim/pattern/edge_shape.h"
#include "sim/place/placement.h"

namespace selvedge::sim {

void stand_beside_head(Panel& side, double way, const Limb& head) {
    constexpr double kBeside = 0.14;  // m, from the middle of the head
    const Eigen::AlignedBox2d box = outline_box(side, 1e-3);
    side.wrap_radius = 0;
    side.wrap_cone.reset();
    side.rotation = Eigen::AngleAxisd(way * std::numbers::pi / 2, Vec3d::UnitY()).toRotationMatrix();
    side.translation.setZero();
    const Vec2d low(box.center().x(), box.min().y());
    const Vec3d neck = head.joints[0].centre;
    side.translation = Vec3d(neck.x() + way * kBeside, neck.y(), neck.z()) - side.place(low);
}

void bend_over_head(Panel& strip, double way, const Limb& head) {
    constexpr double kArc = 3.6;  // rad, from the nape over the head
    ArrangementPoint point;
    point.upward = Vec3d(-way, 0, 0);
    point.outward = Vec3d(0, 0.6, -0.8);  // unit
    point.radius = outline_box(strip, 1e-3).sizes().x() / kArc;
    const Vec3d middle = (head.joints[0].centre + head.joints[1].centre) / 2;
    point.position = middle + point.radius * point.outward;
    arrange(strip, point);
}

}  // namespace selvedge::sim
