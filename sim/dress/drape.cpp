#include "sim/dress/drape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/cloth/solver_state.h"
#include "sim/cloth/standoff.h"
#include "sim/core/assert.h"
#include "sim/core/stopwatch.h"
#include "sim/dress/work_count.h"

namespace selvedge::sim {
namespace {

constexpr float kFloorSpeed = 0.2F;  // m/s: slow against falling cloth, so that it folds what it meets as a fall does

constexpr int kCalmInterval = 3;  // frames between adaptations of calm cloth, which moves 5 mm (rms) at most meanwhile

// Number of sub-steps that replace one in the final phase: more for a smaller minimum edge length.
int finishing_substeps(float shortest_edge) {
    constexpr float kOnce = 0.08F;  // m, edge length for which one would suffice
    return static_cast<int>(std::lround(std::clamp(kOnce / std::max(shortest_edge, 0.001F), 4.0F, 16.0F)));
}

// The vertex that moved most in the last sub-step; none if none moved.
std::optional<VertexId> fastest_vertex(const Cloth& cloth) {
    std::optional<VertexId> fastest;
    float most = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const float moved = (cloth.x[v.value] - cloth.x_prev[v.value]).squaredNorm();
        if (!(moved > most)) continue;
        most = moved;
        fastest = v;
    }
    return fastest;
}

// Projects onto the strain limits and out of the body, until an exact test finds no face inside it.
void project_out(Simulation& simulation, const Collider& body, const Schedule& schedule) {
    constexpr float kDepth = 0.0004F;  // m: less than the depth that a report counts, FaultLimits::depth
    constexpr int kTests = 6;
    simulation.cloth().solver->contacts.faces.clear();
    simulation.project(body, schedule);
    for (int test = 0; test < kTests && watch_faces_inside(simulation.cloth(), body, kDepth) > 0; ++test)
        simulation.project(body, schedule);
}

}  // namespace

std::string DrapeResult::stopped_because() const {
    if (bad_vertex) return "bad number";
    if (given_up == GiveUp::TooSmall) return "too small";
    if (given_up == GiveUp::SlipsDown) return "slips down";
    if (given_up == GiveUp::TooMuchWork) return "work limit";
    return settled ? "settled" : "time limit";
}

double most_work(const Cloth& cloth) {
    // 20 s on one core. A circle skirt, the slowest garment that was seen to come to rest, takes 27 million.
    constexpr double kMost = 60e6;
    constexpr double kPerLeaf = 2000;  // of meshes that are asked to be finer: 300 to 1,000 are usual
    return std::max(kMost, kPerLeaf * static_cast<double>(cloth.mesh.leaf_triangles().size()));
}

DrapeRun::DrapeRun(Simulation& simulation, const DrapeOptions& options)
    : options_(options), usual_substep_(simulation.cloth().substep) {
    Cloth& cloth = simulation.cloth();
    const ContactOptions contact = simulation.contact({});
    refresh_contacts(cloth, contact);
    free_standoffs(cloth, standoffs(simulation, 0));
    result_.bad_vertex = find_bad_vertex(cloth);
    if (!result_.bad_vertex) lowered_floor_ = std::max(0.0F, contact.floor - lowest_height(cloth));
    change_phase(simulation);
}

bool DrapeRun::advance(Simulation& simulation, const Collider& body) {
    if (phase_ == DrapePhase::Relax) {
        relax_frame(simulation, body);
    } else if (phase_ == DrapePhase::Fall) {
        fall_frame(simulation, body);
    } else {
        finish_frame(simulation, body);
    }
    change_phase(simulation);
    return phase_ != DrapePhase::Done;
}

void DrapeRun::reactivate(Simulation& simulation) {
    if (phase_ == DrapePhase::Relax || result_.bad_vertex) return;
    Cloth& cloth = simulation.cloth();
    if (cloth.substep != usual_substep_) set_substep(cloth, usual_substep_);
    result_.settled = false;
    result_.given_up.reset();
    fraction_ = 0;
    begin_fall();
}

void DrapeRun::give_up(Simulation& simulation, GiveUp why) {
    SELVEDGE_ASSERT(phase_ == DrapePhase::Relax || phase_ == DrapePhase::Fall);
    result_.given_up = why;
    end_fall(simulation);
}

bool DrapeRun::takes_too_much_work(const Cloth& cloth) const {
    return result_.work > options_.most_work.value_or(most_work(cloth));
}

bool DrapeRun::hangs() const {
    return falls() && lowered_ >= options_.lowering_time;
}

bool DrapeRun::hangs_calmly() const {
    return hangs() && result_.rms_speed < options_.calm_speed;
}

void DrapeRun::clear_times() {
    result_.adaptation_ms.clear();
    result_.step_ms.clear();
}

