#pragma once
// The thesis' scenes of chapter 6: cloth that is simulated coarse and drawn curved.  (SPEC 5)
//   A  a square pinned at two corners, which stand nearer to each other than it is wide, so that it hangs in folds
//   B  a flag in the wind, pinned along its hoist
// 250 triangles each, cut by the garment mesher; cotton shirting. Frames of 1/30 s: four steps of 1/120 s.
#include "sim/cloth/cloth.h"
#include "sim/cloth/wind.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge {

enum class SurfaceExperiment { PinnedSquare, Flag };

inline constexpr int kSurfaceTriangles = 250;
inline constexpr double kSurfaceFrame = 1.0 / 30;  // s

struct SurfaceScene {
    SurfaceExperiment experiment = SurfaceExperiment::PinnedSquare;
    GarmentMesh base;
    Cloth cloth;
    int frames = 0;  // so far
};

// The cloth uniformly at that level.
SurfaceScene make_surface_scene(SurfaceExperiment experiment, int level = 0);

// One frame.
void run_frame(SurfaceScene& scene);

// As many frames as make up so many seconds.
void run_for(SurfaceScene& scene, double seconds);

}  // namespace selvedge
