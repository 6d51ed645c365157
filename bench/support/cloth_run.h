#pragma once
// The experiments' one door to the solver: a cloth made of a mesh, run frame by frame at so many sub-steps, and its
// state read off.
#include <functional>
#include <vector>

#include "bench/support/measured_mesh.h"
#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {
class Collider;
}

namespace selvedge::bench {

struct RunOptions {
    int level = 3;             // of all leaves; of the finest ones when adaptive
    bool is_adaptive = false;  // starts at level 0, and adapts by all criteria
    int frames_per_adaptation = 4;
    int substeps = 8;  // per frame
    double frame_seconds = 1.0 / 60;
    float contact_offset = 1e-4F;  // m
    float sampled_edge = 0.02F;    // m: triangles with a longer edge have a contact sample in their middle
    float extra_damping = 0;       // 1/s, on top of the fabrics'
    Vec3f gravity = Vec3f(0, -9.81F, 0);
};

struct ClothRun {
    sim::Cloth cloth;
    RunOptions options;  // level, frame_seconds and substeps are settled at the start; the others may change
    int frames = 0;      // that were run
};

// At rest where the mesh stands. Pins: the mesh's, and the middle of every edge between two of them.
ClothRun start_run(const sim::GarmentMesh& mesh, const std::vector<sim::Fabric>& fabrics, const RunOptions& options);

// Pins the leaf vertices for which is_pinned(position) holds, and no others.
void pin_where(ClothRun& run, const std::function<bool(const Vec3d&)>& is_pinned);

void run_frame(ClothRun& run, const sim::Collider& body);

struct RestOptions {
    float damping = 6;         // 1/s, extra
    double least_seconds = 0;  // of simulated time
    double max_seconds = 10;
    double rest_speed = 1e-4;  // m/s, root mean square over the vertices of their net speed over a fifth of a second
};
// Frames until the cloth is at rest, or time is up. True when it came to rest.
bool run_to_rest(ClothRun& run, const sim::Collider& body, const RestOptions& options = {});

// The mean of what is read over one more second with that damping (1/s): what trembles about its rest is read at it.
double mean_reading(ClothRun& run, const sim::Collider& body, double damping, const std::function<double()>& read);

std::vector<Vec3d> positions(const ClothRun& run);   // m, by vertex id
std::vector<Vec3d> velocities(const ClothRun& run);  // m/s, by vertex id; 0 where pinned
std::vector<double> masses(const ClothRun& run);     // kg, by vertex id; 0 where pinned
MeasuredMesh measured(const ClothRun& run);

// J.
struct Energy {
    double kinetic = 0;
    double potential = 0;  // of gravity, above y = 0
    double elastic = 0;    // what warp, weft and shear strain store by the fabric's figures, now; without bending
};
Energy energy(const ClothRun& run);

double rms_speed(const ClothRun& run);  // m/s, over mass

}  // namespace selvedge::bench
