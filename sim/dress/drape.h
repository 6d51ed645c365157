#pragma once
// Letting a sewn garment fall, adapt and settle.
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "sim/core/parallel.h"

namespace selvedge::sim {

struct DrapeOptions {
    double max_seconds = 12;  // of simulated time
    int steps_per_adaption = 4;
    float calm_speed = 0.05F;             // m/s rms over mass: below it no edge rejoins any more
    float damping_growth = 4;             // 1/s per second of the adaptive drape, so that it comes to rest
    float rest_speed = 0.01F;             // m/s rms over mass: below it the garment is at rest
    double rest_time = 1.0;               // s for which it must stay there
    double relax_time = 0.6;              // s without gravity and friction
    double coarse_time = 0.2;             // s of them at level 0
    double finish_time = 0.2;             // s of all in finer sub-steps, at the end; longer if it takes longer to rest
    Vec3f gravity = Vec3f(0, -9.81F, 0);  // m/s^2
    bool may_rest = false;                // in the fall: sim/cloth/resting.h
    AdaptClothOptions adapt{};
    ContactOptions contact{};

    // Asked before each step, when given: what is led by hand in the seconds that it takes.
    std::function<std::span<const KinematicVertex>(const Cloth&, float)> lead = {};
};

struct DrapeResult {
    bool settled = false;
    std::string stopped_because;
    std::optional<VertexId> bad_vertex;
    float rms_speed = 0;  // m/s at the end; `settled` is of before it was finished
    double simulated_seconds = 0;
    long splits = 0;
    long rejoins = 0;
    long transitions = 0;
    std::vector<double> adaptation_ms;  // wall time, one per adaptation
    std::vector<double> step_ms;        // wall time, one per step of the adaptive part
};

enum class DrapePhase {
    Relax,   // without gravity and friction the tension of the seams goes
    Fall,    // until it has been at rest for long enough
    Finish,  // finer sub-steps take the last of the stretch
    Done
};

// A drape under way: one frame, an adaptation and its steps, with each advance(). All calls take the same cloth.
class DrapeRun {
 public:
    // Makes the cloth's contacts anew. Pre: it is sewn.
    DrapeRun(Cloth& cloth, const DrapeOptions& options);

    // False once it is over. Pre: phase() is not Done.
    bool advance(Cloth& cloth, const Collider& body);

    // From any phase but Relax: it falls again, as if it had just begun to, and comes to rest anew.
    void wake(Cloth& cloth);

    DrapePhase phase() const { return phase_; }
    double fraction() const { return fraction_; }
    const DrapeResult& result() const { return result_; }

    // May change between frames; what they point to must live while the run does.
    DrapeOptions& options() { return options_; }

    // The result without its times, which would grow for ever in a drape that has no end.
    void forget_times();

 private:
    void relax_frame(Cloth& cloth, const Collider& body);
    void fall_frame(Cloth& cloth, const Collider& body);
    void finish_frame(Cloth& cloth, const Collider& body);
    void change_phase(Cloth& cloth);  // where the present one is over
    void begin_fall();
    void end_fall(Cloth& cloth);
    void end(Cloth& cloth);
    bool finishes() const;
    void adapt_once(Cloth& cloth, const Collider& body, const AdaptClothOptions& adapting);
    void run_steps(Cloth& cloth, const Collider& body, StepOptions stepping);
    double frame_seconds(const Cloth& cloth, const StepOptions& stepping) const;

    DrapeOptions options_;
    DrapeResult result_;
    DrapePhase phase_ = DrapePhase::Relax;
    double relaxed_ = 0;             // s
    double phase_start_ = 0;         // s, of simulated time
    double at_rest_ = 0;             // s
    double fraction_ = 0;            // 0..1
    bool may_rejoin_ = true;         // it still moves enough
    float learning_rate_scale_ = 1;  // of the biases
    float usual_substep_ = 0;        // s
};

DrapeResult drape(Cloth& cloth, const Collider& body, const DrapeOptions& options, const Progress& progress);

}  // namespace selvedge::sim
