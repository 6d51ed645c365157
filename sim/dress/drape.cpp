#include "sim/dress/drape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/cloth/solver_state.h"
#include "sim/cloth/standoff.h"
#include "sim/cloth/strain_projection.h"
#include "sim/core/assert.h"
#include "sim/core/stopwatch.h"

namespace selvedge::sim {
namespace {

constexpr float kFinishDamping = 100;  // 1/s, while residual stretch is removed
constexpr float kFallDamping = 2;      // 1/s, air drag
constexpr float kFloorSpeed = 0.2F;    // m/s: slow against falling cloth, so that it folds what it meets as a fall does

constexpr int kCalmInterval = 3;  // frames between adaptations of calm cloth, which moves 5 mm (rms) at most meanwhile

// Number of sub-steps that replace one in the final phase: more for a smaller minimum edge length.
int finishing_substeps(float shortest_edge) {
    constexpr float kOnce = 0.08F;  // m, edge length for which one would suffice
    return static_cast<int>(std::lround(std::clamp(kOnce / std::max(shortest_edge, 0.001F), 4.0F, 16.0F)));
}

}  // namespace

std::string DrapeResult::stopped_because() const {
    if (bad_vertex) return "bad number";
    if (given_up) return *given_up == GiveUp::TooSmall ? "too small" : "slips down";
    return settled ? "settled" : "time limit";
}

DrapeRun::DrapeRun(Cloth& cloth, const DrapeOptions& options) : options_(options), usual_substep_(cloth.substep) {
    refresh_contacts(cloth, options_.contact);
    free_standoffs(cloth, standoffs(0));
    result_.bad_vertex = find_bad_vertex(cloth);
    if (!result_.bad_vertex) lowered_floor_ = std::max(0.0F, options_.contact.floor - lowest_height(cloth));
    change_phase(cloth);
}

bool DrapeRun::advance(Cloth& cloth, const Collider& body) {
    if (phase_ == DrapePhase::Relax) {
        relax_frame(cloth, body);
    } else if (phase_ == DrapePhase::Fall) {
        fall_frame(cloth, body);
    } else {
        finish_frame(cloth, body);
    }
    change_phase(cloth);
    return phase_ != DrapePhase::Done;
}

void DrapeRun::reactivate(Cloth& cloth) {
    if (phase_ == DrapePhase::Relax || result_.bad_vertex) return;
    if (cloth.substep != usual_substep_) set_substep(cloth, usual_substep_);
    result_.settled = false;
    result_.given_up.reset();
    fraction_ = 0;
    begin_fall();
}

void DrapeRun::give_up(Cloth& cloth, GiveUp why) {
    SELVEDGE_ASSERT(phase_ == DrapePhase::Relax || phase_ == DrapePhase::Fall);
    result_.given_up = why;
    end_fall(cloth);
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

void DrapeRun::change_phase(Cloth& cloth) {
    if (result_.bad_vertex) return end(cloth);
    if (phase_ == DrapePhase::Relax && relaxed_ >= std::min(options_.relax_time, options_.max_seconds)) begin_fall();
    const bool has_time = result_.simulated_seconds + options_.finish_time < options_.max_seconds - half_frame();
    if (phase_ == DrapePhase::Fall && (!has_time || at_rest_ >= options_.rest_time)) end_fall(cloth);
    if (phase_ == DrapePhase::Finish && !finishes()) end(cloth);
}

void DrapeRun::begin_fall() {
    phase_ = DrapePhase::Fall;
    phase_start_ = result_.simulated_seconds;
    at_rest_ = 0;
    may_rejoin_ = options_.adapt.may_rejoin;
    learning_rate_scale_ = 1;
}

void DrapeRun::end_fall(Cloth& cloth) {
    result_.settled = at_rest_ >= options_.rest_time;
    result_.fall_speed = result_.rms_speed;
    const bool has_time = options_.finish_time > 0 &&
                          result_.simulated_seconds + options_.finish_time <= options_.max_seconds + half_frame();
    if (!has_time) return end(cloth);
    phase_ = DrapePhase::Finish;
    phase_start_ = result_.simulated_seconds;
    excess_ = total_excess(cloth);
    lessens_ = true;  // as is to be seen
    refresh_contacts(cloth, finishing_contact());
    set_substep(cloth, usual_substep_ / static_cast<float>(finishing_substeps(options_.adapt.shortest_edge)));
}

void DrapeRun::end(Cloth& cloth) {
    phase_ = DrapePhase::Done;
    if (cloth.substep != usual_substep_) set_substep(cloth, usual_substep_);
}

// Without gravity and friction, seam tension relaxes and cloth that crumpled during sewing slides flat.
void DrapeRun::relax_frame(Cloth& cloth, const Collider& body) {
    StepOptions stepping{.gravity = Vec3f::Zero(), .extra_damping = kRelaxDamping, .contact = falling_contact()};
    AdaptClothOptions adapting = options_.adapt;
    if (relaxed_ < options_.coarse_time) adapting.shortest_edge = std::numeric_limits<float>::max();
    adapt_once(cloth, body, adapting);
    update_contacts_between_frames(cloth, body, stepping);
    stepping.contact.friction_scale = 0;
    run_steps(cloth, body, stepping);
    relaxed_ += frame_seconds(cloth, stepping);
}

// The garment is lowered rather than dropped: the jerk of a wide skirt pulls its waistband down the hips and stretches
// it, and friction keeps it there.
void DrapeRun::fall_frame(Cloth& cloth, const Collider& body) {
    const float elapsed = static_cast<float>(result_.simulated_seconds - phase_start_);
    StepOptions stepping{.gravity = options_.gravity, .contact = falling_contact(), .may_rest = options_.may_rest};
    const bool is_lowered = relaxed_ == 0 || lowered_ >= options_.lowering_time;
    if (!is_lowered) stepping.gravity *= static_cast<float>(lowered_ / options_.lowering_time);
    stepping.extra_damping = kFallDamping + options_.damping_growth * elapsed;
    // The update rates of the biases decrease as the garment comes to rest; otherwise they would keep it moving.
    stepping.stretch_bias_rate *= learning_rate_scale_;
    stepping.shear_bias_rate *= learning_rate_scale_;
    AdaptClothOptions adapting = options_.adapt;
    adapting.may_rejoin = may_rejoin_;
    if (!options_.may_rest || !is_at_rest(cloth)) {
        if (may_rejoin_ || frames_ % kCalmInterval == 0) adapt_once(cloth, body, adapting);
        update_contacts_between_frames(cloth, body, stepping);
    }
    ++frames_;
    run_steps(cloth, body, stepping);
    may_rejoin_ = result_.rms_speed >= options_.calm_speed;
    learning_rate_scale_ = std::min(1.0F, result_.rms_speed / options_.calm_speed);
    const bool rests = is_lowered && lowered_floor_ <= 0 && result_.rms_speed < options_.rest_speed;
    at_rest_ = rests ? at_rest_ + rest_weight() * frame_seconds(cloth, stepping) : 0;
    lowered_ += frame_seconds(cloth, stepping);
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
void DrapeRun::finish_frame(Cloth& cloth, const Collider& body) {
    StepOptions stepping{.gravity = options_.gravity, .extra_damping = kFinishDamping, .contact = finishing_contact()};
    stepping.stretch_bias_rate = stepping.shear_bias_rate = 0;  // updates would set it in motion
    stepping.substeps *= static_cast<int>(std::lround(usual_substep_ / cloth.substep));
    update_contacts_between_frames(cloth, body, stepping);
    const std::size_t usual_steps = result_.step_ms.size();
    run_steps(cloth, body, stepping);
    result_.step_ms.resize(usual_steps);  // the statistics cover steps of usual length only
    constexpr double kWorthwhile = 0.1;   // of the excess: a frame that takes away less costs more than the projection
    const double before = std::exchange(excess_, total_excess(cloth));
    lessens_ = excess_ > 0 && before - excess_ > kWorthwhile * before;  // nothing left: another frame cannot lessen it
    if (finishes() || result_.bad_vertex) return;
    stepping.self_contact = options_.self_contact;
    project(cloth, body, stepping);
}

double DrapeRun::half_frame() const {
    return static_cast<double>(usual_substep_) * StepOptions{}.substeps * options_.steps_per_adaptation / 2;
}

// Projects onto the strain limits and out of the body, until an exact test finds no face inside it.
void DrapeRun::project(Cloth& cloth, const Collider& body, const StepOptions& stepping) {
    constexpr float kDepth = 0.0004F;  // m: less than the depth that a report counts, FaultLimits::depth
    constexpr int kTests = 6;
    cloth.solver->contacts.faces.clear();
    project_strain(cloth, body, stepping);
    for (int test = 0; test < kTests && watch_faces_inside(cloth, body, kDepth) > 0; ++test)
        project_strain(cloth, body, stepping);
}

// Call it between adaptations and steps.
void DrapeRun::update_contacts_between_frames(Cloth& cloth, const Collider& body, const StepOptions& stepping) {
    const double seconds = frame_seconds(cloth, stepping);
    update_standoffs(cloth, body, standoffs(seconds));
    watch_faces_near_thin_parts(cloth, body, static_cast<float>(seconds));
}

bool DrapeRun::finishes() const {
    const double elapsed = result_.simulated_seconds - phase_start_;
    return elapsed < 3 * options_.finish_time && lessens_;
}

void DrapeRun::adapt_once(Cloth& cloth, const Collider& body, const AdaptClothOptions& adapting) {
    const auto start = Clock::now();
    const AdaptReport adapted = adapt_cloth(cloth, body, adapting, falling_contact());
    result_.adaptation_ms.push_back(ms_since(start));
    result_.splits += adapted.splits;
    result_.rejoins += adapted.rejoins;
    result_.transitions += adapted.transitions;
}

void DrapeRun::run_steps(Cloth& cloth, const Collider& body, StepOptions stepping) {
    const std::vector<Vec4f> before = cloth.x;
    stepping.self_contact = options_.self_contact;
    for (int i = 0; i < options_.steps_per_adaptation; ++i) {
        const auto start = Clock::now();
        if (options_.kinematic_vertices)
            stepping.kinematic = options_.kinematic_vertices(cloth, step_seconds(cloth, stepping));
        raise_floor(cloth, stepping);
        step(cloth, body, stepping);
        result_.step_ms.push_back(ms_since(start));
        result_.simulated_seconds += step_seconds(cloth, stepping);
    }
    result_.rms_speed = rms_speed(cloth, before, frame_seconds(cloth, stepping));
    result_.bad_vertex = find_bad_vertex(cloth);
}

// Hems that hang below the floor when the drape begins are taken along by it.
void DrapeRun::raise_floor(const Cloth& cloth, StepOptions& stepping) {
    const float rise = std::min(lowered_floor_, kFloorSpeed * step_seconds(cloth, stepping));
    lowered_floor_ -= rise;
    stepping.contact.floor = options_.contact.floor - lowered_floor_;
    stepping.floor_rate = rise / static_cast<float>(stepping.substeps);
}

ContactOptions DrapeRun::falling_contact() const {
    ContactOptions contact = options_.contact;
    contact.floor -= lowered_floor_;
    contact.offset = std::min(options_.rest_offset, options_.contact.offset);
    return contact;
}

// The mesh stays as it is in the final phase, so edges cannot be split where they dip into the body: they have samples
// where the adaptation would put vertices.
ContactOptions DrapeRun::finishing_contact() const {
    ContactOptions contact = falling_contact();
    contact.sample_spacing = std::min(contact.sample_spacing, options_.adapt.shortest_edge / 2);
    return contact;
}

// Cloth that does not touch the body is kept off it as far as while it was sewn. Where it touches, it comes nearer:
// else that distance would add 2 pi times its size to every girth of the body.
StandoffOptions DrapeRun::standoffs(double seconds) const {
    return {.free = std::min(kMaxStandoff, options_.contact.offset - falling_contact().offset),
            .lowering = options_.offset_speed * static_cast<float>(seconds)};
}

double DrapeRun::frame_seconds(const Cloth& cloth, const StepOptions& stepping) const {
    return static_cast<double>(step_seconds(cloth, stepping)) * options_.steps_per_adaptation;
}

}  // namespace selvedge::sim
