#include "sim/cloth/step.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sim/cloth/contact_surface.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/moving_contact.h"
#include "sim/cloth/moving_faces.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

// Adds the time of its scope to times->collision; asks no clock if there are no times.
class CollisionClock {
 public:
    explicit CollisionClock(StepTimes* times) : times_(times) {
        if (times_ != nullptr) start_ = std::chrono::steady_clock::now();
    }
    ~CollisionClock() {
        if (times_ == nullptr) return;
        times_->collision += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    CollisionClock(const CollisionClock&) = delete;
    CollisionClock& operator=(const CollisionClock&) = delete;

 private:
    StepTimes* times_;
    std::chrono::steady_clock::time_point start_{};
};

// One step of one garment, on one CPU thread. Batches run several garments in parallel, each on its own thread.
struct Stepper {
    Cloth& cloth;
    const Kernels& loops;
    const Collider& body;
    const StepOptions& options;

    float* points() const { return floats(cloth.solver->points); }
    float* before() const { return floats(cloth.solver->before); }
    CorrectedPoints corrected() const {
        SolverState& solver = *cloth.solver;
        return {points(), floats(solver.predicted), floats(solver.start), floats(solver.correction)};
    }
    // The share of a difference that decays within a step at that rate (1/s): 1 - exp(-rate * seconds).
    float share_at(float rate) const { return 1 - std::exp(-rate * step_seconds(cloth, options)); }

