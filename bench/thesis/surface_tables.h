#pragma once
// The curved-surface experiments of the thesis' chapter 6: the scenes, one run of a scene for one row of tables 6.2 and
// 6.3, and helpers that draw a curved surface.
#include <optional>
#include <string>

#include "render/draw/renderer.h"
#include "render/image/image.h"
#include "render/surface/adapt_surface.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/wind.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::bench {

// The cloth is simulated on a coarse mesh and drawn as a curved surface. (thesis 6.3)
//   A  a square pinned at two corners that are closer together than its side, so that it hangs in folds
//   B  a flag in the wind, pinned along one side
// About 250 triangles each, made by the garment mesher; cotton shirting. A frame is 1/30 s: four steps of 1/120 s.

enum class SurfaceExperiment { PinnedSquare, Flag };

inline constexpr int kSurfaceTriangles = 250;
inline constexpr double kSurfaceFrame = 1.0 / 30;  // s

struct SurfaceScene {
    SurfaceExperiment experiment = SurfaceExperiment::PinnedSquare;
    sim::GarmentMesh base;
    sim::Cloth cloth;
    int frames = 0;  // run so far
};

// The whole cloth starts at this level.
SurfaceScene make_surface_scene(SurfaceExperiment experiment, int level = 0);

// Runs one frame.
void run_frame(SurfaceScene& scene);

// Runs the number of frames that is nearest to this time, s.
void run_for(SurfaceScene& scene, double seconds);

struct SurfaceRow {
    std::string name;
    std::optional<int> level{};  // none: adaptive
    bool coarsens_back_faces = false;
};

std::vector<SurfaceRow> surface_rows();

// Means over the frames.
struct SurfaceStatistics {
    double triangles = 0;       // drawn
    double simulation_ms = 0;   // four steps, CPU time of one thread
    double surface_ms = 0;      // adaptation and update of the surface, likewise
    double drawing_ms = 0;      // wall-clock time
    double largest_jump_m = 0;  // greatest displacement of a vertex in one frame by a change of level
    render::Image picture;      // of the last frame
    std::size_t triangles_in_picture = 0;
};

struct SurfaceRunOptions {
    double seconds = 3;
    render::SurfaceKind kind = render::SurfaceKind::Constant;
    int side_px = 640;
    int drawn_frames = 3;  // number of frames that are drawn, evenly spaced
};

SurfaceStatistics run_surface(SurfaceExperiment experiment, const SurfaceRow& row, const SurfaceRunOptions& options,
                              render::Renderer& renderer);

// Normals of the coarse cloth, to be passed with cloth.x to update_surface().
std::vector<Vec4f> surface_normals(const sim::Cloth& coarse);

render::Camera surface_camera(SurfaceExperiment experiment);
render::Image draw_surface(render::Renderer& renderer, const sim::DrawMesh& mesh, SurfaceExperiment experiment,
                           render::ShowMode show, int side_px);
sim::DrawMesh mesh_of(const render::CurvedSurface& surface, const std::vector<Vec4f>& normals);

}  // namespace selvedge::bench
