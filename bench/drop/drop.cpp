#include "bench/drop/drop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <utility>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "sim/collide/collider.h"
#include "sim/core/gravity.h"
#include "sim/core/math.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

constexpr float kNeverSampled = std::numeric_limits<float>::max();  // m, longer than any edge: no triangle is sampled

// Pins the leaf vertex at the centre of the cloth. The centre of every grid is a vertex after refinement.
void pin_centre(ClothRun& run, double shift, const DropScene& scene) {
    const Vec3d centre(shift, scene.height, 0);
    pin_where(run, [&](const Vec3d& x) { return (x - centre).norm() < 1e-4 * scene.side; });
}

}  // namespace

void DropEvaluator::sample(const std::vector<Vec3d>& x) {
    if (samples_++ == 0) sum_.min_gap = std::numeric_limits<double>::infinity();
    if (!all_finite(mesh_, x)) {
        sum_.is_finite = false;
        return;
    }
    const YarnStretch stretch = yarn_stretch(mesh_, x);
    sum_.p99_stretch += stretch.p99;
    sum_.p1_compression += stretch.p1;
    sum_.max_stretch = std::max(sum_.max_stretch, stretch.max);
    sum_.area_error += std::abs(area_ratio(mesh_, x) - 1);
    for (const int v : mesh_.vertices)
        sum_.min_gap = std::min(sum_.min_gap, x[static_cast<std::size_t>(v)].norm() - scene_.radius);
}

DropQuality DropEvaluator::quality() const {
    DropQuality mean = sum_;
    mean.p99_stretch /= samples_;
    mean.p1_compression /= samples_;
    mean.area_error /= samples_;
    return mean;
}

SphereDrop run_sphere_drop(const SphereDropOptions& options) {
    const DropScene& scene = options.scene;
    const sim::SphereCollider sphere(Vec3f::Zero(), static_cast<float>(scene.radius));
    RunOptions running{.level = scene.level, .substeps = options.substeps, .frame_seconds = scene.frame_seconds};
    if (!options.has_contact_samples) running.sampled_edge = kNeverSampled;
    const sim::GarmentMesh square = drop_square(options.base_quads, options.shift, scene);
    SphereDrop drop{.run = start_run(square, {drop_fabric()}, running), .quality = {}};
    pin_centre(drop.run, options.shift, scene);
    DropEvaluator judge(measured(drop.run), scene);
    std::vector<double> seconds;
    for (int frame = 1; frame <= scene.frames; ++frame) {
        const double start = thread_seconds();
        run_frame(drop.run, sphere);
        if (2 * frame > scene.frames) seconds.push_back(thread_seconds() - start);
        if (is_sampled(frame)) judge.sample(positions(drop.run));
    }
    drop.quality = judge.quality();
    drop.ms_per_frame = 1e3 * sim::quantile(seconds, 0.5);
    return drop;
}

sim::Fabric drop_fabric() {
    return {.name = "drop_cotton",
            .area_density = 0.2,
            .stretch_warp = 8000,
            .stretch_weft = 8000,
            .shear = 56,
            .bending_warp = 1e-5,
            .bending_weft = 1e-5,
            .friction = 0.6,
            .damping = 0.6,
            .strain_limit = 1};
}

int triangle_count(int base_quads, int level) {
    const int quads = base_quads << level;
    return 2 * quads * quads;
}

int base_quads_for(int triangles, const DropScene& scene) {
    constexpr std::array kBaseQuads{3, 6, 11, 22};
    int nearest = kBaseQuads[0];
    for (const int quads : kBaseQuads) {
        const int best = std::abs(triangle_count(nearest, scene.level) - triangles);
        if (std::abs(triangle_count(quads, scene.level) - triangles) < best) nearest = quads;
    }
    return nearest;
}

sim::GarmentMesh drop_square(int base_quads, double shift, const DropScene& scene) {
    sim::GarmentMesh square = flat_grid(base_quads, scene);
    for (Vec3d& x : square.x) x.x() += shift;
    return square;
}

sim::GarmentMesh flat_grid(int quads, const DropScene& scene) {
    return sim::make_square(
        {.columns = quads, .rows = quads, .width = scene.side, .depth = scene.side, .height = scene.height});
}

bool is_sampled(int frame) {
    return frame >= 30 && frame <= 90 && frame % 10 == 0;
}

namespace {

constexpr const char* kBias = "bias";  // name of the gate

std::vector<std::string> missed_gates(const DropTrial& trial, const DropGates& gates) {
    std::vector<std::string> missed;
    if (!trial.quality.is_finite) return {"finite"};
    if (!(trial.quality.p99_stretch <= gates.max_stretch)) missed.emplace_back("stretch");
    if (!(trial.quality.area_error <= gates.max_area_error)) missed.emplace_back("area");
    if (!(trial.quality.min_gap >= 0)) missed.emplace_back("inside");
    if (!(std::abs(trial.bias.stiffness_ratio - 1) <= gates.max_bias_error)) missed.emplace_back(kBias);
    return missed;
}

}  // namespace

bool DropTrial::passes_but_for_bias() const {
    return std::ranges::all_of(missed, [](const std::string& gate) { return gate == kBias; });
}