void DrapeRun::change_phase(Simulation& simulation) {
    if (result_.bad_vertex) return end(simulation);
    if (phase_ == DrapePhase::Relax && relaxed_ >= std::min(options_.relax_time, options_.max_seconds)) begin_fall();
    const bool has_time = result_.simulated_seconds + options_.finish_time < options_.max_seconds - half_frame();
    if (phase_ == DrapePhase::Fall && (!has_time || at_rest_ >= options_.rest_time)) end_fall(simulation);
    if (phase_ == DrapePhase::Finish && !finishes()) end(simulation);
}

void DrapeRun::begin_fall() {
    phase_ = DrapePhase::Fall;
    phase_start_ = result_.simulated_seconds;
    at_rest_ = 0;
    may_rejoin_ = true;
    bias_rate_ = 1;
}

void DrapeRun::end_fall(Simulation& simulation) {
    result_.settled = at_rest_ >= options_.rest_time;
    result_.fall_speed = result_.rms_speed;
    result_.fastest = fastest_vertex(simulation.cloth());
    const bool has_time = options_.finish_time > 0 &&
                          result_.simulated_seconds + options_.finish_time <= options_.max_seconds + half_frame();
    if (!has_time) return end(simulation);
    Cloth& cloth = simulation.cloth();
    phase_ = DrapePhase::Finish;
    phase_start_ = result_.simulated_seconds;
    excess_ = total_excess(cloth);
    lessens_ = true;  // as is to be seen
    refresh_contacts(cloth, simulation.contact(last(simulation)));
    const int parts = finishing_substeps(simulation.options().adapt.shortest_edge);
    set_substep(cloth, usual_substep_ / static_cast<float>(parts));
}

void DrapeRun::end(Simulation& simulation) {
    phase_ = DrapePhase::Done;
    Cloth& cloth = simulation.cloth();
    if (cloth.substep != usual_substep_) set_substep(cloth, usual_substep_);
}

void DrapeRun::relax_frame(Simulation& simulation, const Collider& body) {
    Schedule schedule = on_body(relaxing());
    schedule.may_split = relaxed_ >= options_.coarse_time;
    adapt_once(simulation, body, schedule);
    update_contacts_between_frames(simulation, body, schedule);
    run_steps(simulation, body, schedule);
    relaxed_ += frame_seconds(simulation, schedule);
}

// The garment is lowered rather than dropped: the jerk of a wide skirt pulls its waistband down the hips and stretches
// it, and friction keeps it there.
void DrapeRun::fall_frame(Simulation& simulation, const Collider& body) {
    const float elapsed = static_cast<float>(result_.simulated_seconds - phase_start_);
    const bool is_lowered = relaxed_ == 0 || lowered_ >= options_.lowering_time;
    Schedule schedule = on_body(falling(is_lowered ? 1.0F : static_cast<float>(lowered_ / options_.lowering_time)));
    schedule.may_rest = options_.may_rest;
    schedule.damping += options_.damping_growth * elapsed;
    // The update rates of the biases decrease as the garment comes to rest; otherwise they would keep it moving.
    schedule.bias_rate = bias_rate_;
    schedule.may_rejoin = may_rejoin_;
    if (!options_.may_rest || !is_at_rest(simulation.cloth())) {
        if (may_rejoin_ || frames_ % kCalmInterval == 0) adapt_once(simulation, body, schedule);
        update_contacts_between_frames(simulation, body, schedule);
    }
    ++frames_;
    run_steps(simulation, body, schedule);
    may_rejoin_ = result_.rms_speed >= options_.calm_speed;
    bias_rate_ = std::min(1.0F, result_.rms_speed / options_.calm_speed);
    const bool rests = is_lowered && lowered_floor_ <= 0 && result_.rms_speed < options_.rest_speed;
    at_rest_ = rests ? at_rest_ + rest_weight() * frame_seconds(simulation, schedule) : 0;
    lowered_ += frame_seconds(simulation, schedule);
    const double end = options_.max_seconds - options_.finish_time;
    fraction_ = std::max({fraction_, result_.simulated_seconds / end, at_rest_ / options_.rest_time});
}

// What moves slower need not be watched for as long, to be as sure that it will not go far.
double DrapeRun::rest_weight() const {
    const double most = options_.rest_time / options_.least_rest_time;
    return std::min(most,
                    static_cast<double>(options_.rest_speed) / std::max(1e-9, static_cast<double>(result_.rms_speed)));
}

