#include "sim/body/vertical_line.h"

#include <algorithm>

namespace selvedge::sim {

std::optional<VerticalMeeting> meet_vertical(const std::array<Vec3d, 3>& corners, double x, double z) {
    const auto& [a, b, c] = corners;
    const auto side = [&](const Vec3d& from, const Vec3d& to) {
        return (to.z() - from.z()) * (x - from.x()) - (to.x() - from.x()) * (z - from.z());
    };
    const double to_a = side(b, c), to_b = side(c, a), to_c = side(a, b), area = to_a + to_b + to_c;
    const bool is_inside = area > 0 ? std::min({to_a, to_b, to_c}) >= 0 : std::max({to_a, to_b, to_c}) <= 0;
    if (area == 0 || !is_inside) return std::nullopt;
    return VerticalMeeting{.y = (to_a * a.y() + to_b * b.y() + to_c * c.y()) / area, .faces_up = area > 0};
}

}  // namespace selvedge::sim
