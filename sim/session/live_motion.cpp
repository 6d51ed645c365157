#include "sim/session/live_motion.h"

#include <algorithm>
#include <utility>

namespace selvedge::sim {
namespace {

// A viewer waits for each frame, and cloth that then hangs evens out its stretch.
MotionOptions live_options() {
    return {.substeps = Schedule{}.substeps};
}

}  // namespace

LiveMotion::LiveMotion(const Simulation& dressed, std::vector<VertexId> kept, const BodyMover& mover,
                       const DressOptions& options)
    : body_(mover.shared_body()),
      simulation_(dressed),
      kept_(std::move(kept)),
      flesh_(*body_),
      from_(mover.pose()),
      to_(mover.pose()) {
    const auto body_at = [this](double seconds, const Region& region, std::vector<Vec3f>& x) {
        const auto pose_at = [this](double at) {
            return blend(from_, to_, std::clamp((at - start_) / kLiveFrameSeconds, 0.0, 1.0));
        };
        flesh_.positions(*body_, pose_at, seconds, region, x);
    };
    simulation_.keep(kept_);
    run_.emplace(simulation_, *body_, body_at, live_options());
    kept_place_.emplace(cloth(), *body_, collider().surface());
    set_options(options);
}

void LiveMotion::set_options(const DressOptions& options) {
    simulation_.set_options(simulation_options(options));
    wake();
}

void LiveMotion::set_visibility(Visibility* visibility) {
    simulation_.set_visibility(visibility);
    wake();
}

MotionFrame LiveMotion::advance(BodyMover& mover) {
    const bool stands = mover.has_arrived();
    from_ = std::move(to_);
    mover.advance(kLiveFrameSeconds);
    to_ = mover.pose();
    start_ = run_->seconds();
    // Under a body that stands, air drag grows as it does while a garment falls, so that the cloth comes to rest.
    const DrapeOptions falling;
    body_still_seconds_ = stands ? body_still_seconds_ + kLiveFrameSeconds : 0;
    run_->options().air_damping =
        MotionOptions{}.air_damping + falling.damping_growth * static_cast<float>(body_still_seconds_);
    const MotionFrame frame = run_->advance_to(simulation_, start_ + kLiveFrameSeconds);
    if (!frame.has_bad_number) kept_place_->note(cloth(), collider().surface(), run_->seconds());
    rms_speed_ = frame.rms_speed;
    still_seconds_ = stands && rms_speed_ < falling.rest_speed ? still_seconds_ + kLiveFrameSeconds : 0;
    return frame;
}

Body LiveMotion::standing_body() const {
    Body body;
    for (const Vec3f& x : body_positions()) body.x.emplace_back(x.cast<double>());
    body.triangles = body_->triangles;
    return body;
}

std::vector<Vec3f> LiveMotion::pins() const {
    std::vector<Vec3f> x;
    for (const VertexId v : kept_) x.emplace_back(cloth().x[v.value].head<3>());
    return x;
}

}  // namespace selvedge::sim
