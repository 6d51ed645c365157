#include "sim/inspection/carried.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace selvedge::sim {

bool is_carried(std::span<const Vec3d> points, const Body& body, double above) {
    constexpr double kUp = 0.5;                      // cosine, 60 degrees from upright
    constexpr double kBeside = 0.02, kOver = 0.015;  // m, from the middle of a triangle
    const auto at = [&](int v) -> const Vec3d& { return body.x[static_cast<std::size_t>(v)]; };
    for (const auto& [a, b, c] : body.triangles) {
        const Vec3d normal = (at(b) - at(a)).cross(at(c) - at(a)), middle = (at(a) + at(b) + at(c)) / 3;
        if (middle.y() < above || normal.y() < kUp * normal.norm()) continue;
        const auto lies_on = [&](const Vec3d& p) {
            const Vec3d from = p - middle;
            return std::abs(from.y()) < kOver && std::hypot(from.x(), from.z()) < kBeside;
        };
        if (std::ranges::any_of(points, lies_on)) return true;
    }
    return false;
}

}  // namespace selvedge::sim
