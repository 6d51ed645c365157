#include "render/surface/curve.h"

#include <algorithm>
#include <map>
#include <string>

#include "sim/cloth/cloth.h"
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
    CurvedSurface surface =
        make_curved_surface(x, triangles, {.modifier = options.modifier, .max_level = level, .creases = creases});
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
    const bool is_kept = surface_ && modifier_ == options.modifier &&
                         surface_->mesh.max_level() == deepest_level(options) && is_over(mesh);
    if (is_kept) {
        leaf_normals(mesh, cloth.x, normals_);
        refine(*surface_, x, at_leaves(mesh, normals_), options);
        return *surface_;
    }
    surface_.reset();
    surface_ = render::curve(x, leaf_triangles(mesh), options);
    vertices_.assign(mesh.leaf_vertices().begin(), mesh.leaf_vertices().end());
    triangles_.assign(mesh.leaf_triangles().begin(), mesh.leaf_triangles().end());
    modifier_ = options.modifier;
    return *surface_;
}

namespace {

// Material coordinates with the lengths that the triangle has in space.
std::array<Vec2d, 3> laid_flat(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double length = (b - a).norm();
    if (length <= 0) return {Vec2d::Zero(), Vec2d::Zero(), Vec2d(0, (c - a).norm())};
    const Vec3d along = (b - a) / length;
    const double x = along.dot(c - a);
    return {Vec2d::Zero(), Vec2d(length, 0), Vec2d(x, (c - a - x * along).norm())};
}

std::vector<Vec4f> positions_of(const sim::DrawMesh& mesh) {
    std::vector<Vec4f> x;
    x.reserve(mesh.x.size());
    for (const Vec3f& at : mesh.x) x.push_back(sim::with_zero_w(at));
    return x;
}

std::vector<sim::GarmentTriangle> triangles_of(const sim::DrawMesh& mesh) {
    std::vector<sim::GarmentTriangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        sim::GarmentTriangle triangle{.vertices = {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)},
                                      .panel = panel_of(mesh, t)};
        if (mesh.u.empty()) {
            triangle.u = laid_flat(mesh.x[a].cast<double>(), mesh.x[b].cast<double>(), mesh.x[c].cast<double>());
        } else {
            for (std::size_t k = 0; k < 3; ++k) triangle.u[k] = mesh.u[t][k].cast<double>();
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

class MeshWriter {
 public:
    MeshWriter(const CurvedSurface& surface, const sim::DrawMesh& base, LightNormals which)
        : surface_(surface),
          base_mesh_(base),
          normals_(which == LightNormals::Recomputed ? surface.light_normals : surface.normals),
          sided_normals_(which == LightNormals::Recomputed ? surface.creases.light_normals : surface.creases.normals),
          places_(surface.mesh.vertex_capacity(), kNone) {
        mesh_.panel_names = base.panel_names;
        mesh_.panel_grain_angles = base.panel_grain_angles;
        mesh_.panel_sett_offsets = base.panel_sett_offsets;
    }

    sim::DrawMesh write() {
        for (std::uint32_t t = 0; t < surface_.mesh.base_triangle_count(); ++t) {
            base_level_ = base_mesh_.level.empty() ? 0 : base_mesh_.level[t];
            base_ = sim::TriangleId(t);
            write(base_);
        }
        return std::move(mesh_);
    }

 private:
    static constexpr std::uint32_t kNone = ~0U;

    void write(sim::TriangleId id) {
        const sim::AdaptiveTriangle& t = surface_.mesh.triangle(id);
        if (!is_leaf(t)) {
            for (std::size_t i = 0; i < layout(t.configuration).triangle_count; ++i) write(t.internal_triangles[i]);
            return;
        }
        mesh_.triangles.push_back({place(t.vertices[0]), place(t.vertices[1]), place(t.vertices[2])});
        if (!base_mesh_.u.empty()) mesh_.u.push_back(t.u);
        if (!base_mesh_.panel.empty()) mesh_.panel.push_back(t.panel);
        if (surface_.mesh.has_right_wrong_edges()) mesh_.turned_corners.push_back(t.turned ? 7 : 0);
        mesh_.level.push_back(level_from_base(t.level));
    }

    std::uint32_t place(sim::VertexId v) {
        if (!surface_.creases.empty()) {
            const auto vertex = sided(surface_.creases, surface_.mesh, v, root_of(surface_, v), base_);
            if (vertex)
                return place(sided_places_.try_emplace(*vertex, kNone).first->second, v, sided_normals_.at(*vertex));
        }
        return place(places_[v.value], v, normals_[v.value]);
    }

    std::uint32_t place(std::uint32_t& at, sim::VertexId v, const Vec4f& normal) {
        if (at != kNone) return at;
        at = static_cast<std::uint32_t>(mesh_.x.size());
        mesh_.x.emplace_back(surface_.x[v.value].head<3>());
        mesh_.vertex_level.push_back(level_of(v));
        mesh_.normals.emplace_back(normal.head<3>());
        return at;
    }

    std::uint8_t level_of(sim::VertexId v) const {
        const bool is_base = v.value < surface_.mesh.base_vertex_count();
        if (is_base) return base_mesh_.vertex_level.empty() ? std::uint8_t{0} : base_mesh_.vertex_level[v.value];
        return level_from_base(surface_.mesh.vertex(v).level);
    }
    std::uint8_t level_from_base(int level) const {
        return static_cast<std::uint8_t>(std::min(base_level_ + level, 255));
    }

    const CurvedSurface& surface_;
    const sim::DrawMesh& base_mesh_;
    const std::vector<Vec4f>& normals_;
    const std::map<SidedVertex, Vec4f>& sided_normals_;
    std::map<SidedVertex, std::uint32_t> sided_places_;
    std::vector<std::uint32_t> places_;  // by VertexId
    sim::TriangleId base_;               // being written
    int base_level_ = 0;
    sim::DrawMesh mesh_;
};

}  // namespace

sim::DrawMesh draw_mesh(const CurvedSurface& surface, const sim::DrawMesh& base, LightNormals normals) {
    SELVEDGE_ASSERT(surface.mesh.base_triangle_count() == base.triangles.size());
    return MeshWriter(surface, base, normals).write();
}

sim::DrawMesh curved_mesh(const sim::DrawMesh& coarse, const CurvedMeshOptions& options) {
    const CurvedSurface surface =
        render::curve(positions_of(coarse), triangles_of(coarse), options.curve, options.creases);
    return draw_mesh(surface, coarse, options.light_normals);
}

}  // namespace selvedge::render
