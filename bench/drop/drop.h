#pragma once
// Running the drop and judging what came of it.
#include <vector>

#include "bench/drop/scene.h"
#include "bench/support/cloth_run.h"

namespace selvedge {

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

}  // namespace selvedge
