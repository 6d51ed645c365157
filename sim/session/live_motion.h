#pragma once
// A garment on a body that moves as its user asks, frame by frame: a copy of the cloth that was dressed, which stays as
// it is, so that the body can be put back into it. (thesis 5.3.5)
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/body/yielding_flesh.h"
#include "sim/dress/dressing.h"
#include "sim/dress/motion_run.h"
#include "sim/inspection/kept_place.h"
#include "sim/session/body_mover.h"
#include "sim/simulation/simulation.h"

namespace selvedge::sim {

inline constexpr double kLiveFrameSeconds = 1.0 / 30;  // one adaptation and its steps

class LiveMotion {
 public:
    // dressed: a sewn cloth that hangs on the body where the mover has it. kept: vertices that the user has pinned;
    // they move with the body.
    LiveMotion(const Simulation& dressed, std::vector<VertexId> kept, const BodyMover& mover,
               const DressOptions& options);
    LiveMotion(const LiveMotion&) = delete;
    LiveMotion& operator=(const LiveMotion&) = delete;

    void set_options(const DressOptions& options);
    void set_visibility(Visibility* visibility);  // as that of Dressing
    void wake() { body_still_seconds_ = still_seconds_ = 0; }

    // The body goes on by one frame, and the cloth with it. Between the poses at both ends, each step sees the body in
    // a blend of them.
    MotionFrame advance(BodyMover& mover);

    const Cloth& cloth() const { return simulation_.cloth(); }
    const MovingBodyCollider& collider() const { return run_->collider(); }
    std::span<const Vec3f> body_positions() const { return collider().surface().points(); }  // m, as Body::x
    Body standing_body() const;       // as it stands now: its surface only
    std::vector<Vec3f> pins() const;  // m
    double simulated_seconds() const { return run_->seconds(); }
    float rms_speed() const { return rms_speed_; }  // m/s, of the last frame
    // As KeptPlace::faults(), since the body began to move.
    std::vector<std::string> faults(std::span<const std::string> panels) const { return kept_place_->faults(panels); }
    // Whether the body stands still, and the cloth too, for DrapeOptions::rest_time.
    bool is_at_rest() const { return still_seconds_ >= rest_time_; }

 private:
    std::shared_ptr<const Body> body_;
    Simulation simulation_;
    std::vector<VertexId> kept_;
    MovingFlesh flesh_;
    Pose from_, to_;                       // of the body at the ends of the present frame
    double start_ = 0;                     // s, of the present frame
    std::optional<MotionRun> run_;         // never empty
    std::optional<KeptPlace> kept_place_;  // never empty
    float rms_speed_ = 0;
    double body_still_seconds_ = 0, still_seconds_ = 0;
    double rest_time_ = DrapeOptions{}.rest_time;
};

}  // namespace selvedge::sim
