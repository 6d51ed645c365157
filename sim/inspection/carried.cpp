#include "sim/inspection/carried.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "sim/body/vertical_line.h"

namespace selvedge::sim {

bool is_carried(std::span<const Vec3d> points, const Body& body, double above) {
    constexpr double kUp = 0.5;  // cosine, 60 degrees from upright
    // m, of the cloth over the surface: what is worn under it lies between them. Cloth of level 0 dips between
    // vertices.
    constexpr double kMostOver = 0.05, kMostUnder = 0.015;
    for (const std::array<int, 3>& triangle : body.triangles) {
        std::array<Vec3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners[i] = body.x[static_cast<std::size_t>(triangle[i])];
        const Vec3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const double top = std::max({corners[0].y(), corners[1].y(), corners[2].y()});
        if (top < above || !(normal.y() > kUp * normal.norm())) continue;
        const auto lies_on = [&](const Vec3d& p) {
            const auto met = meet_vertical(corners, p.x(), p.z());
            return met && p.y() - met->y <= kMostOver && met->y - p.y() <= kMostUnder;
        };
        if (std::ranges::any_of(points, lies_on)) return true;
    }
    return false;
}

}  // namespace selvedge::sim
