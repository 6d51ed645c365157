#include "sim/inspection/carried.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace selvedge::sim {

bool is_carried(std::span<const Vec3d> points, const Body& body, double above) {
    constexpr double kUp = 0.5;  // cosine, 60 degrees from upright
    // m, of the cloth over the surface: what is worn under it lies between them. Cloth of level 0 dips between
    // vertices.
    constexpr double kMostOver = 0.05, kMostUnder = 0.015;
    for (const std::array<int, 3>& triangle : body.triangles) {
        const auto corner = [&](std::size_t i) -> const Vec3d& {
            return body.x[static_cast<std::size_t>(triangle[i])];
        };
        const Vec3d &a = corner(0), &b = corner(1), &c = corner(2), normal = (b - a).cross(c - a);
        if (std::max({a.y(), b.y(), c.y()}) < above || !(normal.y() > kUp * normal.norm())) continue;
        const auto lies_on = [&](const Vec3d& p) {
            const double over = (p - a).dot(normal) / normal.y();  // m, along the upright
            if (over > kMostOver || over < -kMostUnder) return false;
            const Vec3d on = p - Vec3d(0, over, 0);
            const auto is_inside = [&](const Vec3d& from, const Vec3d& to) {
                return (to - from).cross(on - from).dot(normal) >= 0;
            };
            return is_inside(a, b) && is_inside(b, c) && is_inside(c, a);
        };
        if (std::ranges::any_of(points, lies_on)) return true;
    }
    return false;
}

}  // namespace selvedge::sim
