#include "sim/dress/drape.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace selvedge {
namespace {

constexpr float kRelaxDamping = 12;   // 1/s, while the seams' tension goes
constexpr float kFinishDamping = 40;  // 1/s, while the last of the stretch goes
constexpr float kFallDamping = 2;     // 1/s, of the air

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double frame_seconds(const Cloth& cloth, const StepOptions& stepping, const DrapeOptions& options) {
    return static_cast<double>(step_seconds(cloth, stepping)) * options.steps_per_adaption;
}

void adapt_once(Cloth& cloth, const Collider& body, const DrapeOptions& options, DrapeResult& result) {
    const auto start = Clock::now();
    const AdaptReport adapted = adapt_cloth(cloth, body, options.adapt, options.contact);
    result.adaption_ms.push_back(ms_since(start));
    result.splits += adapted.splits;
    result.rejoins += adapted.rejoins;
    result.transitions += adapted.transitions;
}

void step_once(Cloth& cloth, const Collider& body, const StepOptions& stepping, DrapeResult& result) {
    const auto start = Clock::now();
    step(cloth, body, stepping);
    result.step_ms.push_back(ms_since(start));
    result.simulated_seconds += step_seconds(cloth, stepping);
}

// False when a number went bad.
bool run_steps(Cloth& cloth, const Collider& body, const StepOptions& stepping, const DrapeOptions& options,
               DrapeResult& result) {
    const std::vector<Vec4f> before = cloth.x;
    for (int i = 0; i < options.steps_per_adaption; ++i) step_once(cloth, body, stepping, result);
    result.rms_speed = rms_speed(cloth, before, frame_seconds(cloth, stepping, options));
    result.bad_vertex = find_bad_vertex(cloth);
    return !result.bad_vertex;
}

// One adaption and its steps. False when a number went bad.
bool run_frame(Cloth& cloth, const Collider& body, const StepOptions& stepping, const DrapeOptions& options,
               DrapeResult& result) {
    adapt_once(cloth, body, options, result);
    return run_steps(cloth, body, stepping, options, result);
}

// Without gravity and friction the tension of the seams goes, and what was crumpled in sewing slides flat.
bool relax(Cloth& cloth, const Collider& body, const DrapeOptions& options, DrapeResult& result) {
    StepOptions stepping{.gravity = Vec3f::Zero(), .extra_damping = kRelaxDamping, .contact = options.contact};
    stepping.contact.friction_scale = 0;
    DrapeOptions coarse = options;
    coarse.adapt.shortest_edge = std::numeric_limits<float>::max();
    const double seconds = std::min(options.relax_time, options.max_seconds);
    for (double t = 0; t < seconds; t += frame_seconds(cloth, stepping, options)) {
        const bool is_coarse = t < options.coarse_time;
        if (!run_frame(cloth, body, stepping, is_coarse ? coarse : options, result)) return false;
    }
    return true;
}

// Until the garment has been at rest for long enough, or time is up, or a number went bad.
void fall(Cloth& cloth, const Collider& body, DrapeOptions options, DrapeResult& result, const Progress& progress) {
    StepOptions stepping{.contact = options.contact};
    const double start = result.simulated_seconds;
    double at_rest = 0;
    double fraction = 0;
    const double end = options.max_seconds - options.finish_time;
    while (result.simulated_seconds < end && at_rest < options.rest_time) {
        const float elapsed = static_cast<float>(result.simulated_seconds - start);
        stepping.extra_damping = kFallDamping + options.damping_growth * elapsed;
        if (!run_frame(cloth, body, stepping, options, result)) return;
        options.adapt.may_rejoin = result.rms_speed >= options.calm_speed;
        // Biases ever slower as the garment comes to rest, or they would keep it awake.
        const float briskness = std::min(1.0F, result.rms_speed / options.calm_speed);
        stepping.stretch_bias_rate = StepOptions{}.stretch_bias_rate * briskness;
        stepping.shear_bias_rate = StepOptions{}.shear_bias_rate * briskness;
        at_rest = result.rms_speed < options.rest_speed ? at_rest + frame_seconds(cloth, stepping, options) : 0;
        fraction = std::max({fraction, result.simulated_seconds / end, at_rest / options.rest_time});
        report(progress, "draping", std::min(1.0, fraction));
    }
    result.settled = at_rest >= options.rest_time;
}

// How many sub-steps take the place of one at the end: the more, the finer the cloth may be.
int finishing_substeps(float shortest_edge) {
    constexpr float kOnce = 0.08F;  // m, edges for which one would do
    return static_cast<int>(std::lround(std::clamp(kOnce / std::max(shortest_edge, 0.001F), 4.0F, 16.0F)));
}

// Single triangles where much cloth meets, as under an arm, stay stretched by up to 20 % however long they are left:
// one visit per sub-step cannot move what so many others hold. Finer sub-steps leave 10 %. What that sets in motion
// gets some time to come to rest again.
void finish(Cloth& cloth, const Collider& body, const DrapeOptions& options, DrapeResult& result) {
    const int finer = finishing_substeps(options.adapt.shortest_edge);
    StepOptions stepping{.extra_damping = kFinishDamping, .contact = options.contact};
    stepping.stretch_bias_rate = stepping.shear_bias_rate = stepping.bend_bias_rate = 0;  // they would wake it
    const float usual = cloth.substep;
    stepping.substeps *= finer;
    set_substep(cloth, usual / static_cast<float>(finer));
    const std::size_t usual_steps = result.step_ms.size();
    const double start = result.simulated_seconds;
    const auto elapsed = [&] { return result.simulated_seconds - start; };
    while (elapsed() < options.finish_time ||
           (result.rms_speed > options.rest_speed && elapsed() < 3 * options.finish_time)) {
        if (!run_steps(cloth, body, stepping, options, result)) break;
    }
    set_substep(cloth, usual);
    result.step_ms.resize(usual_steps);  // the figure is of usual ones
}

}  // namespace

DrapeResult drape(Cloth& cloth, const Collider& body, const DrapeOptions& options, const Progress& progress) {
    DrapeResult result;
    report(progress, "draping", 0);
    refresh_contacts(cloth, options.contact);
    result.bad_vertex = find_bad_vertex(cloth);
    if (!result.bad_vertex && relax(cloth, body, options, result)) fall(cloth, body, options, result, progress);
    result.stopped_because = result.settled ? "settled" : "time limit";
    const bool has_time =
        options.finish_time > 0 && result.simulated_seconds + options.finish_time <= options.max_seconds + 1e-6;
    if (!result.bad_vertex && has_time) finish(cloth, body, options, result);
    if (result.bad_vertex) result.stopped_because = "bad number";
    report(progress, "draping", 1);
    return result;
}

}  // namespace selvedge
