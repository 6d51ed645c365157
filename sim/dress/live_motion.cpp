#include "sim/dress/live_motion.h"

#include <algorithm>
#include <utility>

#include "sim/dress/animation.h"

namespace selvedge::sim {
namespace {

// A viewer waits for each frame, and cloth that then hangs evens out its stretch.
MotionOptions live_options(const DressOptions& options) {
    MotionOptions live = motion_options(options);
    live.substeps = StepOptions{}.substeps;
    return live;
}

}  // namespace

LiveMotion::LiveMotion(const Cloth& dressed, std::vector<VertexId> kept, const BodyMover& mover,
                       const DressOptions& options)
    : body_(mover.shared_body()),
      cloth_(dressed),
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
    run_.emplace(cloth_, *body_, body_at, live_options(options));
    set_options(options);
}

void LiveMotion::set_options(const DressOptions& options) {
    run_->options() = live_options(options);
    run_->options().adapt.budget = set_budget(budget_, options.triangle_budget);
    run_->options().adapt.kept_vertices = kept_;
    run_->options().adapt.visibility = visibility_;
    wake();
}

void LiveMotion::set_visibility(Visibility* visibility) {
    visibility_ = visibility;
    run_->options().adapt.visibility = visibility_;
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
    const MotionFrame frame = run_->advance_to(cloth_, start_ + kLiveFrameSeconds);
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
    for (const VertexId v : kept_) x.emplace_back(cloth_.x[v.value].head<3>());
    return x;
}

}  // namespace selvedge::sim