// Single triangles where much cloth meets, as under an arm, stay stretched by up to 20 % however long the fall lasts:
// one solver iteration per sub-step cannot move what many other constraints hold. Finer sub-steps leave 10 %. They go
// on while they lessen what is beyond the fabric's strain limit; what is then beyond it is projected. The cloth is
// stiffer in finer sub-steps, which sets it in motion: nobody waits for that to end.
void DrapeRun::finish_frame(Simulation& simulation, const Collider& body) {
    const Schedule schedule = last(simulation);
    update_contacts_between_frames(simulation, body, schedule);
    const std::size_t usual_steps = result_.step_ms.size();
    run_steps(simulation, body, schedule);
    result_.step_ms.resize(usual_steps);  // the statistics cover steps of usual length only
    constexpr double kWorthwhile = 0.1;   // of the excess: a frame that takes away less costs more than the projection
    const double before = std::exchange(excess_, total_excess(simulation.cloth()));
    // Nothing left: another frame cannot lessen it. Nor can it what is stretched by a body that is too large.
    const bool is_for_nothing = excess_ <= 0 || result_.given_up == GiveUp::TooSmall;
    lessens_ = !is_for_nothing && before - excess_ > kWorthwhile * before;
    if (finishes() || result_.bad_vertex) return;
    project_out(simulation, body, schedule);
}

double DrapeRun::half_frame() const {
    return static_cast<double>(usual_substep_) * Schedule{}.substeps * options_.steps_per_adaptation / 2;
}

// Call it between adaptations and steps.
void DrapeRun::update_contacts_between_frames(Simulation& simulation, const Collider& body, const Schedule& schedule) {
    const double seconds = frame_seconds(simulation, schedule);
    update_standoffs(simulation.cloth(), body, standoffs(simulation, seconds));
    watch_faces_near_thin_parts(simulation.cloth(), body, static_cast<float>(seconds));
}

bool DrapeRun::finishes() const {
    const double elapsed = result_.simulated_seconds - phase_start_;
    return elapsed < 3 * options_.finish_time && lessens_;
}

void DrapeRun::adapt_once(Simulation& simulation, const Collider& body, const Schedule& schedule) {
    const auto start = Clock::now();
    const AdaptReport adapted = simulation.adapt(body, schedule);
    result_.adaptation_ms.push_back(ms_since(start));
    result_.splits += adapted.splits;
    result_.rejoins += adapted.rejoins;
    result_.transitions += adapted.transitions;
}

void DrapeRun::run_steps(Simulation& simulation, const Collider& body, Schedule schedule) {
    const Cloth& cloth = simulation.cloth();
    const std::vector<Vec4f> before = cloth.x;
    WorkCount counted(cloth);
    for (int i = 0; i < options_.steps_per_adaptation; ++i) {
        const auto start = Clock::now();
        raise_floor(simulation, schedule);
        simulation.step(body, schedule);
        result_.step_ms.push_back(ms_since(start));
        result_.simulated_seconds += simulation.step_seconds(schedule);
    }
    result_.work += counted.of_steps(cloth, options_.steps_per_adaptation);
    result_.rms_speed = rms_speed(cloth, before, frame_seconds(simulation, schedule));
    result_.bad_vertex = find_bad_vertex(cloth);
}

// Hems that hang below the floor when the drape begins are taken along by it.
void DrapeRun::raise_floor(const Simulation& simulation, Schedule& schedule) {
    schedule.floor_rise = std::min(lowered_floor_, kFloorSpeed * simulation.step_seconds(schedule));
    lowered_floor_ -= schedule.floor_rise;
    schedule.lowered_floor = lowered_floor_;
}

Schedule DrapeRun::on_body(Schedule schedule) const {
    schedule.lowered_floor = lowered_floor_;
    schedule.offset = options_.rest_offset;
    return schedule;
}

// The mesh stays as it is in the final phase, so edges cannot be split where they dip into the body: they have samples
// where the adaptation would put vertices.
Schedule DrapeRun::last(const Simulation& simulation) const {
    const int parts = static_cast<int>(std::lround(usual_substep_ / simulation.cloth().substep));
    Schedule schedule = on_body(finishing(Schedule{}.substeps * parts));
    schedule.sample_spacing = simulation.options().adapt.shortest_edge / 2;
    return schedule;
}

// Cloth that does not touch the body is kept off it as far as while it was sewn. Where it touches, it comes nearer:
// else that distance would add 2 pi times its size to every girth of the body.
StandoffOptions DrapeRun::standoffs(const Simulation& simulation, double seconds) const {
    const float near = simulation.contact(on_body({})).offset;
    return {.free = std::min(kMaxStandoff, simulation.options().contact.offset - near),
            .lowering = options_.offset_speed * static_cast<float>(seconds)};
}

double DrapeRun::frame_seconds(const Simulation& simulation, const Schedule& schedule) const {
    return static_cast<double>(simulation.step_seconds(schedule)) * options_.steps_per_adaptation;
}

}  // namespace selvedge::sim
