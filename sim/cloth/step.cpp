#include "sim/cloth/step.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "sim/cloth/kernels.h"
#include "sim/cloth/team_work.h"
#include "sim/core/team.h"

namespace selvedge {
namespace {

constexpr std::size_t kLeastLeaves = 2000;  // below that the members would wait longer than they work

// One step, as one member of the team sees it.
struct Stepper {
    Cloth& cloth;
    const Kernels& loops;
    const Collider& body;
    const StepOptions& options;
    TeamMember& member;

    float* points() const { return floats(cloth.solver.points); }
    float* before() const { return floats(cloth.solver.before); }
    CorrectedPoints corrected(std::size_t first) const {
        SolverState& solver = cloth.solver;
        return {points() + 4 * first, floats(solver.predicted) + 4 * first, floats(solver.carried) + 4 * first,
                floats(solver.correction) + 4 * first};
    }
    std::span<StretchBlock> stretch(std::size_t first, std::size_t count) const {
        return std::span(cloth.solver.blocks.stretch).subspan(first, count);
    }

    // Share of a difference that goes within a step at that rate (1/s).
    float share_at(float rate) const { return 1 - std::exp(-rate * step_seconds(cloth, options)); }

    void step() noexcept;  // a member that left would leave the others waiting
    void substep(int i);
    bool visits_bend(int i) const { return (cloth.solver.substeps + i) % cloth.solver.blocks.bend_interval == 0; }
    void load_points();
    void store_points();
    void predict(int i);
    void lead(int i, std::size_t begin, std::size_t end);
    void add_momentum();
    void keep_corrections();
    void solve_coarse_bend();
    void limit_parents(bool is_last);
    void carry_centres(std::size_t level);
    void solve_bend();
    void solve_stretch(bool is_last);
    void limit_stretch();
    void update_bias();
    void pull_seams(float gap);
    void hold();
    void rub();
};

void Stepper::step() noexcept {
    load_points();
    for (int i = 0; i < options.substeps; ++i) substep(i);
    rub();
    store_points();
}

void Stepper::substep(int i) {
    const bool is_last = i + 1 == options.substeps;
    predict(i);
    solve_coarse_bend();
    if (visits_bend(i)) solve_bend();
    add_momentum();
    limit_parents(is_last);
    solve_stretch(is_last);
    for (int round = 0; round < options.limit_rounds; ++round) limit_stretch();
    keep_corrections();
    if (is_last) update_bias();
    push_out_samples(cloth, loops, body, options.contact, member);
    const float to_go = static_cast<float>(options.substeps - 1 - i);
    const float gap = options.seam_gap + to_go * options.seam_gap_rate;
    pull_seams(gap);
    hold();
    if (options.seams.empty()) return;
    // What was drawn deep into the body came out on different sides of a ridge: close it along the surface.
    pull_seams(gap);
    hold();
}

// Positions with inverse masses; the spare point stands far from everything.
void Stepper::load_points() {
    SolverState& solver = cloth.solver;
    const auto [begin, end] = member.part_of(cloth.x.size(), kBlock);
    for (std::size_t v = begin; v < end; ++v) {
        solver.points[v] = cloth.x[v];
        solver.points[v].w() = cloth.inverse_mass[v];
        solver.before[v] = cloth.x_prev[v];
        solver.before[v].w() = cloth.inverse_mass[v];
    }
    if (member.is_first()) solver.points.back() = solver.before.back() = Vec4f(0, 1e4F, 0, 0);
}

void Stepper::store_points() {
    const auto [begin, end] = member.part_of(cloth.x.size(), kBlock);
    for (std::size_t v = begin; v < end; ++v) {
        cloth.x[v] = padded(cloth.solver.points[v].head<3>());
        cloth.x_prev[v] = padded(cloth.solver.before[v].head<3>());
    }
}

// Members predict the points that they hold.
void Stepper::predict(int i) {
    const Vec3f fall = options.gravity * (cloth.substep * cloth.substep);
    const Motion motion{.keep = std::max(0.0F, 1 - (cloth.damping + options.extra_damping) * cloth.substep),
                        .fall = {fall.x(), fall.y(), fall.z()}};
    const auto [begin, end] = member.part_of(cloth.x.size(), kBlock);
    SolverState& solver = cloth.solver;
    loops.predict(points() + 4 * begin, before() + 4 * begin, floats(solver.lost) + 4 * begin, end - begin, motion);
    lead(i, begin, end);
    member.wait();
}

void Stepper::lead(int i, std::size_t begin, std::size_t end) {
    const float share = 1 / static_cast<float>(options.substeps - i);
    for (const LedVertex& led : options.led) {
        if (led.vertex < begin || led.vertex >= end) continue;
        Vec4f& x = cloth.solver.points[led.vertex];
        x.head<3>() += (led.to - x.head<3>()) * share;
    }
}

// Members do the points that they predict.
void Stepper::add_momentum() {
    const auto [begin, end] = member.part_of(cloth.x.size(), kBlock);
    loops.add_momentum(corrected(begin), end - begin, kMomentum);
    member.wait();
}

void Stepper::keep_corrections() {
    member.wait();
    const auto [begin, end] = member.part_of(cloth.x.size(), kBlock);
    loops.keep_corrections(corrected(begin), end - begin);
    member.wait();
}

// Coarse to fine: what a level moves its vertices by, the centres of its edges follow, so that the next level starts
// from there. Most cloths hand no bending up.
void Stepper::solve_coarse_bend() {
    SolverState& solver = cloth.solver;
    const auto bends = [](const ParentLevel& level) { return level.bends; };
    if (std::ranges::none_of(solver.blocks.parents, bends)) return;
    const auto [begin, end] = member.part_of(cloth.x.size(), kBlock);
    std::copy_n(solver.points.begin() + static_cast<std::ptrdiff_t>(begin), end - begin,
                solver.carried.begin() + static_cast<std::ptrdiff_t>(begin));
    member.wait();
    for (std::size_t level = 0; level < solver.blocks.parents.size(); ++level) {
        ParentLevel& parents = solver.blocks.parents[level];
        for_runs(member, solver.lanes.coarse_bend[level].runs(),
                 [&](std::size_t, std::size_t first, std::size_t count) {
                     if (!parents.bends) return;
                     loops.solve_coarse_bend(std::span(parents.bend).subspan(first, count), points());
                 });
        carry_centres(level);
    }
}

void Stepper::limit_parents(bool is_last) {
    SolverState& solver = cloth.solver;
    for (std::size_t level = 0; level < solver.blocks.parents.size(); ++level) {
        ParentLevel& parents = solver.blocks.parents[level];
        for_runs(member, solver.lanes.limits[level].runs(), [&](std::size_t, std::size_t first, std::size_t count) {
            loops.limit_parents(std::span(parents.triangles).subspan(first, count),
                                is_last ? &parents.records[first] : nullptr, points());
        });
        carry_centres(level);
    }
}

void Stepper::carry_centres(std::size_t level) {
    SolverState& solver = cloth.solver;
    const std::span<const EdgeCentre> centres = solver.blocks.parents[level].centres;
    const auto [begin, end] = member.part_of(centres.size());
    loops.carry_centres(centres.subspan(begin, end - begin), floats(solver.carried), points());
    member.wait();
}

void Stepper::solve_bend() {
    SolverState& solver = cloth.solver;
    for_runs(member, solver.lanes.bend.runs(), [&](std::size_t, std::size_t first, std::size_t count) {
        loops.solve_bend(std::span(solver.blocks.bend).subspan(first, count), points());
    });
}

// Each member copies the lanes that it finds beyond the fabric's strain limit to where the first of its blocks stands.
void Stepper::solve_stretch(bool is_last) {
    SolverBlocks& blocks = cloth.solver.blocks;
    const std::vector<BlockColoring::Run>& runs = cloth.solver.lanes.stretch.runs();
    for (std::size_t run = 0; run < runs.size(); ++run) blocks.over_counts[run][member.index()] = 0;
    for_runs(member, runs, [&](std::size_t run, std::size_t first, std::size_t count) {
        StretchRecord* const records = is_last ? &blocks.records[first] : nullptr;
        blocks.over_counts[run][member.index()] = static_cast<std::uint32_t>(
            loops.solve_stretch(stretch(first, count), records, points(), &blocks.over[first], blocks.spare));
    });
}

void Stepper::limit_stretch() {
    const SolverBlocks& blocks = cloth.solver.blocks;
    for_runs(member, cloth.solver.lanes.stretch.runs(), [&](std::size_t run, std::size_t first, std::size_t) {
        loops.limit_stretch({&blocks.over[first], blocks.over_counts[run][member.index()]}, points());
    });
}

// Biases follow what strain and stress are now: what each level carries is summed up, coarse to fine for what is below
// it, fine to coarse for what is above.
void Stepper::update_bias() {
    SolverBlocks& blocks = cloth.solver.blocks;
    const BiasGains gains{.stretch = share_at(options.stretch_bias_rate), .shear = share_at(options.shear_bias_rate)};
    float* const own = floats(blocks.carried.own);
    float* const above = floats(blocks.carried.above);
    float* const below = floats(blocks.carried.below);
    for (const ParentLevel& level : blocks.parents) {
        const auto [begin, end] = member.part_of(level.records.size());
        loops.carry_stress(std::span(level.records).subspan(begin, end - begin), own, above);
        member.wait();
    }
    for_runs(member, cloth.solver.lanes.stretch.runs(), [&](std::size_t, std::size_t first, std::size_t count) {
        loops.update_bias(stretch(first, count), std::span(blocks.records).subspan(first, count), points(), before(),
                          gains, above, below);
    });
    for (std::size_t level = blocks.parents.size(); level-- > 0;) {
        ParentLevel& parents = blocks.parents[level];
        for_runs(member, cloth.solver.lanes.limits[level].runs(),
                 [&](std::size_t, std::size_t first, std::size_t count) {
                     loops.update_parents(std::span(parents.triangles).subspan(first, count),
                                          std::span(parents.records).subspan(first, count), points(), before(), gains,
                                          own, above, below);
                 });
    }
}

// Pre: the team is one where there are seams.
void Stepper::pull_seams(float gap) {
    SolverState& solver = cloth.solver;
    for (const SeamPull& pull : options.seams) {
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

void Stepper::hold() {
    hold_vertices(cloth, loops, body, options.max_move_per_substep, options.contact, member);
}

void Stepper::rub() {
    member.wait();
    for_runs(member, cloth.solver.lanes.stretch.runs(), [&](std::size_t, std::size_t first, std::size_t count) {
        loops.rub(stretch(first, count), points(), before(), share_at(options.internal_damping));
    });
}

}  // namespace

float step_seconds(const Cloth& cloth, const StepOptions& options) {
    return cloth.substep * static_cast<float>(options.substeps);
}

void step(Cloth& cloth, const Collider& body, const StepOptions& options) {
    SolverState& solver = cloth.solver;
    const std::size_t count = cloth.x.size() + 1;
    solver.points.resize(count);
    solver.before.resize(count);
    solver.carried.resize(count);
    solver.lost.resize(count, Vec4f::Zero());
    solver.predicted.resize(count);
    solver.correction.resize(count, Vec4f::Zero());
    const Kernels& loops = kernels(simd_level());
    const bool may_divide = options.seams.empty() && cloth.mesh.leaf_triangles().size() >= kLeastLeaves;
    const int most = may_divide && solver.trial.is_better() ? static_cast<int>(kMostMembers) : 1;
    const auto start = std::chrono::steady_clock::now();
    const auto work = [&](TeamMember& member) { Stepper{cloth, loops, body, options, member}.step(); };
    run_on_team(most, std::cref(work));  // by reference: a function that holds more would allocate
    if (may_divide) solver.trial.note(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    solver.substeps = (solver.substeps + options.substeps) % 2;
}

}  // namespace selvedge
