#pragma once
// Runs the solver for an experiment: makes a cloth from a mesh, advances it frame by frame with a fixed number of
// sub-steps, and reads its state (positions, velocities, masses, energy). Also CPU time of the calling thread.
#include <functional>
#include <vector>

#include "bench/support/measured_mesh.h"
#include "sim/cloth/cloth.h"
#include "sim/core/gravity.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::sim {
class Collider;
}

namespace selvedge::bench {

struct RunOptions {
    int level = 3;             // of all leaves; the finest level when adaptive
    bool is_adaptive = false;  // starts at level 0 and adapts by all criteria
    int frames_per_adaptation = 4;
    int substeps = 8;  // per frame
    double frame_seconds = 1.0 / 60;
    float contact_offset = 1e-4F;  // m
    float sampled_edge = 0.02F;    // m: triangles with an edge this long have a contact sample in the middle
    float extra_damping = 0;       // 1/s, added to the damping of the fabrics
    Vec3f gravity = sim::standard_gravity();
};

struct ClothRun {
    sim::Cloth cloth;
    RunOptions options;  // level, frame_seconds and substeps are fixed by start_run(); the others may change
    int frames = 0;      // run so far; counted in adaptive runs only
};

// Starts with zero velocity at the positions of the mesh. Pinned: the mesh's pins, and the midpoint of every edge
// between two pinned vertices.
ClothRun start_run(const sim::GarmentMesh& mesh, const std::vector<sim::Fabric>& fabrics, const RunOptions& options);

// Pins the leaf vertices for which is_pinned(position) holds, and no others.
void pin_where(ClothRun& run, const std::function<bool(const Vec3d&)>& is_pinned);

void run_frame(ClothRun& run, const sim::Collider& body);

struct RestOptions {
    float damping = 6;       // 1/s, extra
    double min_seconds = 0;  // of simulated time, at least
    double max_seconds = 10;
    double rest_speed = 1e-4;  // m/s; at rest when the RMS net displacement over 0.2 s, per time, is below it
};
// Runs frames until the cloth is at rest or max_seconds have passed. Returns true if it came to rest.
bool run_to_rest(ClothRun& run, const sim::Collider& body, const RestOptions& options = {});

// Runs 1 s more with this extra damping (1/s) and returns the mean of read() over its frames. The mean removes small
// oscillations about the rest position.
double mean_reading(ClothRun& run, const sim::Collider& body, double damping, const std::function<double()>& read);

inline Vec3f position_of(const sim::Cloth& cloth, sim::VertexId vertex) {  // m
    return cloth.x[vertex.value].head<3>();
}

std::vector<Vec3d> positions(const ClothRun& run);   // m, by vertex id
std::vector<Vec3d> velocities(const ClothRun& run);  // m/s, by vertex id; 0 where pinned
std::vector<double> masses(const ClothRun& run);     // kg, by vertex id; 0 where pinned
MeasuredMesh measured(const ClothRun& run);

// J.
struct Energy {
    double kinetic = 0;
    double potential = 0;  // of gravity, zero at the origin
    double elastic = 0;    // of warp, weft and shear strain, from the fabric's stiffness values; without bending
};
Energy energy(const ClothRun& run);

double rms_speed(const ClothRun& run);  // m/s, mass-weighted

// Measures the CPU time of the calling thread over repeated runs, so that other load on the machine has little
// influence.

double thread_seconds();  // CPU time that the calling thread has used so far, s

double wall_seconds();  // of a clock that never goes back, s

struct Duration {
    double wall = 0;  // s
    double cpu = 0;   // s, of the calling thread
};

struct Timing {
    double median = 0;  // s
    double least = 0;   // s
    int runs = 0;
};

Timing timing_of(const std::vector<double>& seconds);

// CPU time of one call, s. To compare alternatives, run them alternately: call time_once() for each of them inside one
// loop, then timing_of().
template <class Work>
double time_once(Work&& work) {
    const double start = thread_seconds();
    work();
    return thread_seconds() - start;
}

template <class Work>
Duration time_both(Work&& work) {
    const double wall = wall_seconds(), cpu = thread_seconds();
    work();
    return {.wall = wall_seconds() - wall, .cpu = thread_seconds() - cpu};
}

// Calls prepare() and then work(), `runs` times. Only work() is timed.
template <class Prepare, class Work>
Timing time_runs(int runs, Prepare&& prepare, Work&& work) {
    std::vector<double> seconds;
    for (int i = 0; i < runs; ++i) {
        prepare();
        seconds.push_back(time_once(work));
    }
    return timing_of(seconds);
}

// Prevents the compiler from removing the computation of a result that is not used.
template <class T>
void keep(const T& value) {
    asm volatile("" : : "r"(&value) : "memory");
}

}  // namespace selvedge::bench
