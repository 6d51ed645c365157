#pragma once
// Coarse cloths in known shapes, and surfaces over them.
#include <cmath>
#include <functional>
#include <map>
#include <tuple>
#include <vector>

#include "render/surface/adapt_surface.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/mesh/square.h"

namespace selvedge::render::test {

// A mesh of the unit square; `shape` gives the position of the material point (x, y), both in -0.5..0.5.
inline sim::GarmentMesh shaped_square(int quads, const std::function<Vec3d(double, double)>& shape) {
    sim::GarmentMesh mesh = sim::make_square({.columns = quads, .rows = quads});
    for (Vec3d& x : mesh.x) x = shape(x.x(), -x.z());
    return mesh;
}

// An arch about the z axis; its right side faces outwards.
inline Vec3d on_arch(double x, double y) {
    constexpr double radius = 0.4;
    return {radius * std::sin(x / radius), radius * std::cos(x / radius), -y};
}

// Waves that are long enough for a coarse mesh.
inline Vec3d on_waves(double x, double y) {
    return {x, 0.06 * std::sin(7 * x + 2 * y) + 0.03 * std::cos(5 * y), -y};
}

// The input that the surface takes from a coarse cloth: positions and normals of the base vertices.
struct Coarse {
    std::vector<Vec4f> x, normals;
};

inline Coarse coarse_of(const sim::GarmentMesh& base) {
    const CurvedSurface flat = make_curved_surface(base, {.max_level = 0});
    return {flat.x, flat.normals};
}

inline CurvedSurface surface_at_level(const sim::GarmentMesh& base, int level, SurfaceKind kind = SurfaceKind::Constant,
                                      int max_level = 3) {
    CurvedSurface surface = make_curved_surface(base, {.modifier = curve_modifier(kind), .max_level = max_level});
    const Coarse coarse = coarse_of(base);
    set_surface_level(surface, level);
    update_surface(surface, coarse.x, coarse.normals);
    return surface;
}

// Drawn positions by panel and material point; vertices of a seam occur once per side.
using ByMaterial = std::map<std::tuple<int, float, float>, Vec4f>;
inline ByMaterial by_material(const CurvedSurface& surface) {
    ByMaterial positions;
    for (const sim::LeafTriangle& t : surface.mesh.leaf_triangles()) {
        for (std::size_t k = 0; k < 3; ++k) positions[{t.panel, t.u[k].x(), t.u[k].y()}] = surface.x[t.v[k].value];
    }
    return positions;
}

}  // namespace selvedge::render::test
