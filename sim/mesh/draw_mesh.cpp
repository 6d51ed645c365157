#include "sim/mesh/draw_mesh.h"

#include <utility>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

template <class T>
void keep(std::vector<T>& values, const std::vector<std::size_t>& kept) {
    if (values.empty()) return;
    std::vector<T> left;
    left.reserve(kept.size());
    for (const std::size_t i : kept) left.push_back(values[i]);
    values = std::move(left);
}

}  // namespace

DrawMesh with_triangles(DrawMesh mesh, const std::vector<std::size_t>& kept) {
    keep(mesh.triangles, kept);
    keep(mesh.u, kept);
    keep(mesh.panel, kept);
    keep(mesh.level, kept);
    return mesh;
}

std::vector<Vec3f> vertex_normals(const std::vector<Vec3f>& x,
                                  const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<Vec3d> sums(x.size(), Vec3d::Zero());
    for (const auto& [a, b, c] : triangles) {
        SELVEDGE_ASSERT(a < x.size() && b < x.size() && c < x.size());
        const Vec3d at = x[a].cast<double>();
        const Vec3d area = (x[b].cast<double>() - at).cross(x[c].cast<double>() - at);
        for (const std::uint32_t v : {a, b, c}) sums[v] += area;
    }
    std::vector<Vec3f> normals;
    normals.reserve(x.size());
    for (const Vec3d& sum : sums)
        normals.push_back(sum.isZero(0) ? Vec3f(Vec3f::UnitY()) : Vec3f(sum.stableNormalized().cast<float>()));
    return normals;
}

std::vector<Vec3f> vertex_normals(const DrawMesh& mesh) {
    return mesh.normals.size() == mesh.x.size() ? mesh.normals : vertex_normals(mesh.x, mesh.triangles);
}

}  // namespace selvedge::sim
