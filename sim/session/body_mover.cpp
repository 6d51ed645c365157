#include "sim/session/body_mover.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/assert.h"
#include "sim/motion/grounding.h"

namespace selvedge::sim {
namespace {

constexpr double kArrived = 1e-4;     // m, between two poses that count as one
constexpr double kShortBlend = 0.25;  // s, back into a motion that was left by seeking

constexpr double kSteepest = 1.5;  // slope of smoothstep(), by which a blend eases in and out

}  // namespace

double distance_between(const Body& body, const Pose& a, const Pose& b) {
    constexpr double kHand = 0.15;  // m, the lever by which a turn counts as a way
    const std::vector<Eigen::Affine3d> from = bone_frames(body, a), to = bone_frames(body, b);
    double farthest = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double way = (from[i].translation() - to[i].translation()).norm();
        const double turn = a.bones[i].rotation.angularDistance(b.bones[i].rotation);
        farthest = std::max(farthest, way + kHand * turn);
    }
    return farthest;
}

BodyMover::BodyMover(std::shared_ptr<const Body> body, const MoverOptions& options)
    : BodyMover(body, rest_pose(*body), options) {}

BodyMover::BodyMover(std::shared_ptr<const Body> body, Pose start, const MoverOptions& options)
    : body_(std::move(body)), options_(options), start_(std::move(start)), now_(start_), goal_pose_(start_) {
    SELVEDGE_ASSERT(!body_->bones.empty() && !body_->skin.empty());
}

// The way over the floor from the hips of that pose to those of the start pose, m.
Vec3d BodyMover::to_place(const Pose& pose) const {
    return way_over_floor(*body_, pose, start_);
}

Vec3d BodyMover::way() const {
    return -to_place(now_);
}

void BodyMover::set_goal_pose(const Pose& pose) {
    SELVEDGE_ASSERT(pose.bones.size() == body_->bones.size());
    goal_ = Goal::Pose;
    goal_pose_ = pose;
    shift(*body_, goal_pose_, to_place(pose));
    is_playing_ = false;
}

void BodyMover::go_to(const Pose& pose) {
    set_goal_pose(pose);
    begin_blend(options_.blend_seconds);
}

void BodyMover::follow(const Pose& pose) {
    set_goal_pose(pose);
    blend_.reset();
    if (!has_arrived()) is_at_start_pose_ = false;
}

void BodyMover::set_clip(std::shared_ptr<const Clip> clip) {
    if (goal_ == Goal::Motion) {  // stays where it is
        goal_ = Goal::Pose;
        goal_pose_ = now_;
        blend_.reset();
    }
    is_playing_ = false;
    playhead_ = 0;
    clip_ = std::move(clip);
    if (clip_) clip_shift_ = to_place(sample(*body_, *clip_, 0));
}

double BodyMover::cycle_start() const {
    if (!clip_ || !clip_->is_loop || clip_->seconds <= 0) return 0;
    return clip_->seconds * std::floor(playhead_ / clip_->seconds);
}

double BodyMover::time() const {
    return playhead_ - cycle_start();
}

void BodyMover::play() {
    if (!clip_ || is_playing_) return;
    if (!clip_->is_loop && playhead_ >= clip_->seconds) playhead_ = 0;
    const double least = goal_ == Goal::Motion ? kShortBlend : options_.blend_seconds;
    goal_ = Goal::Motion;
    is_playing_ = true;
    begin_blend(least);
}

void BodyMover::pause() {
    if (!is_playing_) return;
    is_playing_ = false;
    if (!blend_) return;
    blend_.reset();  // on its way into the motion: it stays there
    goal_ = Goal::Pose;
    goal_pose_ = now_;
}

void BodyMover::seek(double time) {
    if (!clip_ || !std::isfinite(time)) return;
    constexpr double kWithin = 1 - 1e-9;  // the end of a cycle is the start of the next
    playhead_ = cycle_start() + std::clamp(time, 0.0, clip_->seconds * (clip_->is_loop ? kWithin : 1.0));
    goal_ = Goal::Motion;
    is_playing_ = false;
    blend_.reset();
    is_at_start_pose_ = false;
}

void BodyMover::stand_at_start() {
    const bool has_goal = goal_ == Goal::Motion || distance_between(*body_, start_, goal_pose_) > kArrived;
    now_ = start_;
    chase_speed_ = 0;
    blend_.reset();
    playhead_ = time();
    is_at_start_pose_ = !has_goal;
    if (has_goal) begin_blend(options_.blend_seconds);
}

void BodyMover::back_to_start() {
    now_ = goal_pose_ = start_;
    goal_ = Goal::Pose;
    is_playing_ = false;
    playhead_ = chase_speed_ = 0;
    blend_.reset();
    is_at_start_pose_ = true;
}

Pose BodyMover::target() const {
    if (goal_ == Goal::Pose) return goal_pose_;
    Pose pose = sample(*body_, *clip_, playhead_);
    shift(*body_, pose, clip_shift_);
    return pose;
}

// The pose eases over, so that no joint exceeds the greatest speed. Nothing to do if it is there already.
void BodyMover::begin_blend(double least_seconds) {
    const double way = distance_between(*body_, now_, target());
    blend_.reset();
    chase_speed_ = 0;
    if (way <= kArrived) return;
    is_at_start_pose_ = false;
    blend_ = Blend{.from = now_, .seconds = std::max(least_seconds, kSteepest * way / options_.max_speed)};
}

bool BodyMover::has_arrived() const {
    return !is_playing_ && !blend_ && distance_between(*body_, now_, target()) <= kArrived;
}

void BodyMover::advance_playhead(double seconds) {
    const double cycle = cycle_start();
    playhead_ += playback_.speed * seconds;
    const double end = cycle + clip_->seconds;
    if (playhead_ < end || (clip_->is_loop && playback_.is_loop)) return;
    if (!playback_.is_loop || clip_->seconds <= 0) {
        playhead_ = end;
        is_playing_ = false;
    } else {
        playhead_ = 0;  // a motion that does not end where it begins goes back there
        now_ = sample(*body_, *clip_, clip_->seconds);
        shift(*body_, now_, clip_shift_);
        begin_blend(kShortBlend);
    }
}

// The body has arrived.
void BodyMover::note_arrival() {
    if (goal_ == Goal::Pose) is_at_start_pose_ = distance_between(*body_, start_, now_) <= kArrived;
}

// As fast as still allows it to stop there.
void BodyMover::chase(double seconds) {
    const Pose there = target();
    const double way = distance_between(*body_, now_, there), acceleration = options_.max_acceleration;
    chase_speed_ =
        std::min({options_.max_speed, chase_speed_ + acceleration * seconds, std::sqrt(2 * acceleration * way)});
    const double step = chase_speed_ * seconds;
    if (way <= std::max(kArrived, step)) {
        now_ = there;
        chase_speed_ = 0;
        note_arrival();
    } else {
        now_ = blend(now_, there, step / way);
    }
}

void BodyMover::advance(double seconds) {
    if (blend_) {
        blend_->elapsed += seconds;
        if (blend_->elapsed < blend_->seconds) {
            now_ = blend_on_floor(*body_, blend_->from, target(), smoothstep(blend_->elapsed, 0, blend_->seconds));
            return;
        }
        now_ = target();
        blend_.reset();
        note_arrival();
    } else if (is_playing_) {
        advance_playhead(seconds);
        if (!blend_) now_ = target();
    } else {
        chase(seconds);
    }
}

}  // namespace selvedge::sim
