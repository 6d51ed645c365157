#pragma once
// Where a body is while its user chooses poses, plays a motion and drags its time. The body always goes there along a
// way without jumps, so that cloth can follow.
//
//   go_to(pose)   present pose ----- blend_seconds, or longer for a long way -----> pose
//   play()        present pose ----- the same -----> the motion where it is, which then goes on
//   seek(t)       present pose ----- limited speed and acceleration -----> the motion at t, which may change meanwhile
//   follow(pose)  present pose ----- the same -----> pose, which may change meanwhile
#include <memory>
#include <optional>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/body/pose.h"

namespace selvedge::sim {

struct MoverOptions {
    double blend_seconds = 1.5;   // least time to another pose, and into a motion
    double max_speed = 2;         // m/s, of the joint that goes farthest, as a hand in quick work
    double max_acceleration = 8;  // m/s^2, while it seeks or follows
};

// How a motion is played.
struct Playback {
    double speed = 1;     // of the motion
    bool is_loop = true;  // false: stops at its end

    bool operator==(const Playback&) const = default;
};

// The greatest way of a joint between two poses, m. A turn of the last bone of a limb counts as that of a hand.
double distance_between(const Body& body, const Pose& a, const Pose& b);

class BodyMover {
 public:
    // Stands in its start pose, in which it is dressed: its rest pose unless another is given. Pre: the body has bones
    // and a skin.
    explicit BodyMover(std::shared_ptr<const Body> body, const MoverOptions& options = {});
    BodyMover(std::shared_ptr<const Body> body, Pose start, const MoverOptions& options = {});

    // Goes there and stops; its hips stay over their place on the floor.
    void go_to(const Pose& pose);
    // The same without easing in: for a pose that is called again and again while it changes.
    void follow(const Pose& pose);

    // The motion that play() and seek() refer to, from its start; none: null. The body stays where it is. The hips
    // begin over their place on the floor. Pre: it is a clip of the body.
    void set_clip(std::shared_ptr<const Clip> clip);
    void set_playback(const Playback& playback) { playback_ = playback; }
    void play();             // from where it is; at the end of a motion that is no loop, from its start
    void pause();            // stays where it is
    void seek(double time);  // s of the motion, within its length; of a loop, in the present cycle. Pauses.

    // Back to the start pose at once, for a body that is dressed anew: what it is to do stays, and is gone to from
    // there.
    void stand_at_start();
    // Back to the start pose at once, with nothing to do; the motion is at its start.
    void back_to_start();

    // Goes on by that time, s.
    void advance(double seconds);

    const Body& body() const { return *body_; }
    const std::shared_ptr<const Body>& shared_body() const { return body_; }
    const Pose& pose() const { return now_; }
    const std::shared_ptr<const Clip>& clip() const { return clip_; }
    const Playback& playback() const { return playback_; }
    bool is_playing() const { return is_playing_; }
    double time() const;  // s of the motion, 0 to its length
    bool is_in_motion() const { return goal_ == Goal::Motion; }
    bool is_at_start_pose() const { return is_at_start_pose_; }
    bool has_arrived() const;  // nothing moves until the next request
    Vec3d way() const;         // m over the floor, from where it stands in its start pose
    bool is_blending() const { return blend_.has_value(); }

 private:
    enum class Goal { Pose, Motion };
    struct Blend {
        Pose from;
        double elapsed = 0;
        double seconds = 0;
    };

    Pose target() const;
    Vec3d to_place(const Pose& pose) const;
    void set_goal_pose(const Pose& pose);
    void begin_blend(double least_seconds);
    void advance_playhead(double seconds);
    void chase(double seconds);
    void note_arrival();
    double cycle_start() const;

    std::shared_ptr<const Body> body_;
    MoverOptions options_;
    Pose start_, now_, goal_pose_;
    Goal goal_ = Goal::Pose;
    std::shared_ptr<const Clip> clip_;
    Vec3d clip_shift_ = Vec3d::Zero();  // m
    Playback playback_;
    double playhead_ = 0;  // s; of a loop, it grows beyond its length
    bool is_playing_ = false;
    bool is_at_start_pose_ = true;
    std::optional<Blend> blend_;
    double chase_speed_ = 0;  // m/s
};

}  // namespace selvedge::sim
