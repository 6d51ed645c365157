#include "sim/dress/hierarchy.h"

namespace selvedge {
namespace {

void add_with_inner(const AdaptiveMesh& mesh, TriangleId id, TriangleHierarchy& all) {
    const AdaptiveTriangle& t = mesh.triangle(id);
    all.push_back({.u = t.u, .panel = t.panel, .level = t.level, .is_leaf = is_leaf(t)});
    if (is_leaf(t)) return;
    const std::size_t inner = layout(t.configuration).triangle_count;
    for (std::size_t i = 0; i < inner; ++i) add_with_inner(mesh, t.internal_triangles[i], all);
}

}  // namespace

TriangleHierarchy triangle_hierarchy(const Cloth& cloth) {
    TriangleHierarchy all;
    all.reserve(cloth.mesh.triangles().size());
    for (std::size_t t = 0; t < cloth.mesh.base_triangle_count(); ++t)
        add_with_inner(cloth.mesh, TriangleId(static_cast<std::uint32_t>(t)), all);
    return all;
}

}  // namespace selvedge
