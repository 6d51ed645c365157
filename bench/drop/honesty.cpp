#include "bench/drop/honesty.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/body/analytic_collider.h"

namespace selvedge {
namespace {

int frames_in(double seconds, const DropScene& scene) {
    return std::max(1, static_cast<int>(std::lround(seconds / scene.frame_seconds)));
}

}  // namespace

RestFigures rest_after(ClothRun& run, const DropScene& scene, double seconds) {
    const SphereCollider sphere(Vec3f::Zero(), static_cast<float>(scene.radius));
    const int watched = frames_in(1, scene);
    const int frames = frames_in(seconds, scene);
    const MeasuredMesh mesh = measured(run);
    std::vector<Vec3d> before;
    for (int frame = 0; frame < frames; ++frame) {
        if (frame == std::max(0, frames - watched)) before = positions(run);
        run_frame(run, sphere);
    }
    const double watched_seconds = std::min(watched, frames) * scene.frame_seconds;
    return {.kinetic_energy = energy(run).kinetic,
            .rms_speed = rms_speed(run),
            .net_speed = shape_distance(mesh, before, positions(run)).rms / watched_seconds};
}

WeightlessFigures weightless(ClothRun& run, const DropScene& scene, double seconds) {
    const SphereCollider sphere(Vec3f::Zero(), static_cast<float>(scene.radius));
    run.options.gravity = Vec3f::Zero();
    const Energy start = energy(run);
    const int window = frames_in(0.25, scene);
    WeightlessFigures figures;
    double first = 0;
    double before = 0;
    double highest = 0;
    for (int frame = 0; frame < frames_in(seconds, scene); ++frame) {
        run_frame(run, sphere);
        const Energy now = energy(run);
        figures.energy_growth =
            std::max(figures.energy_growth, (now.kinetic + now.elastic) / (start.kinetic + start.elastic) - 1);
        highest = std::max(highest, now.kinetic);
        figures.kinetic_end = now.kinetic;
        if ((frame + 1) % window != 0) continue;
        if (first == 0) first = highest;
        if (before > 0) figures.kinetic_growth = std::max(figures.kinetic_growth, (highest - before) / first);
        before = std::exchange(highest, 0.0);
    }
    return figures;
}

ConvergedFigures compare_converged(const SphereDrop& drop, const SphereDropOptions& options, int converged_substeps) {
    SphereDropOptions fine = options;
    fine.substeps = converged_substeps;
    const SphereDrop converged = run_sphere_drop(fine);
    fine.shift += 0.001;
    const SphereDrop shifted = run_sphere_drop(fine);
    const MeasuredMesh mesh = measured(converged.run);
    const std::vector<Vec3d> x = positions(converged.run);
    return {.substeps = converged_substeps,
            .distance = shape_distance(mesh, positions(drop.run), x),
            .noise_floor = shape_distance(mesh, positions(shifted.run), x)};
}

}  // namespace selvedge
