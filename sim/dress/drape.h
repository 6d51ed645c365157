#pragma once
// Drapes a sewn garment: relaxes it, lets it fall and adapt under gravity until it is at rest, and removes residual
// stretch.
#include <optional>
#include <string>
#include <vector>

#include "sim/cloth/standoff.h"
#include "sim/dress/dress_options.h"
#include "sim/simulation/simulation.h"

namespace selvedge::sim {

struct DrapeOptions {
    double max_seconds = 12;  // of simulated time
    int steps_per_adaptation = 4;
    float calm_speed = 0.05F;          // m/s, mass-weighted rms: below it edges do not rejoin
    float damping_growth = 4;          // 1/s per simulated second of the fall, so that it comes to rest
    float rest_speed = 0.01F;          // m/s, mass-weighted rms: below it the garment is at rest
    double rest_time = 1.0;            // s for which it must stay at rest at just below that speed ...
    double least_rest_time = 0.2;      // s ... and the slower, the shorter, down to this
    double relax_time = 0.6;           // s without gravity and friction, at the start
    double coarse_time = 0.2;          // s of relax_time at level 0
    double lowering_time = 1;          // s after relax_time, if any, in which gravity grows to its full value
    double finish_time = kFinishTime;  // s of max_seconds, kept for finer sub-steps at the end, to half a frame;
                                       // they may take up to 3 x as long
    bool may_rest = false;             // whether steps skip a cloth at rest during the fall (sim/cloth/resting.h)
    float rest_offset = kRestOffset;   // m, contact offset of cloth that touches the body; others keep the usual one
    float offset_speed = 0.0054F;      // m/s at which cloth that touches comes nearer: within relax_time, about half of
                                       // rest_speed
    std::optional<double> most_work{};  // DrapeResult::work, above which it is to be given up; none: see most_work()
};

// Why the rest of a garment is not waited for.
enum class GiveUp {
    TooSmall,    // it would crumple and stretch without coming to rest
    SlipsDown,   // it would fall to the floor
    TooMuchWork  // it takes more work than a drape may, and is not at rest
};

struct DrapeResult {
    bool settled = false;
    std::optional<GiveUp> given_up{};  // by give_up()
    std::optional<VertexId> bad_vertex;
    float rms_speed = 0;                // m/s, in the last frame
    double work = 0;                    // of all steps: see WorkCount
    std::optional<VertexId> fastest{};  // at the end of the fall, if the cloth moved
    float fall_speed = 0;  // m/s, rms in the last frame before the finer sub-steps at the end, which set it in motion
    double simulated_seconds = 0;
    long splits = 0;
    long rejoins = 0;
    long transitions = 0;
    std::vector<double> adaptation_ms;  // wall time, one per adaptation
    std::vector<double> step_ms;        // wall time, one per step; without those of the final phase

    // "settled", "too small", "slips down", "work limit", "time limit" or "bad number".
    std::string stopped_because() const;
};

// The most work (DrapeResult::work) of a drape that somebody waits for. What is not at rest by then, as a heap of
// cloth, does not come to rest soon. Counted, not timed, so that it ends alike for any number of
// threads on one type of CPU.
double most_work(const Cloth& cloth);

enum class DrapePhase {
    Relax,   // without gravity and friction, to relieve the tension of the seams
    Fall,    // under gravity, which grows at first, until at rest for rest_time
    Finish,  // finer sub-steps remove residual stretch
    Done
};

// A drape in progress. Each advance() computes one frame: one adaptation and its steps. All calls must pass the same
// simulation.
class DrapeRun {
 public:
    // Recomputes the cloth's contact data. Pre: the cloth is sewn.
    DrapeRun(Simulation& simulation, const DrapeOptions& options);

    // Returns false when the drape is done. Pre: phase() is not Done.
    bool advance(Simulation& simulation, const Collider& body);

    // Restarts the fall from the current state. No effect in phase Relax or after a bad number.
    void reactivate(Simulation& simulation);

    // Goes on to the end of the fall. Pre: phase() is Relax or Fall.
    void give_up(Simulation& simulation, GiveUp why);
    bool takes_too_much_work(const Cloth& cloth) const;
    bool falls() const { return phase_ == DrapePhase::Fall; }
    bool hangs() const;         // falls with its full weight
    bool hangs_calmly() const;  // and speeds are low: what the cloth shows now, it will show later

    DrapePhase phase() const { return phase_; }
    double fraction() const { return fraction_; }
    const DrapeResult& result() const { return result_; }

    // May be changed between frames.
    DrapeOptions& options() { return options_; }

    // Clears the timings in the result, which would otherwise grow without limit in an endless drape.
    void clear_times();

 private:
    void relax_frame(Simulation& simulation, const Collider& body);
    void fall_frame(Simulation& simulation, const Collider& body);
    void finish_frame(Simulation& simulation, const Collider& body);
    void change_phase(Simulation& simulation);  // when the current phase is over
    void begin_fall();
    void end_fall(Simulation& simulation);
    void end(Simulation& simulation);
    bool finishes() const;
    double rest_weight() const;
    double half_frame() const;  // s
    Schedule on_body(Schedule schedule) const;
    Schedule last(const Simulation& simulation) const;
    void update_contacts_between_frames(Simulation& simulation, const Collider& body, const Schedule& schedule);
    void adapt_once(Simulation& simulation, const Collider& body, const Schedule& schedule);
    void raise_floor(const Simulation& simulation, Schedule& schedule);
    void run_steps(Simulation& simulation, const Collider& body, Schedule schedule);
    StandoffOptions standoffs(const Simulation& simulation, double seconds) const;
    double frame_seconds(const Simulation& simulation, const Schedule& schedule) const;

    DrapeOptions options_;
    DrapeResult result_;
    DrapePhase phase_ = DrapePhase::Relax;
    double relaxed_ = 0;       // s
    double lowered_ = 0;       // s, of the fall
    double phase_start_ = 0;   // s, of simulated time
    int frames_ = 0;           // of phase Fall, of all falls
    double at_rest_ = 0;       // s, weighted
    double fraction_ = 0;      // 0..1
    bool may_rejoin_ = true;   // it still moves fast enough
    float bias_rate_ = 1;      // share of the usual update rates of the biases of stretch and shear
    double excess_ = 0;        // total_excess() at the end of the last frame, in phase Finish
    bool lessens_ = false;     // that frame has lessened it
    float lowered_floor_ = 0;  // m, by which the floor is lower than it will be
    float usual_substep_ = 0;  // s
};

}  // namespace selvedge::sim
