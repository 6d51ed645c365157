#include "sim/inspection/layer_order.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "sim/body/body.h"
#include "sim/cloth/contact_surface.h"
#include "sim/collide/surface_bvh.h"

namespace selvedge::sim {
namespace {

constexpr float kFlat = 0.87F;   // cosine: normals that differ by less than 30 degrees
constexpr float kAcross = 0.7F;  // cosine between a normal and the shortest way: less lies beside a border

// The cloth with its normals, which look outward, and where it is flat.
struct FlatCloth {
    ContactSurface surface;
    std::vector<Vec3f> triangle_normals;
    std::vector<Vec3f> normals;  // by vertex
    std::vector<bool> is_flat;   // by vertex: the triangles at it have nearly one normal
};

FlatCloth find_flat(const Cloth& cloth) {
    FlatCloth flat{.surface = contact_surface(cloth), .triangle_normals = {}, .normals = {}, .is_flat = {}};
    flat.normals.assign(cloth.x.size(), Vec3f::Zero());
    flat.is_flat.assign(cloth.x.size(), true);
    for (const ContactTriangle& t : flat.surface.triangles) {
        const auto x = [&](std::size_t k) -> Vec3f { return cloth.x[t.vertices[k]].head<3>(); };
        const Vec3f across = (x(1) - x(0)).cross(x(2) - x(0));
        flat.triangle_normals.push_back(across.normalized());
        for (const std::uint32_t v : t.vertices) flat.normals[v] += across;
    }
    for (Vec3f& normal : flat.normals) normal.normalize();
    for (std::size_t t = 0; t < flat.surface.triangles.size(); ++t) {
        for (const std::uint32_t v : flat.surface.triangles[t].vertices) {
            if (flat.triangle_normals[t].dot(flat.normals[v]) < kFlat) flat.is_flat[v] = false;
        }
    }
    return flat;
}

// The triangles of all layers below this one, with their indices in the surface.
struct LowerCloth {
    Body surface;
    std::vector<std::uint32_t> triangles;
};

LowerCloth cloth_below(int layer, const FlatCloth& flat, const Cloth& cloth) {
    LowerCloth lower;
    for (const Vec4f& x : cloth.x) lower.surface.x.push_back(x.head<3>().cast<double>());
    for (std::uint32_t t = 0; t < flat.surface.triangles.size(); ++t) {
        const ContactTriangle& triangle = flat.surface.triangles[t];
        if (flat.surface.sheets[triangle.sheet].layer >= layer) continue;
        lower.triangles.push_back(t);
        lower.surface.triangles.push_back({static_cast<int>(triangle.vertices[0]),
                                           static_cast<int>(triangle.vertices[1]),
                                           static_cast<int>(triangle.vertices[2])});
    }
    return lower;
}

void judge(std::uint32_t v, const FlatCloth& flat, const LowerCloth& lower, const SurfaceBvh& nearest, const Vec3f& x,
           const LayerOrderOptions& options, LayerOrder& order) {
    const auto found = nearest.closest(x, options.reach);
    if (!found) return;
    const std::uint32_t t = lower.triangles[found->triangle];
    const ContactTriangle& under = flat.surface.triangles[t];
    if (!std::ranges::all_of(under.vertices, [&](std::uint32_t w) { return flat.is_flat[w] && w != v; })) return;
    const Vec3f normal = flat.triangle_normals[t], way = x - found->point;
    const float out = way.dot(normal);
    if (normal.dot(flat.normals[v]) < kFlat || std::abs(out) < kAcross * way.norm()) return;
    ++order.judged;
    if (out >= 0) return;
    ++order.wrong;
    if (!order.wrong_vertex) order.wrong_vertex = VertexId{v};
}

}  // namespace

LayerOrder measure_layer_order(const Cloth& cloth, const LayerOrderOptions& options) {
    LayerOrder order;
    const std::set<int> layers(cloth.material.layers.begin(), cloth.material.layers.end());
    if (layers.size() < 2) return order;
    const FlatCloth flat = find_flat(cloth);
    for (const int layer : layers) {
        if (layer == *layers.begin()) continue;
        const LowerCloth lower = cloth_below(layer, flat, cloth);
        if (lower.triangles.empty()) continue;
        const SurfaceBvh nearest(lower.surface);
        std::vector<bool> is_of_layer(cloth.x.size(), false);
        for (const ContactTriangle& t : flat.surface.triangles) {
            if (flat.surface.sheets[t.sheet].layer != layer) continue;
            for (const std::uint32_t v : t.vertices) is_of_layer[v] = flat.is_flat[v];
        }
        for (std::uint32_t v = 0; v < cloth.x.size(); ++v) {
            if (is_of_layer[v]) judge(v, flat, lower, nearest, cloth.x[v].head<3>(), options, order);
        }
    }
    return order;
}

}  // namespace selvedge::sim
