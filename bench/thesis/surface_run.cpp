#include "bench/thesis/surface_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/timing.h"

namespace selvedge {
namespace {

constexpr double kTurn = 0.8;  // rad/s: the viewer of back-face coarsening walks round the cloth

double clock_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of those vertices that both have.
double largest_move(const CurvedSurface& from, const CurvedSurface& to) {
    float most = 0;
    for (const VertexId v : to.mesh.leaf_vertices()) {
        const EdgeId parent = to.mesh.vertex(v).parent;
        if (!parent) continue;
        const bool was_there = parent.value < from.mesh.edges().capacity() && from.mesh.edge(parent).centre == v;
        const auto [a, b] = to.mesh.edge(parent).ends;
        const Vec4f before = was_there ? from.x[v.value] : Vec4f((from.x[a.value] + from.x[b.value]) * 0.5F);
        most = std::max(most, (to.x[v.value] - before).norm());
    }
    return static_cast<double>(most);
}

ViewPoint viewer(SurfaceExperiment experiment, double time) {
    const Camera camera = surface_camera(experiment);
    const Eigen::AngleAxisf turn(static_cast<float>(kTurn * time), Vec3f::UnitY());
    return {.eye = camera.target + turn * (camera.eye - camera.target)};
}

class Run {
 public:
    Run(SurfaceExperiment experiment, const SurfaceRow& row, const SurfaceRunOptions& options)
        : row_(row),
          scene_(make_surface_scene(experiment)),
          surface_(make_curved_surface(scene_.base, {.modifier = curve_modifier(options.kind)})),
          visibility_(viewer(experiment, 0)) {
        if (row.level) set_surface_level(surface_, *row.level);
    }

    void frame(SurfaceFigures& sums) {
        sums.simulation_ms += 1e3 * time_once([&] { run_frame(scene_); });
        const CurvedSurface before = surface_;
        sums.surface_ms += 1e3 * time_once([&] { move(); });
        sums.triangles += static_cast<double>(surface_.mesh.leaf_triangles().size());
        if (!row_.level) sums.largest_jump_m = std::max(sums.largest_jump_m, jump_since(before));
    }

    const CurvedSurface& surface() const { return surface_; }

 private:
    void move() {
        const std::vector<Vec4f> normals = surface_normals(scene_.cloth);
        if (!row_.level) {
            visibility_.move_to(viewer(scene_.experiment, scene_.frames * kSurfaceFrame));
            adapt_surface(surface_, {.visibility = row_.coarsens_back_faces ? &visibility_ : nullptr, .glides = true});
        }
        update_surface(surface_, scene_.cloth.x, normals);
    }

    // Against the same surface moved with the cloth, but with nothing split, rejoined or gliding.
    double jump_since(CurvedSurface before) const {
        move_surface(before, scene_.cloth.x, surface_normals(scene_.cloth), {.longest_glide = 0});
        return largest_move(before, surface_);
    }

    const SurfaceRow& row_;
    SurfaceScene scene_;
    CurvedSurface surface_;
    Visibility visibility_;
};

}  // namespace

std::vector<SurfaceRow> surface_rows() {
    return {{.name = "level 0", .level = 0},
            {.name = "level 1", .level = 1},
            {.name = "level 2", .level = 2},
            {.name = "level 3", .level = 3},
            {.name = "adaptive"},
            {.name = "adaptive, back faces coarse", .coarsens_back_faces = true}};
}

std::vector<Vec4f> surface_normals(const Cloth& coarse) {
    std::vector<Vec4f> normals;
    leaf_normals(coarse.mesh, coarse.x, normals);
    return normals;
}

SurfaceFigures run_surface(SurfaceExperiment experiment, const SurfaceRow& row, const SurfaceRunOptions& options,
                           Renderer& renderer) {
    Run run(experiment, row, options);
    SurfaceFigures figures;
    const long frames = std::max(1L, std::lround(options.seconds / kSurfaceFrame));
    const long interval = std::max(1L, frames / options.drawn_frames);
    long drawn = 0;
    for (long i = 1; i <= frames; ++i) {
        run.frame(figures);
        if (i % interval != 0) continue;
        const PlainMesh mesh = mesh_of(run.surface(), run.surface().light_normals);
        figures.drawing_ms += clock_ms(
            [&] { figures.picture = draw_surface(renderer, mesh, experiment, ShowMode::Edges, options.side_px); });
        ++drawn;
    }
    for (double* mean : {&figures.triangles, &figures.simulation_ms, &figures.surface_ms})
        *mean /= static_cast<double>(frames);
    figures.drawing_ms /= static_cast<double>(drawn);
    return figures;
}

Camera surface_camera(SurfaceExperiment experiment) {
    if (experiment == SurfaceExperiment::Flag)
        return {.eye = Vec3f(0.75F, 1.5F, 4.2F), .target = Vec3f(0.6F, 1.25F, 0)};
    return {.eye = Vec3f(0.5F, 1.45F, 1.5F), .target = Vec3f(0, 1.24F, 0)};
}

PlainMesh mesh_of(const CurvedSurface& surface, const std::vector<Vec4f>& normals) {
    PlainMesh mesh;
    std::vector<std::uint32_t> places(surface.mesh.vertex_capacity());
    for (const VertexId v : surface.mesh.leaf_vertices()) {
        places[v.value] = static_cast<std::uint32_t>(mesh.x.size());
        mesh.x.emplace_back(surface.x[v.value].head<3>());
        mesh.normals.emplace_back(normals[v.value].head<3>());
    }
    for (const LeafTriangle& t : surface.mesh.leaf_triangles()) {
        mesh.triangles.push_back({places[t.v[0].value], places[t.v[1].value], places[t.v[2].value]});
        mesh.u.push_back(t.u);
        mesh.level.push_back(t.level);
    }
    return mesh;
}

Image draw_surface(Renderer& renderer, const PlainMesh& mesh, SurfaceExperiment experiment, ShowMode show,
                   int side_px) {
    Scene scene;
    scene.cloths.push_back({.mesh = mesh, .sett = {}, .show = show});
    scene.camera = surface_camera(experiment);
    scene.light = studio_light(scene.camera);
    scene.has_ground = false;
    return renderer.draw(scene, {.width_px = side_px, .height_px = side_px});
}

}  // namespace selvedge
