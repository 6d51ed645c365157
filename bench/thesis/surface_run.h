#pragma once
// One row of the thesis' tables 6.2 and 6.3: a scene run once, its cloth drawn as one surface.
#include <optional>
#include <string>

#include "bench/thesis/surface_scene.h"
#include "render/image/image.h"
#include "render/renderer.h"
#include "render/surface/adapt_surface.h"

namespace selvedge {

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
    double surface_ms = 0;      // adaption and update, likewise
    double drawing_ms = 0;      // by the clock
    double largest_jump_m = 0;  // of a vertex within a frame because of a change of level
    Image picture;              // of the last frame
};

struct SurfaceRunOptions {
    double seconds = 3;
    SurfaceKind kind = SurfaceKind::Constant;
    int side_px = 640;
    int drawn_frames = 3;  // of all, evenly spread, are drawn
};

SurfaceFigures run_surface(SurfaceExperiment experiment, const SurfaceRow& row, const SurfaceRunOptions& options,
                           Renderer& renderer);

// The coarse cloth's positions and normals as a surface asks for them are cloth.x and these.
std::vector<Vec4f> surface_normals(const Cloth& coarse);

Camera surface_camera(SurfaceExperiment experiment);
Image draw_surface(Renderer& renderer, const PlainMesh& mesh, SurfaceExperiment experiment, ShowMode show, int side_px);
PlainMesh mesh_of(const CurvedSurface& surface, const std::vector<Vec4f>& normals);

}  // namespace selvedge
