#include "sim/cloth/wind.h"

#include <cmath>
#include <vector>

#include "sim/cloth/cloth.h"

namespace selvedge::sim {
namespace {

// The gain of velocity, m/s, of cloth with that fabric in air that moves with velocity `relative` to it, m/s.
Vec4f gain(const Vec4f& relative, const Vec4f& normal, const Wind& wind, const Fabric& fabric, float seconds) {
    const auto area_density = static_cast<float>(fabric.area_density);
    const float across = relative.dot(normal);
    const float slowing = 0.5F * wind.density * wind.coefficient / area_density * std::abs(across) * seconds;
    const Vec4f pushed = normal * (across * slowing / (1 + slowing));
    const float dragged = 1 - std::exp(-static_cast<float>(fabric.air_drag) / area_density * seconds);
    return pushed + (relative - pushed) * dragged;
}

}  // namespace

void blow(Cloth& cloth, const Wind& wind, float seconds) {
    const Vec4f air = with_zero_w(wind.velocity);
    std::vector<Vec4f> impulses(cloth.x.size(), Vec4f::Zero());  // N s
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        const auto x = [&](std::size_t k) -> const Vec4f& { return cloth.x[t.v[k].value]; };
        const auto move = [&](std::size_t k) { return Vec4f(x(k) - cloth.x_prev[t.v[k].value]); };
        const Vec4f area = (x(1) - x(0)).cross3(x(2) - x(0));
        const float length = area.norm();
        if (length <= 0) continue;
        const Vec4f relative = air - (move(0) + move(1) + move(2)) / (3 * cloth.substep);
        const Vec4f speed = gain(relative, area / length, wind, cloth.material.fabrics[t.panel], seconds);
        const Vec4f third = speed * third_of_mass(cloth, t.u, t.panel);
        for (const VertexId v : t.v) impulses[v.value] += third;
    }
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        cloth.x_prev[v.value] -= impulses[v.value] * (cloth.inverse_mass[v.value] * cloth.substep);
    }
}

}  // namespace selvedge::sim
