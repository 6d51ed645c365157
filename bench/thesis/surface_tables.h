#pragma once
// One row of the thesis' tables 6.2 and 6.3: a scene run once, its cloth drawn as one surface.
#include <optional>
#include <string>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "render/surface/adapt_surface.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/wind.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::bench {

// The thesis' scenes of chapter 6: cloth that is simulated coarse and drawn curved.  (SPEC 5)
//   A  a square pinned at two corners, which stand nearer to each other than it is wide, so that it hangs in folds
//   B  a flag in the wind, pinned along its hoist
// 250 triangles each, cut by the garment mesher; cotton shirting. Frames of 1/30 s: four steps of 1/120 s.

enum class SurfaceExperiment { PinnedSquare, Flag };

inline constexpr int kSurfaceTriangles = 250;
inline constexpr double kSurfaceFrame = 1.0 / 30;  // s

struct SurfaceScene {
    SurfaceExperiment experiment = SurfaceExperiment::PinnedSquare;
    sim::GarmentMesh base;
    sim::Cloth cloth;
    int frames = 0;  // so far
};

// The cloth uniformly at that level.
SurfaceScene make_surface_scene(SurfaceExperiment experiment, int level = 0);

// One frame.
void run_frame(SurfaceScene& scene);

// As many frames as make up so many seconds.
void run_for(SurfaceScene& scene, double seconds);

struct SurfaceRow {
    std::string name;
    std::optional<int> level{};  // none: adaptive
    bool coarsens_back_faces = false;
};

std::vector<SurfaceRow> surface_rows();

// Means over the frames.
struct SurfaceFigures {
    double triangles = 0;       // drawn
    double simulation_ms = 0;   // four steps, processor time of one thread
    double surface_ms = 0;      // adaptation and update, likewise
    double drawing_ms = 0;      // by the clock
    double largest_jump_m = 0;  // of a vertex within a frame because of a change of level
    render::Image picture;      // of the last frame
};

struct SurfaceRunOptions {
    double seconds = 3;
    render::SurfaceKind kind = render::SurfaceKind::Constant;
    int side_px = 640;
    int drawn_frames = 3;  // of all, evenly spread, are drawn
};

SurfaceFigures run_surface(SurfaceExperiment experiment, const SurfaceRow& row, const SurfaceRunOptions& options,
                           render::Renderer& renderer);

// The coarse cloth's positions and normals as a surface asks for them are cloth.x and these.
std::vector<Vec4f> surface_normals(const sim::Cloth& coarse);

render::Camera surface_camera(SurfaceExperiment experiment);
render::Image draw_surface(render::Renderer& renderer, const sim::PlainMesh& mesh, SurfaceExperiment experiment,
                           render::ShowMode show, int side_px);
sim::PlainMesh mesh_of(const render::CurvedSurface& surface, const std::vector<Vec4f>& normals);

}  // namespace selvedge::bench
