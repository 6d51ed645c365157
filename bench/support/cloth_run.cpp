#include "bench/support/cloth_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <utility>

#include "sim/adaptive/criteria.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/step.h"
#include "sim/core/math.h"

namespace selvedge::bench {
namespace {

constexpr float kNoFloor = -1000.0F;  // m

// Sets the state of the vertices that uniform refinement creates: midpoints of their edges.
struct Midpoints {
    sim::Cloth& cloth;

    void on_capacity(std::size_t capacity) { size_state(cloth, capacity); }
    void on_split(sim::VertexId c, sim::VertexId a, sim::VertexId b) {
        cloth.x[c.value] = (cloth.x[a.value] + cloth.x[b.value]) * 0.5F;
        cloth.x_prev[c.value] = (cloth.x_prev[a.value] + cloth.x_prev[b.value]) * 0.5F;
        cloth.is_pinned[c.value] = cloth.is_pinned[a.value] && cloth.is_pinned[b.value];
    }
    void on_rejoin(sim::VertexId) {}
};

sim::ContactOptions contact_options(const RunOptions& options) {
    return {.offset = options.contact_offset,
            .sample_spacing = 1.0F,
            .sampled_edge = options.sampled_edge,
            .floor = kNoFloor};
}

void refresh(ClothRun& run) {
    refresh_solver(run.cloth);
    refresh_contacts(run.cloth, contact_options(run.options));
    update_normals(run.cloth);
}

// m; shorter than any leaf edge, so that refinement is limited by the level only.
constexpr float kNoShortestEdge = 1e-6F;

void adapt_run(ClothRun& run, const sim::Collider& body) {
    adapt_cloth(run.cloth, body, {.shortest_edge = kNoShortestEdge}, contact_options(run.options));
}

// m/s: RMS displacement since `before`, over the leaf vertices that can move and existed then, divided by the time.
double net_speed(const ClothRun& run, const std::vector<Vec3d>& before, double seconds) {
    double sum = 0;
    double count = 0;
    for (const sim::VertexId v : run.cloth.mesh.leaf_vertices()) {
        if (v.value >= before.size() || run.cloth.inverse_mass[v.value] <= 0) continue;
        sum += (run.cloth.x[v.value].head<3>().cast<double>() - before[v.value]).squaredNorm();
        ++count;
    }
    return count > 0 ? std::sqrt(sum / count) / seconds : 0;
}

}  // namespace

ClothRun start_run(const sim::GarmentMesh& mesh, const std::vector<sim::Fabric>& fabrics, const RunOptions& options) {
    const auto substep = static_cast<float>(options.frame_seconds / options.substeps);
    ClothRun run{make_cloth(mesh, fabrics, {.max_level = options.level, .substep = substep}), options};
    if (!options.is_adaptive) {
        Midpoints state{run.cloth};
        set_uniform_level(run.cloth.mesh, state, options.level);
    }
    refresh(run);
    return run;
}

void pin_where(ClothRun& run, const std::function<bool(const Vec3d&)>& is_pinned) {
    for (const sim::VertexId v : run.cloth.mesh.leaf_vertices())
        run.cloth.is_pinned[v.value] = is_pinned(run.cloth.x[v.value].head<3>().cast<double>());
    refresh(run);
}

void run_frame(ClothRun& run, const sim::Collider& body) {
    const RunOptions& options = run.options;
    if (options.is_adaptive && run.frames++ % options.frames_per_adaptation == 0) adapt_run(run, body);
    sim::StepOptions stepping{
        .substeps = options.substeps, .gravity = options.gravity, .contact = contact_options(options)};
    stepping.extra_damping = options.extra_damping;
    stepping.max_move_per_substep = 0.1F;  // m; safe because the objects in the experiments have no thin parts
    step(run.cloth, body, stepping);
}

bool run_to_rest(ClothRun& run, const sim::Collider& body, const RestOptions& options) {
    constexpr double kWatched = 0.2;  // s
    const auto frames = static_cast<int>(std::ceil(kWatched / run.options.frame_seconds));
    const float damping = run.options.extra_damping;
    run.options.extra_damping = options.damping;
    bool is_at_rest = false;
    for (double t = 0; !is_at_rest && t < options.max_seconds; t += frames * run.options.frame_seconds) {
        const std::vector<Vec3d> before = positions(run);
        for (int i = 0; i < frames; ++i) run_frame(run, body);
        const double speed = net_speed(run, before, frames * run.options.frame_seconds);
        is_at_rest = speed < options.rest_speed && t >= options.min_seconds;
    }
    run.options.extra_damping = damping;
    return is_at_rest;
}

double mean_reading(ClothRun& run, const sim::Collider& body, double damping, const std::function<double()>& read) {
    constexpr double kSeconds = 1;
    const auto frames = static_cast<int>(std::ceil(kSeconds / run.options.frame_seconds));
    const float kept = std::exchange(run.options.extra_damping, static_cast<float>(damping));
    double sum = 0;
    for (int i = 0; i < frames; ++i) {
        run_frame(run, body);
        sum += read();
    }
    run.options.extra_damping = kept;
    return sum / frames;
}

std::vector<Vec3d> positions(const ClothRun& run) {
    std::vector<Vec3d> x;
    x.reserve(run.cloth.x.size());
    for (const Vec4f& p : run.cloth.x) x.push_back(p.head<3>().cast<double>());
    return x;
}

std::vector<Vec3d> velocities(const ClothRun& run) {
    const sim::Cloth& cloth = run.cloth;
    std::vector<Vec3d> v(cloth.x.size(), Vec3d::Zero());
    for (const sim::VertexId id : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[id.value] <= 0) continue;
        const Vec4f moved = cloth.x[id.value] - cloth.x_prev[id.value];
        v[id.value] = moved.head<3>().cast<double>() / static_cast<double>(cloth.substep);
    }
    return v;
}

