#pragma once
// Running the drop and judging what came of it.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/drop/bias_strip.h"
#include "bench/support/cloth_run.h"
#include "sim/cloth/cloth.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/pattern/fabric.h"

namespace selvedge::bench {

// A square of cotton dropped on a sphere, pinned in its centre: the scene by which cloth solvers are compared.

struct DropScene {
    double side = 1;        // m, of the square
    double height = 0.256;  // m, at which it starts, horizontal
    double radius = 0.25;   // m, of the sphere about the origin
    int frames = 90;
    double frame_seconds = 1.0 / 60;
    int level = 3;  // to which the coarse grid is refined
};

// 0.2 kg/m^2, a cotton. Its strain limit lies far beyond what the drop strains it.
sim::Fabric drop_fabric();

// Quads of the coarse grid along a side, of 3, 6, 11 and 22 the one that comes nearest to so many triangles once
// refined.
int base_quads_for(int triangles, const DropScene& scene = {});
int triangle_count(int base_quads, int level);

// The coarse grid at its height, moved sideways by `shift` m.
sim::GarmentMesh drop_square(int base_quads, double shift = 0, const DropScene& scene = {});

// The same square as one grid without levels, for solvers that know none: quads along a side.
sim::GarmentMesh flat_grid(int quads, const DropScene& scene = {});

// Whether frame 1.. is one at which the shape is looked at: 30, 40 .. 90.
bool is_sampled(int frame);

// What a stretch gate alone could be cheated with is judged too: means over the sampled frames, extremes over them.
struct DropQuality {
    double p99_stretch = 0;     // of warp and weft edges, mean
    double p1_compression = 0;  // 1st percentile of their strain, mean; negative
    double max_stretch = 0;
    double area_error = 0;  // mean of |area / area at rest - 1|
    double least_gap = 0;   // m, from a vertex to the sphere; negative inside
    bool is_finite = true;
};

// Adds up samples; whoever simulates the drop can be judged by it.
class DropJudge {
 public:
    explicit DropJudge(MeasuredMesh mesh, const DropScene& scene = {}) : mesh_(std::move(mesh)), scene_(scene) {}
    void sample(const std::vector<Vec3d>& x);
    DropQuality quality() const;  // pre: sampled
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
    double shift = 0;  // m, of the start, sideways
    // Contact at the vertices alone, as the solvers it is compared with have it; else in the middle of triangles too.
    bool has_contact_samples = false;
    DropScene scene{};
};

struct SphereDrop {
    ClothRun run;  // as it is after the last frame
    DropQuality quality;
    double ms_per_frame = 0;  // median over the second half of the frames
};

SphereDrop run_sphere_drop(const SphereDropOptions& options);

// The cheapest number of sub-steps with which the drop meets its gates.

struct DropGates {
    double max_stretch = 0.05;  // of p99_stretch
    double max_area_error = 0.02;
    double max_bias_error = 0.1;  // of the stiffness on the bias
};

// One number of sub-steps tried.
struct DropTrial {
    int substeps = 0;
    DropQuality quality;
    BiasStrip bias;
    double ms_per_frame = 0;
    std::vector<std::string> missed;  // names of the gates
    bool passes() const { return missed.empty(); }
    bool passes_but_for_bias() const;
};

DropTrial try_drop(const SphereDropOptions& options, const DropGates& gates);

// The least n in 1..most that passes, if passing once means passing with more: gallops 2, 4, 8 .. and bisects. Each n
// is asked once.
std::optional<int> find_least(int most, const std::function<bool(int)>& passes);

// What a drop does when nobody times it: whether it comes to rest, whether energy comes from nowhere, and how far it
// ends from where finer time steps take it.

struct RestFigures {
    double kinetic_energy = 0;  // J, after ten more seconds
    double rms_speed = 0;       // m/s, of a sub-step: what trembles counts
    double net_speed = 0;       // m/s, rms of the mean motion over the last second: what creeps
};
RestFigures rest_after(ClothRun& run, const DropScene& scene, double seconds = 10);

// Gravity is switched off for a while, and nothing does work on the cloth any more. Energy is kinetic and elastic by
// the fabric's figures; a cloth that is stretched further than they say holds less than that, so the kinetic energy is
// reported too.
struct WeightlessFigures {
    double energy_growth = 0;   // greatest energy over that at the start, less 1; 0 when it never grows
    double kinetic_growth = 0;  // most that the highest kinetic energy of a quarter of a second exceeds that of the
                                // quarter before, of that of the first
    double kinetic_end = 0;     // J
};
WeightlessFigures weightless(ClothRun& run, const DropScene& scene, double seconds = 3);

struct ConvergedFigures {
    int substeps = 0;           // of the converged runs
    ShapeDistance distance;     // from the run judged to the converged one, after the last frame
    ShapeDistance noise_floor;  // between two converged runs whose start differs by a millimetre
};
ConvergedFigures compare_converged(const SphereDrop& drop, const SphereDropOptions& options, int converged_substeps);

}  // namespace selvedge::bench
