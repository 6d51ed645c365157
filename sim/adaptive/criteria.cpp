#include "sim/adaptive/criteria.h"

#include <algorithm>
#include <limits>

namespace selvedge::sim {
namespace {

float longest_side(const std::array<Vec2f, 3>& u) {
    return std::max({(u[1] - u[0]).norm(), (u[2] - u[1]).norm(), (u[0] - u[2]).norm()});
}

bool is_left_of(const Vec2f& p, const Vec2f& a, const Vec2f& b) {
    const Vec2f along = b - a, arm = p - a;
    return along.x() * arm.y() - along.y() * arm.x() >= 0;
}

float distance_to_segment(const Vec2f& p, const Vec2f& a, const Vec2f& b) {
    const Vec2f along = b - a;
    const float length2 = along.squaredNorm();
    const float t = length2 > 0 ? std::clamp(along.dot(p - a) / length2, 0.0F, 1.0F) : 0.0F;
    return (p - a - t * along).norm();
}

}  // namespace

float distance_to_triangle(const Vec2f& p, const std::array<Vec2f, 3>& triangle) {
    bool is_inside = true;
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2f &a = triangle[k], &b = triangle[(k + 1) % 3];
        is_inside = is_inside && is_left_of(p, a, b);
        nearest = std::min(nearest, distance_to_segment(p, a, b));
    }
    return is_inside ? 0.0F : nearest;
}

bool MinimumLevelCriterion::is_above(const AdaptiveMesh& mesh, EdgeId e) const {
    for (const TriangleId side : mesh.edge(e).sides) {
        if (!side) continue;
        const AdaptiveTriangle& t = mesh.triangle(side);
        const auto requests_split = [&](const MinimumLevelDisc& disc) {
            return disc.level > t.level && disc.panel == t.panel &&
                   distance_to_triangle(disc.centre, t.u) <= disc.radius + longest_side(t.u);
        };
        if (std::any_of(discs.begin(), discs.end(), requests_split)) return true;
    }
    return false;
}

}  // namespace selvedge::sim