std::vector<double> masses(const ClothRun& run) {
    std::vector<double> mass(run.cloth.x.size(), 0.0);
    for (const sim::VertexId v : run.cloth.mesh.leaf_vertices()) {
        const auto w = static_cast<double>(run.cloth.inverse_mass[v.value]);
        if (w > 0) mass[v.value] = 1 / w;
    }
    return mass;
}

MeasuredMesh measured(const ClothRun& run) {
    MeasuredMeshBuilder builder;
    for (const sim::LeafTriangle& t : run.cloth.mesh.leaf_triangles()) {
        std::array<MeasuredCorner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = {static_cast<int>(t.v[k].value), t.u[k].cast<double>()};
        builder.add(corners, static_cast<double>(run.cloth.material.grain_angles[t.panel]));
    }
    return builder.finish();
}

Energy energy(const ClothRun& run) {
    const sim::Cloth& cloth = run.cloth;
    const std::vector<Vec3d> v = velocities(run);
    const std::vector<double> mass = masses(run);
    Energy energy;
    for (const sim::VertexId id : cloth.mesh.leaf_vertices()) {
        energy.kinetic += 0.5 * mass[id.value] * v[id.value].squaredNorm();
        const Vec3d gravity = run.options.gravity.cast<double>();
        const Vec4f x = (cloth.x[id.value] + cloth.x_prev[id.value]) * 0.5F;
        energy.potential -= mass[id.value] * gravity.dot(x.head<3>().cast<double>());
    }
    const std::vector<sim::TriangleStrain> strains = measure_strain(cloth);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const sim::LeafTriangle& triangle = cloth.mesh.leaf_triangles()[i];
        const sim::Fabric& fabric = cloth.material.fabrics[triangle.panel];
        const auto squared = [](float value) { return static_cast<double>(value) * static_cast<double>(value); };
        energy.elastic += 0.5 * static_cast<double>(sim::material_area(triangle.u)) *
                          (fabric.stretch_warp * squared(strains[i].warp) +
                           fabric.stretch_weft * squared(strains[i].weft) + fabric.shear * squared(strains[i].shear));
    }
    return energy;
}

double rms_speed(const ClothRun& run) {
    double total = 0;
    for (const double mass : masses(run)) total += mass;
    return total > 0 ? std::sqrt(2 * energy(run).kinetic / total) : 0;
}

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Timing timing_of(const std::vector<double>& seconds) {
    if (seconds.empty()) return {};
    return {.median = sim::quantile(seconds, 0.5),
            .least = *std::min_element(seconds.begin(), seconds.end()),
            .runs = static_cast<int>(seconds.size())};
}

}  // namespace selvedge::bench
