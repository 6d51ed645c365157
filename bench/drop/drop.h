#pragma once
// The drop benchmark: a square of cloth falls on a sphere. Runs it, measures its quality against gates (stretch, area,
// penetration, bias stiffness), and checks rest, energy and convergence over time-step size.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/support/cloth_run.h"
#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

// Measures the solver's stiffness on the bias: a strip cut at 45 degrees to the yarns hangs from its upper end, with a
// weight sewn to its lower end.

struct BiasStripOptions {
    double element = 0.1;  // m, edge of the coarse quads; the strip is one quad wide and four quads long
    int level = 3;
    int substeps = 8;  // per frame
    double frame_seconds = 1.0 / 60;
    double strain = 0.01;  // approximate strain that the weight causes
};

struct BiasStrip {
    double stiffness_ratio = 0;  // expected strain / measured strain
    bool is_at_rest = false;
};

// The elongation is measured between the lines 1.25 and 2.75 widths below the clamp. Within about one width of either
// end, yarns that hardly stretch prevent the cloth from shearing freely.
BiasStrip measure_bias(const sim::Fabric& fabric, const BiasStripOptions& options);

// A square of cotton, pinned at its centre, falls on a sphere. Other solvers run the same scene (bench/peers).

struct DropScene {
    double side = 1;        // m, of the square
    double height = 0.256;  // m, at which the horizontal square starts
    double radius = 0.25;   // m, of the sphere about the origin
    int frames = 90;
    double frame_seconds = 1.0 / 60;
    int level = 3;  // level to which the coarse grid is refined
};

// A cotton of 0.2 kg/m^2. Its strain limit is far above the strains of the drop, so that it never acts.
sim::Fabric drop_fabric();

// Quads along a side of the coarse grid: of 3, 6, 11 and 22, the number whose refined triangle count is nearest to
// `triangles`.
int base_quads_for(int triangles, const DropScene& scene = {});
int triangle_count(int base_quads, int level);

// The coarse grid at its start height, moved by `shift` m along x.
sim::GarmentMesh drop_square(int base_quads, double shift = 0, const DropScene& scene = {});

// The same square as one grid without levels, for solvers without adaptive meshes. quads: along a side.
sim::GarmentMesh flat_grid(int quads, const DropScene& scene = {});

// Whether the shape is measured at this frame (counted from 1): at 30, 40 .. 90.
bool is_sampled(int frame);

// Means and extremes over the sampled frames. Compression, area and gap are measured too, because a solver could meet
// a stretch limit alone by giving wrong results there.
struct DropQuality {
    double p99_stretch = 0;     // 99th percentile of the strain of warp and weft edges, mean
    double p1_compression = 0;  // 1st percentile of the same strain, mean; negative
    double max_stretch = 0;
    double area_error = 0;  // mean of |area / area at rest - 1|
    double min_gap = 0;     // m, smallest distance of a vertex from the sphere; negative inside
    bool is_finite = true;
};

// Accumulates samples; works with the positions of any solver.
class DropEvaluator {
 public:
    explicit DropEvaluator(MeasuredMesh mesh, const DropScene& scene = {}) : mesh_(std::move(mesh)), scene_(scene) {}
    void sample(const std::vector<Vec3d>& x);
    DropQuality quality() const;  // pre: sample() was called
    const MeasuredMesh& mesh() const { return mesh_; }

 private:
    MeasuredMesh mesh_;
    DropScene scene_;
    DropQuality sum_;
    int samples_ = 0;
};

struct SphereDropOptions {
    int base_quads = 3;
    int substeps = 8;  // per frame
    double shift = 0;  // m, of the start position along x
    // false: contact at vertices only, as in the solvers of the comparison; true: also in the middle of triangles.
    bool has_contact_samples = false;
    DropScene scene{};
};

struct SphereDrop {
    ClothRun run;  // state after the last frame
    DropQuality quality;
    double ms_per_frame = 0;  // median over the second half of the frames
};

SphereDrop run_sphere_drop(const SphereDropOptions& options);

// Search for the smallest number of sub-steps with which the drop meets its gates.

struct DropGates {
    double max_stretch = 0.05;  // of p99_stretch
    double max_area_error = 0.02;
    double max_bias_error = 0.1;  // relative error of the stiffness on the bias
};

// The result for one number of sub-steps.
struct DropTrial {
    int substeps = 0;
    DropQuality quality;
    BiasStrip bias;
    double ms_per_frame = 0;
    std::vector<std::string> missed;  // names of the gates that are not met
    bool passes() const { return missed.empty(); }
    bool passes_but_for_bias() const;
};

DropTrial try_drop(const SphereDropOptions& options, const DropGates& gates);

// The smallest n in 1..most that passes, by exponential search (2, 4, 8 ..) and bisection; none if `most` fails.
// Assumes that every n above a passing one passes too. Tests each n at most once.
std::optional<int> find_least(int most, const std::function<bool(int)>& passes);

// Quality checks that are not timed: whether the cloth comes to rest, whether its energy grows without cause, and its
// final distance from a run with smaller time steps.

struct RestStatistics {
    double kinetic_energy = 0;  // J, after `seconds` more
    double rms_speed = 0;       // m/s, from the last sub-step: includes vibration
    double net_speed = 0;       // m/s, RMS of the net displacement over the last second: creep only
};
RestStatistics rest_after(ClothRun& run, const DropScene& scene, double seconds = 10);

// Gravity is switched off, so that no external force does work on the cloth. Energy is the sum of kinetic and elastic
// energy, the latter from the fabric's stiffness values. A cloth that the solver lets stretch further stores less than
// that formula gives, so the kinetic energy is also reported alone.
struct EnergyStatistics {
    double energy_growth = 0;   // greatest energy / energy at the start - 1; 0 if it never grows
    double kinetic_growth = 0;  // peak kinetic energy of each 0.25 s window: greatest increase from one window to
                                // the next, divided by the peak of the first window
    double kinetic_end = 0;     // J, at the end
};
EnergyStatistics weightless(ClothRun& run, const DropScene& scene, double seconds = 3);

struct ConvergenceStatistics {
    int substeps = 0;           // per frame, of the converged runs
    ShapeDistance distance;     // between the tested run and the converged one, after the last frame
    ShapeDistance noise_floor;  // between two converged runs whose start positions differ by 1 mm
};
ConvergenceStatistics compare_converged(const SphereDrop& drop, const SphereDropOptions& options,
                                        int converged_substeps);

}  // namespace selvedge::bench