DropTrial try_drop(const SphereDropOptions& options, const DropGates& gates) {
    const SphereDrop drop = run_sphere_drop(options);
    DropTrial trial;
    trial.substeps = options.substeps;
    trial.quality = drop.quality;
    trial.ms_per_frame = drop.ms_per_frame;
    trial.bias = measure_bias(drop_fabric(), {.element = options.scene.side / options.base_quads,
                                              .level = options.scene.level,
                                              .substeps = options.substeps,
                                              .frame_seconds = options.scene.frame_seconds});
    trial.missed = missed_gates(trial, gates);
    return trial;
}

std::optional<int> find_least(int most, const std::function<bool(int)>& passes) {
    int fails = 0;
    int good = std::min(2, most);
    while (!passes(good)) {
        if (good == most) return std::nullopt;
        fails = good;
        good = std::min(2 * good, most);
    }
    while (good - fails > 1) {
        const int middle = fails + (good - fails) / 2;
        (passes(middle) ? good : fails) = middle;
    }
    return good;
}

namespace {

int frames_in(double seconds, const DropScene& scene) {
    return std::max(1, static_cast<int>(std::lround(seconds / scene.frame_seconds)));
}

}  // namespace

RestStatistics rest_after(ClothRun& run, const DropScene& scene, double seconds) {
    const sim::SphereCollider sphere(Vec3f::Zero(), static_cast<float>(scene.radius));
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

EnergyStatistics weightless(ClothRun& run, const DropScene& scene, double seconds) {
    const sim::SphereCollider sphere(Vec3f::Zero(), static_cast<float>(scene.radius));
    run.options.gravity = Vec3f::Zero();
    const Energy start = energy(run);
    const int window = frames_in(0.25, scene);
    EnergyStatistics statistics;
    double first = 0;
    double before = 0;
    double highest = 0;
    for (int frame = 0; frame < frames_in(seconds, scene); ++frame) {
        run_frame(run, sphere);
        const Energy now = energy(run);
        statistics.energy_growth =
            std::max(statistics.energy_growth, (now.kinetic + now.elastic) / (start.kinetic + start.elastic) - 1);
        highest = std::max(highest, now.kinetic);
        statistics.kinetic_end = now.kinetic;
        if ((frame + 1) % window != 0) continue;
        if (first == 0) first = highest;
        if (before > 0) statistics.kinetic_growth = std::max(statistics.kinetic_growth, (highest - before) / first);
        before = std::exchange(highest, 0.0);
    }
    return statistics;
}

ConvergenceStatistics compare_converged(const SphereDrop& drop, const SphereDropOptions& options,
                                        int converged_substeps) {
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

namespace {

constexpr int kLength = 4;      // widths, of the strip
constexpr double kFrom = 1.25;  // widths below the clamp: upper gauge line
constexpr double kTo = 2.75;

// One column of quads in the plane z = 0 that hangs down from y = 0. The lowest quad is the weight, a separate panel.
sim::GarmentMesh hanging_strip(double width) {
    const int rows = kLength + 1;
    sim::GarmentMesh strip = sim::make_square({.columns = 1, .rows = rows, .width = width, .depth = width * rows});
    for (Vec3d& x : strip.x) x = Vec3d(x.x(), -x.z() - width * rows / 2, 0);
    for (sim::GarmentTriangle& t : strip.triangles) {
        const double middle = (t.u[0].y() + t.u[1].y() + t.u[2].y()) / 3;
        t.panel = middle < width ? 1 : 0;
    }
    strip.pins = {2 * rows, 2 * rows + 1};
    strip.panel_names = {"strip", "weight"};
    strip.panel_grain_angles = {std::numbers::pi / 4, std::numbers::pi / 4};
    return strip;
}

// Area density of the weight, kg/m^2: together with the strip's own weight below the middle of the gauge length, it
// causes options.strain. At least the density of the fabric.
double weight_density(const sim::Fabric& fabric, const BiasStripOptions& options) {
    const double force = options.strain * bias_stiffness(fabric);  // N/m
    const double strip_below = kLength - (kFrom + kTo) / 2;        // widths
    return std::max(force / (sim::kGravity * options.element) - strip_below * fabric.area_density, fabric.area_density);
}

}  // namespace

BiasStrip measure_bias(const sim::Fabric& fabric, const BiasStripOptions& options) {
    const double width = options.element;
    sim::Fabric weight = fabric;
    weight.area_density = weight_density(fabric, options);
    ClothRun run =
        start_run(hanging_strip(width), {fabric, weight},
                  {.level = options.level, .substeps = options.substeps, .frame_seconds = options.frame_seconds});
    BiasStrip result;
    const RestOptions resting;
    result.is_at_rest = run_to_rest(run, sim::NoBody(), resting);

    const double top = width * (kLength + 1);  // material height of the clamp
    const auto line = [&](double below) {
        const double height = top - below * width;
        return mean_material_point(run.cloth, 0, Vec2d(0, height), Vec2d(width, height));
    };
    const double rest = (kTo - kFrom) * width;
    const auto strain = [&] { return (line(kFrom).y() - line(kTo).y()) / rest - 1; };
    const double measured = mean_reading(run, sim::NoBody(), resting.damping, strain);
    const double own = (kLength - (kFrom + kTo) / 2) * width * fabric.area_density;  // kg/m, strip below gauge middle
    const double force = sim::kGravity * (own + width * weight.area_density);
    result.stiffness_ratio = bias_strain(fabric, force) / measured;
    return result;
}

}  // namespace selvedge::bench
