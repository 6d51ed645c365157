#include "render/surface/curve.h"

#include <algorithm>
#include <string>

#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge::render {
namespace {

int deepest_level(const CurveOptions& options) {
    const int level = options.level.value_or(options.deepest_level);
    SELVEDGE_ASSERT(level >= 0 && level <= kMaxSurfaceLevel);
    return level;
}

void check_size(std::size_t triangles, int level) {
    if (triangles <= kMaxDrawnTriangles >> (2 * level)) return;
    throw sim::InputError("", "surface",
                          std::to_string(triangles) + " triangles at level " + std::to_string(level) +
                              " are more than " + std::to_string(kMaxDrawnTriangles) + ": choose a lower level");
}

// Moves the surface over the base vertices' positions and normals, and refines it as far as the options ask.
void refine(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
            const CurveOptions& options) {
    if (options.level) {
        set_surface_level(surface, *options.level);
        update_surface(surface, x, normals, options.move);
        return;
    }
    std::optional<sim::Visibility> visibility;
    if (options.view) visibility.emplace(*options.view);
    const AdaptSurfaceOptions adapting{
        .criteria = options.criteria, .visibility = visibility ? &*visibility : nullptr, .glides = options.glides};
    if (options.glides) {
        update_surface(surface, x, normals, options.move);
        adapt_surface(surface, adapting);
    } else {
        settle_surface(surface, x, normals, adapting, options.move);
    }
}

// The cloth's leaf triangles, with indices into its leaf vertices.
std::vector<sim::GarmentTriangle> leaf_triangles(const sim::AdaptiveMesh& mesh) {
    std::vector<int> index(mesh.vertex_capacity(), -1);
    int next = 0;
    for (const sim::VertexId v : mesh.leaf_vertices()) index[v.value] = next++;
    std::vector<sim::GarmentTriangle> triangles;
    triangles.reserve(mesh.leaf_triangles().size());
    for (const sim::LeafTriangle& leaf : mesh.leaf_triangles()) {
        sim::GarmentTriangle triangle{.panel = leaf.panel};
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.vertices[k] = index[leaf.v[k].value];
            triangle.u[k] = leaf.u[k].cast<double>();
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

// The values of the leaf vertices, in their order.
std::vector<Vec4f> at_leaves(const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& values) {
    std::vector<Vec4f> at;
    at.reserve(mesh.leaf_vertices().size());
    for (const sim::VertexId v : mesh.leaf_vertices()) at.push_back(values[v.value]);
    return at;
}

}  // namespace

CurvedSurface curve(std::span<const Vec4f> x, std::span<const sim::GarmentTriangle> triangles,
                    const CurveOptions& options, const std::vector<CreaseEdge>& creases) {
    const int level = deepest_level(options);
    check_size(triangles.size(), level);
    CurvedSurface surface = make_curved_surface(
        x, triangles, {.modifier = curve_modifier(options.kind), .max_level = level, .creases = creases});
    const std::vector<Vec4f> normals(surface.normals.begin(),
                                     surface.normals.begin() + static_cast<std::ptrdiff_t>(x.size()));
    CurveOptions at_once = options;
    at_once.glides = false;
    refine(surface, x, normals, at_once);
    return surface;
}

bool SurfaceOverCloth::is_over(const sim::AdaptiveMesh& mesh) const {
    return std::ranges::equal(vertices_, mesh.leaf_vertices()) && std::ranges::equal(triangles_, mesh.leaf_triangles());
}

const CurvedSurface& SurfaceOverCloth::curve(const sim::Cloth& cloth, const CurveOptions& options) {
    const sim::AdaptiveMesh& mesh = cloth.mesh;
    const std::vector<Vec4f> x = at_leaves(mesh, cloth.x);
    const bool is_kept =
        surface_ && kind_ == options.kind && surface_->mesh.max_level() == deepest_level(options) && is_over(mesh);
    if (is_kept) {
        leaf_normals(mesh, cloth.x, normals_);
        refine(*surface_, x, at_leaves(mesh, normals_), options);
        return *surface_;
    }
    surface_.reset();
    surface_ = render::curve(x, leaf_triangles(mesh), options);
    vertices_.assign(mesh.leaf_vertices().begin(), mesh.leaf_vertices().end());
    triangles_.assign(mesh.leaf_triangles().begin(), mesh.leaf_triangles().end());
    kind_ = options.kind;
    return *surface_;
}

}  // namespace selvedge::render
