#include "sim/dress/drape.h"

#include <algorithm>
#include <chrono>

namespace selvedge {
namespace {

constexpr float kRelaxDamping = 12;  // 1/s, while the seams' tension goes
constexpr float kFallDamping = 2;    // 1/s, of the air

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

float step_seconds(const Cloth& cloth, const StepOptions& stepping) {
    return cloth.substep * static_cast<float>(stepping.substeps);
}

// Steps the level-0 cloth for a while. False when a number went bad.
bool run_coarse(Cloth& cloth, const BodyCollider& body, const StepOptions& stepping, double seconds,
                DrapeResult& result) {
    for (double t = 0; t < seconds; t += step_seconds(cloth, stepping)) {
        step(cloth, body, stepping);
        result.simulated_seconds += step_seconds(cloth, stepping);
    }
    result.bad_vertex = find_bad_vertex(cloth);
    return !result.bad_vertex;
}

void adapt_once(Cloth& cloth, const BodyCollider& body, const DrapeOptions& options, DrapeResult& result) {
    const auto start = Clock::now();
    const AdaptReport adapted = adapt_cloth(cloth, body, options.adapt, options.contact);
    result.adaption_ms.push_back(ms_since(start));
    result.splits += adapted.splits;
    result.rejoins += adapted.rejoins;
    result.transitions += adapted.transitions;
}

void step_once(Cloth& cloth, const BodyCollider& body, const StepOptions& stepping, DrapeResult& result) {
    const auto start = Clock::now();
    step(cloth, body, stepping);
    result.step_ms.push_back(ms_since(start));
    result.simulated_seconds += step_seconds(cloth, stepping);
}

// Adapts and steps until the garment has been at rest for long enough, or time is up, or a number went bad.
void run_adaptive(Cloth& cloth, const BodyCollider& body, StepOptions stepping, DrapeOptions options,
                  DrapeResult& result, const Progress& progress) {
    const double start = result.simulated_seconds;
    double at_rest = 0;
    while (result.simulated_seconds < options.max_seconds) {
        adapt_once(cloth, body, options, result);
        const float elapsed = static_cast<float>(result.simulated_seconds - start);
        stepping.extra_damping = kFallDamping + options.damping_growth * elapsed;
        const std::vector<Vec4f> before = cloth.x;
        for (int i = 0; i < options.steps_per_adaption; ++i) step_once(cloth, body, stepping, result);
        result.bad_vertex = find_bad_vertex(cloth);
        if (result.bad_vertex) return;
        const double frame = double(step_seconds(cloth, stepping)) * options.steps_per_adaption;
        result.rms_speed = rms_speed(cloth, before, frame);
        options.adapt.keeps_split = result.rms_speed < options.calm_speed;
        at_rest = result.rms_speed < options.rest_speed ? at_rest + frame : 0;
        report(progress, "draping",
               std::max(result.simulated_seconds / options.max_seconds, at_rest / options.rest_time));
        if (at_rest >= options.rest_time) {
            result.settled = true;
            return;
        }
    }
}

}  // namespace

DrapeResult drape(Cloth& cloth, const BodyCollider& body, const DrapeOptions& options, const Progress& progress) {
    DrapeResult result;
    StepOptions stepping{.gravity = Vec3f::Zero(), .extra_damping = kRelaxDamping, .contact = options.contact};
    stepping.contact.friction_scale = 0;
    refresh_contacts(cloth, options.contact);
    bool is_sound = run_coarse(cloth, body, stepping, options.relax_time, result);

    stepping = {.extra_damping = kFallDamping, .contact = options.contact};
    if (is_sound) is_sound = run_coarse(cloth, body, stepping, options.fall_time, result);
    if (is_sound) run_adaptive(cloth, body, stepping, options, result, progress);
    report(progress, "draping", 1);
    result.stopped_because = result.bad_vertex ? "bad number" : result.settled ? "settled" : "time limit";
    return result;
}

}  // namespace selvedge
