#include "bench/drop/drop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/timing.h"
#include "sim/body/analytic_collider.h"
#include "sim/core/quantile.h"

namespace selvedge {
namespace {

constexpr float kNeverSampled = std::numeric_limits<float>::max();  // m, an edge that no triangle has

// The leaf vertex in the middle stays where it is. The middle of every grid is a vertex once it is refined.
void pin_centre(ClothRun& run, double shift, const DropScene& scene) {
    const Vec3d centre(shift, scene.height, 0);
    pin_where(run, [&](const Vec3d& x) { return (x - centre).norm() < 1e-4 * scene.side; });
}

}  // namespace

void DropJudge::sample(const std::vector<Vec3d>& x) {
    if (samples_++ == 0) sum_.least_gap = std::numeric_limits<double>::infinity();
    if (!all_finite(mesh_, x)) {
        sum_.is_finite = false;
        return;
    }
    const ThreadStretch stretch = thread_stretch(mesh_, x);
    sum_.p99_stretch += stretch.p99;
    sum_.p1_compression += stretch.p1;
    sum_.max_stretch = std::max(sum_.max_stretch, stretch.max);
    sum_.area_error += std::abs(area_ratio(mesh_, x) - 1);
    for (const int v : mesh_.vertices)
        sum_.least_gap = std::min(sum_.least_gap, x[static_cast<std::size_t>(v)].norm() - scene_.radius);
}

DropQuality DropJudge::quality() const {
    DropQuality mean = sum_;
    mean.p99_stretch /= samples_;
    mean.p1_compression /= samples_;
    mean.area_error /= samples_;
    return mean;
}

SphereDrop run_sphere_drop(const SphereDropOptions& options) {
    const DropScene& scene = options.scene;
    const SphereCollider sphere(Vec3f::Zero(), static_cast<float>(scene.radius));
    RunOptions running{.level = scene.level, .substeps = options.substeps, .frame_seconds = scene.frame_seconds};
    if (!options.has_contact_samples) running.sampled_edge = kNeverSampled;
    const GarmentMesh square = drop_square(options.base_quads, options.shift, scene);
    SphereDrop drop{.run = start_run(square, {drop_fabric()}, running), .quality = {}};
    pin_centre(drop.run, options.shift, scene);
    DropJudge judge(measured(drop.run), scene);
    std::vector<double> seconds;
    for (int frame = 1; frame <= scene.frames; ++frame) {
        const double start = thread_seconds();
        run_frame(drop.run, sphere);
        if (2 * frame > scene.frames) seconds.push_back(thread_seconds() - start);
        if (is_sampled(frame)) judge.sample(positions(drop.run));
    }
    drop.quality = judge.quality();
    drop.ms_per_frame = 1e3 * quantile(seconds, 0.5);
    return drop;
}

}  // namespace selvedge