    void step();
    void begin_contacts();
    void end_contacts();
    void substep(int i);
    // In even sub-steps all bending constraints are solved; in odd ones only those with an interval of 1.
    int bend_interval(int i) const { return (cloth.solver->substeps + i) % 2 == 0 ? 2 : 1; }
    void load_points();
    void store_points();
    void predict(int i);
    void move_kinematic(int i);
    void add_momentum();
    void store_corrections();
    void solve_coarse_bend(int interval);
    void solve_coarse_limits(bool is_last);
    void prolong_centres(std::size_t level);
    void solve_bend(int interval);
    void solve_stretch(bool is_last);
    void limit_stretch();
    void update_bias();
    void pull_seams(float gap);
    void push_out_between_vertices(const StepShare& share);
    void hold(const ContactOptions& contact, const StepShare& share);
    // Pre: options.self_contact
    SelfContactOptions meeting_itself() const {
        SelfContactOptions meeting = *options.self_contact;
        meeting.is_carried = body.moving() != nullptr;
        return meeting;
    }
    MovingPoints moving_points() const { return {points(), before(), cloth.x.size()}; }
    void apply_internal_damping();
};

void Stepper::step() {
    load_points();
    begin_contacts();
    for (int i = 0; i < options.substeps; ++i) {
        substep(i);
        if (!options.self_contact) continue;
        const CollisionClock clock(options.times);
        cloth.solver->self_contact->contact.substep(moving_points(), meeting_itself());
    }
    if (options.self_contact) {
        const CollisionClock clock(options.times);
        cloth.solver->self_contact->contact.end_step(moving_points(), meeting_itself());
    }
    apply_internal_damping();
    end_contacts();
    store_points();
}

void Stepper::begin_contacts() {
    const CollisionClock clock(options.times);
    set_contact_offset(cloth, options.contact.offset);
    if (body.moving()) {
        find_moving_contacts(cloth, *body.moving(), options.contact, options.substeps);
        find_moving_faces(cloth, *body.moving(), options.contact, options.substeps);
    }
    SelfContact& self_contact = cloth.solver->self_contact->contact;
    if (options.self_contact) {
        update_contact_surface(cloth);
        if (body.moving()) self_contact.excuse(pinched_vertices(cloth.solver->contacts.moving));
        self_contact.begin_step(moving_points(), meeting_itself());
    } else {
        self_contact.forget();
    }
}

void Stepper::end_contacts() {
    const CollisionClock clock(options.times);
    if (body.moving()) end_moving_contacts(cloth, options.contact);
}

void Stepper::substep(int i) {
    const bool is_last = i + 1 == options.substeps;
    const StepShare share{.end = static_cast<float>(i + 1) / static_cast<float>(options.substeps),
                          .length = 1 / static_cast<float>(options.substeps)};
    predict(i);
    solve_coarse_bend(bend_interval(i));
    solve_bend(bend_interval(i));
    add_momentum();
    solve_coarse_limits(is_last);
    solve_stretch(is_last);
    for (int iteration = 0; iteration < options.limit_iterations; ++iteration) limit_stretch();
    if (options.solve_more) options.solve_more(points(), before());
    store_corrections();
    if (is_last) update_bias();
    push_out_between_vertices(share);
    const float to_go = static_cast<float>(options.substeps - 1 - i);
    const float gap = options.seam_gap + to_go * options.seam_gap_rate;
    ContactOptions contact = options.contact;
    contact.floor -= to_go * options.floor_rate;
    pull_seams(gap);
    hold(contact, share);
    if (options.seams.empty()) return;
    // Vertices that a seam pulled deep into the body may come out on different sides of a ridge. The second iteration
    // closes the seam along the surface.
    pull_seams(gap);
    hold(contact, share);
}

// Copies positions and inverse masses. The dummy vertex is placed 10 km away.
void Stepper::load_points() {
    SolverState& solver = *cloth.solver;
    for (std::size_t v = 0; v < cloth.x.size(); ++v) {
        solver.points[v] = cloth.x[v];
        solver.points[v].w() = cloth.inverse_mass[v];
        solver.before[v] = cloth.x_prev[v];
        solver.before[v].w() = cloth.inverse_mass[v];
    }
    solver.points.back() = solver.before.back() = Vec4f(0, 1e4F, 0, 0);
}

void Stepper::store_points() {
    for (std::size_t v = 0; v < cloth.x.size(); ++v) {
        cloth.x[v] = with_zero_w(cloth.solver->points[v].head<3>());
        cloth.x_prev[v] = with_zero_w(cloth.solver->before[v].head<3>());
    }
}

void Stepper::predict(int i) {
    const Vec3f fall = options.gravity * (cloth.substep * cloth.substep);
    const Motion motion{.keep = std::max(0.0F, 1 - (cloth.solver->damping + options.extra_damping) * cloth.substep),
                        .fall = {fall.x(), fall.y(), fall.z()}};
    loops.predict(points(), before(), floats(cloth.solver->lost), cloth.x.size(), motion);
    move_kinematic(i);
}

void Stepper::move_kinematic(int i) {
    const float share = 1 / static_cast<float>(options.substeps - i);
    for (const KinematicVertex& kinematic : options.kinematic) {
        Vec4f& x = cloth.solver->points[kinematic.vertex];
        x.head<3>() += (kinematic.to - x.head<3>()) * share;
    }
}

void Stepper::add_momentum() {
    loops.add_momentum(corrected(), cloth.x.size(), kMomentum);
}

void Stepper::store_corrections() {
    loops.store_corrections(corrected(), cloth.x.size());
}

// Coarse to fine: after each level, the centres of its split edges follow the displacements of the ends, and the next
// level starts from these positions. Returns early if no bending was passed up to coarse triangles, as for most cloths.
void Stepper::solve_coarse_bend(int interval) {
    SolverState& solver = *cloth.solver;
    const auto bends = [&](const ParentLevel& level) { return level.interval <= static_cast<float>(interval); };
    if (std::ranges::none_of(solver.constraints.parents, bends)) return;
    std::copy_n(solver.points.begin(), cloth.x.size(), solver.start.begin());
    for (std::size_t level = 0; level < solver.constraints.parents.size(); ++level) {
        ParentLevel& parents = solver.constraints.parents[level];
        if (bends(parents)) {
            parents.bend.for_colors([&](auto blocks, auto) { loops.solve_coarse_bend(blocks, points(), interval); });
        }
        prolong_centres(level);
    }
}

void Stepper::solve_coarse_limits(bool is_last) {
    SolverState& solver = *cloth.solver;
    for (std::size_t level = 0; level < solver.constraints.parents.size(); ++level) {
        ParentLevel& parents = solver.constraints.parents[level];
        parents.limits.for_colors([&](auto blocks, auto records) {
            loops.solve_coarse_limits(blocks, is_last ? records.data() : nullptr, points());
        });
        prolong_centres(level);
    }
}

void Stepper::prolong_centres(std::size_t level) {
    SolverState& solver = *cloth.solver;
    loops.prolong_centres(solver.constraints.parents[level].centres, floats(solver.start), points());
}

void Stepper::solve_bend(int interval) {
    cloth.solver->constraints.bend.for_colors([&](auto blocks, auto) { loops.solve_bend(blocks, points(), interval); });
}

// Copies of constraints beyond the fabric's strain limit are stored in lists.over, for each run of blocks from the
// index of its first block.
void Stepper::solve_stretch(bool is_last) {
    SolverLists& lists = cloth.solver->lists;
    std::size_t run = 0, first = 0;
    cloth.solver->constraints.stretch.for_colors([&](auto blocks, auto records) {
        lists.over_counts[run++] =
            loops.solve_stretch(blocks, is_last ? records.data() : nullptr, points(), &lists.over[first], lists.dummy);
        first += blocks.size();
    });
}

void Stepper::limit_stretch() {
    const SolverLists& lists = cloth.solver->lists;
    const std::vector<BlockColoring::Run>& runs = cloth.solver->constraints.stretch.coloring.runs();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        loops.limit_stretch({&lists.over[runs[i].first], lists.over_counts[i]}, points());
    }
}

