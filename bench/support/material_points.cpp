#include "bench/support/material_points.h"

#include <algorithm>
#include <array>
#include <limits>

namespace selvedge {
namespace {

using Weights = std::array<double, 3>;

Weights barycentric(const LeafTriangle& t, const Vec2d& u) {
    const Vec2d origin = t.u[0].cast<double>();
    const Vec2d e1 = t.u[1].cast<double>() - origin;
    const Vec2d e2 = t.u[2].cast<double>() - origin;
    const Vec2d d = u - origin;
    const double area = cross2(e1, e2);
    const double w1 = cross2(d, e2) / area;
    const double w2 = cross2(e1, d) / area;
    return {1 - w1 - w2, w1, w2};
}

}  // namespace

Vec3d material_point(const Cloth& cloth, int panel, const Vec2d& u) {
    double best = -std::numeric_limits<double>::infinity();
    Vec3d found = Vec3d::Zero();
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        if (t.panel != panel) continue;
        const Weights w = barycentric(t, u);
        const double least = *std::ranges::min_element(w);
        if (least <= best) continue;
        best = least;
        found.setZero();
        for (std::size_t k = 0; k < 3; ++k) found += w[k] * cloth.x[t.v[k].value].head<3>().cast<double>();
    }
    return found;
}

Vec3d mean_material_point(const Cloth& cloth, int panel, const Vec2d& u, const Vec2d& v, int count) {
    Vec3d sum = Vec3d::Zero();
    for (int i = 0; i < count; ++i) sum += material_point(cloth, panel, u + (v - u) * (double(i) / (count - 1)));
    return sum / count;
}

}  // namespace selvedge
