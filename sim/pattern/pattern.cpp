#include "sim/pattern/pattern.h"

#include <cmath>

namespace selvedge {

Vec3d Panel::place(const Vec2d& u) const {
    const double side = is_mirrored ? -1 : 1;  // the right side looks along side * z
    Vec3d local(side * u.x(), u.y(), 0);
    if (wrap_radius > 0) {
        const double angle = u.x() / wrap_radius;
        local.x() = side * wrap_radius * std::sin(angle);
        local.z() = side * wrap_radius * (std::cos(angle) - 1);
    }
    return rotation * local + translation;
}

}  // namespace selvedge
