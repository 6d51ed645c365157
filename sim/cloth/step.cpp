#include "sim/cloth/step.h"

#include <algorithm>
#include <cmath>

#include "sim/cloth/kernels.h"

namespace selvedge {
namespace {

// Positions with inverse masses; the spare point stands far from everything.
void load_points(Cloth& cloth) {
    const Vec4f far_away(0, 1e4F, 0, 0);
    SolverState& solver = cloth.solver;
    const std::size_t count = cloth.x.size();
    solver.points.resize(count + 1);
    solver.before.resize(count + 1);
    for (std::size_t v = 0; v < count; ++v) {
        solver.points[v] = cloth.x[v];
        solver.points[v].w() = cloth.inverse_mass[v];
        solver.before[v] = cloth.x_prev[v];
        solver.before[v].w() = cloth.inverse_mass[v];
    }
    solver.points[count] = far_away;
    solver.before[count] = far_away;
}

void store_points(Cloth& cloth) {
    for (std::size_t v = 0; v < cloth.x.size(); ++v) {
        cloth.x[v] = cloth.solver.points[v];
        cloth.x[v].w() = 0;
        cloth.x_prev[v] = cloth.solver.before[v];
        cloth.x_prev[v].w() = 0;
    }
}

Motion motion_of(const Cloth& cloth, const StepOptions& options) {
    const float h = cloth.substep;
    const Vec3f fall = options.gravity * (h * h);
    return {.keep = std::max(0.0F, 1 - (cloth.damping + options.extra_damping) * h),
            .fall = {fall.x(), fall.y(), fall.z()}};
}

void limit_parents(SolverState& solver, const Kernels& loops) {
    if (solver.blocks.parents.empty() || solver.blocks.parents.front().triangles.empty()) return;
    solver.carried = solver.points;
    for (const ParentLevel& level : solver.blocks.parents) {
        loops.limit_parents(level.triangles, floats(solver.points));
        loops.carry_centres(level.centres, floats(solver.carried), floats(solver.points));
    }
}

void pull_seams(SolverState& solver, std::span<const SeamPull> seams, float gap) {
    for (const SeamPull& pull : seams) {
        Vec4f& a = solver.points[pull.a];
        Vec4f& b = solver.points[pull.b];
        const Vec4f d = padded((b - a).head<3>());
        const float length = d.norm();
        if (length <= gap || a.w() + b.w() <= 0) continue;
        const Vec4f c = d * ((length - gap) / length / (a.w() + b.w()));
        a += c * a.w();
        b -= c * b.w();
    }
}

void solve_internal(Cloth& cloth, const Kernels& loops, int limit_rounds, bool is_last) {
    SolverState& solver = cloth.solver;
    limit_parents(solver, loops);
    if (solver.count++ % static_cast<std::size_t>(cloth.bend_interval) == 0) {
        loops.solve_bend(solver.blocks.bend, floats(solver.points));
    }
    const std::size_t over =
        loops.solve_stretch(solver.blocks.stretch, is_last ? solver.blocks.records.data() : nullptr,
                            floats(solver.points), solver.blocks.over.data());
    const std::span<const std::uint32_t> lanes_over(solver.blocks.over.data(), over);
    for (int round = 0; round < limit_rounds; ++round) {
        loops.limit_stretch(solver.blocks.stretch, solver.lanes.stretch.colors(), lanes_over, solver.blocks.spare,
                            floats(solver.points));
    }
}

float step_seconds(const Cloth& cloth, const StepOptions& options) {
    return cloth.substep * static_cast<float>(options.substeps);
}

// Share of a difference that goes within a step at that rate (1/s).
float share_in(float seconds, float rate) {
    return 1 - std::exp(-rate * seconds);
}

// Biases follow what strain and stress are now.
void update_bias(Cloth& cloth, const Kernels& loops, const StepOptions& options) {
    const float seconds = step_seconds(cloth, options);
    SolverState& solver = cloth.solver;
    loops.update_bias(
        solver.blocks.stretch, solver.blocks.records, floats(solver.points), floats(solver.before),
        {.stretch = share_in(seconds, options.stretch_bias_rate), .shear = share_in(seconds, options.shear_bias_rate)});
}

}  // namespace

void step(Cloth& cloth, const Collider& body, const StepOptions& options) {
    const Kernels& loops = kernels(simd_level());
    const Motion motion = motion_of(cloth, options);
    SolverState& solver = cloth.solver;
    load_points(cloth);
    for (int i = 0; i < options.substeps; ++i) {
        const bool is_last = i + 1 == options.substeps;
        loops.predict(floats(solver.points), floats(solver.before), cloth.x.size(), motion);
        solve_internal(cloth, loops, options.limit_rounds, is_last);
        if (is_last) update_bias(cloth, loops, options);
        push_out_samples(cloth, loops, body, options.contact);
        const float to_go = static_cast<float>(options.substeps - 1 - i);
        const float gap = options.seam_gap + to_go * options.seam_gap_rate;
        pull_seams(solver, options.seams, gap);
        hold_vertices(cloth, loops, body, options.max_move_per_substep, options.contact);
        if (options.seams.empty()) continue;
        // What was drawn deep into the body came out on different sides of a ridge: close it along the surface.
        pull_seams(solver, options.seams, gap);
        hold_vertices(cloth, loops, body, options.max_move_per_substep, options.contact);
    }
    loops.rub(solver.blocks.stretch, floats(solver.points), floats(solver.before),
              share_in(step_seconds(cloth, options), options.internal_damping));
    store_points(cloth);
}

}  // namespace selvedge