// Updates the biases from the present strain and stress. The stress of the refined triangles is first
// summed coarse to fine (`above`); then leaves and refined triangles are updated fine to coarse (`below`, `off`).
void Stepper::update_bias() {
    Constraints& constraints = cloth.solver->constraints;
    const BiasGains gains{.stretch = share_at(options.stretch_bias_rate), .shear = share_at(options.shear_bias_rate)};
    LevelStress& stress = constraints.stress;
    for (const ParentLevel& level : constraints.parents) {
        loops.prolong_stress(level.limits.records, floats(stress.above));
    }
    const StressSums sums{.above = floats(stress.above), .below = floats(stress.below), .off = floats(stress.off)};
    constraints.stretch.for_colors(
        [&](auto blocks, auto records) { loops.update_bias(blocks, records, points(), before(), gains, sums); });
    for (std::size_t level = constraints.parents.size(); level-- > 0;) {
        constraints.parents[level].limits.for_colors(
            [&](auto blocks, auto records) { loops.update_limit_biases(blocks, records, gains, sums); });
    }
}

void Stepper::pull_seams(float gap) {
    SolverState& solver = *cloth.solver;
    for (const SeamPull& pull : options.seams) {
        Vec4f& a = solver.points[pull.a];
        Vec4f& b = solver.points[pull.b];
        const Vec4f d = with_zero_w((b - a).head<3>());
        const float length = d.norm(), allowed = pull.is_held ? 0 : gap;
        if (length <= allowed || a.w() + b.w() <= 0) continue;
        const Vec4f c = d * ((length - allowed) / length / (a.w() + b.w()));
        a += c * a.w();
        b -= c * b.w();
    }
}

void Stepper::push_out_between_vertices(const StepShare& share) {
    const CollisionClock clock(options.times);
    if (body.moving()) {
        push_out_samples_on_planes(cloth, loops, share, options.contact);
        return push_out_faces_on_planes(cloth, share, options.contact);
    }
    push_out_samples(cloth, loops, body, options.contact);
    push_out_faces(cloth, body, options.contact);
}

// A body that moves takes cloth along: the limit of the displacement is relative to it.
void Stepper::hold(const ContactOptions& contact, const StepShare& share) {
    const CollisionClock clock(options.times);
    if (!body.moving()) return hold_vertices(cloth, loops, body, options.max_move_per_substep, contact);
    const float longest = options.max_move_per_substep + body.moving()->longest_motion() * share.length;
    hold_vertices_on_planes(cloth, *body.moving(), loops, share, longest, contact);
}

void Stepper::apply_internal_damping() {
    const float share = share_at(options.internal_damping);
    cloth.solver->constraints.stretch.for_colors(
        [&](auto blocks, auto) { loops.apply_internal_damping(blocks, points(), before(), share); });
}

}  // namespace

float step_seconds(const Cloth& cloth, const StepOptions& options) {
    return cloth.substep * static_cast<float>(options.substeps);
}

StepReport step(Cloth& cloth, const Collider& body, const StepOptions& options) {
    SELVEDGE_ASSERT(cloth.solver->contacts.friction.size() >= cloth.x.size());
    if (stays_at_rest(cloth, body, options)) return {};
    SolverState& solver = *cloth.solver;
    const std::size_t count = cloth.x.size() + 1;
    solver.points.resize(count);
    solver.before.resize(count);
    solver.start.resize(count);
    solver.lost.resize(count, Vec4f::Zero());
    solver.predicted.resize(count);
    solver.correction.resize(count, Vec4f::Zero());
    Stepper{cloth, kernels(simd_level()), body, options}.step();
    solver.substeps = (solver.substeps + options.substeps) % 2;
    return {.substeps = options.substeps};
}

}  // namespace selvedge::sim
