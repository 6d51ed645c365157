#pragma once
// A garment on a body that moves, from dressing to the last frame: the body stands in the pose in which the garment
// suits it, is dressed, goes over into the first pose of a motion, and moves. Writes no files.
//
//   dressed pose ----- blend_seconds -----> first pose of the motion ----- seconds -----> end
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/body/pose.h"
#include "sim/body/yielding_flesh.h"
#include "sim/core/parallel.h"
#include "sim/dress/dress_options.h"
#include "sim/inspection/kept_place.h"
#include "sim/inspection/motion_quality.h"
#include "sim/inspection/report.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

class MotionRun;
class Simulation;
struct Cloth;

struct AnimationOptions {
    DressOptions dress{};
    double frames_per_second = 25;
    double blend_seconds = 1.5;
    double from = 0;                  // s of the motion, where it begins
    std::optional<double> to{};       // s of the motion, where it ends; none: at its end, of a loop once
    std::optional<double> seconds{};  // s that are shown of it, whatever its speed; none: until `to`
    double speed = 1;                 // of the motion
};

// What the body does over the time of an animation: rest, blend, motion. The motion begins where the body stands, so
// that the hips keep their place over the floor while they go over into it.
class BodyTimeline {
 public:
    // Pre: the body has a skin, and the clip is one of it.
    BodyTimeline(std::shared_ptr<const Body> body, Pose start, Clip clip, const AnimationOptions& options);

    const Body& body() const { return *body_; }
    const FleshSurface& surface() const { return flesh_.surface(); }  // of the body
    double seconds() const { return options_.blend_seconds + motion_seconds_; }
    Pose pose(double seconds) const;
    // Of the surface, m; flesh outside of the region (m) may stay as it is.
    void positions(double seconds, const Region& region, std::vector<Vec3f>& x);

 private:
    std::shared_ptr<const Body> body_;
    Pose start_;
    Clip clip_;
    AnimationOptions options_;
    double motion_seconds_ = 0;
    Vec3d way_ = Vec3d::Zero();  // m, by which the motion is moved
    MovingFlesh flesh_;
};

class Animation {
 public:
    // Dresses the body in the pose `start`. Throws InputError as dress() does.
    Animation(const Pattern& pattern, std::shared_ptr<const Body> body, Pose start, Clip clip,
              const AnimationOptions& options, const Progress& progress = {});

    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;
    ~Animation();

    int frame_count() const { return frame_count_; }  // with the first, which shows the dressed body
    int frame() const { return frame_; }              // that is shown, from 0
    double seconds() const;
    double frames_per_second() const { return options_.frames_per_second; }
    const BodyTimeline& timeline() const { return timeline_; }
    // Goes on to the next frame. Returns false, and does nothing, at the end or if a coordinate is no longer finite.
    bool advance();

    const Cloth& cloth() const;
    const std::vector<std::string>& panel_names() const { return panel_names_; }
    const Body& body() const { return shown_; }                          // where it is in this frame
    std::span<const Vec3f> body_points() const { return body_points_; }  // of its surface, m
    const DressReport& dress_report() const { return report_; }
    const MotionQuality& quality() const { return quality_; }
    // What is wrong with the garment in motion, a sentence each.
    std::vector<std::string> motion_faults() const;
    const std::vector<double>& frame_ms() const { return frame_ms_; }  // wall time of each advance()

 private:
    BodyTimeline timeline_;
    AnimationOptions options_;
    FleshSurface surface_;  // of the body that is shown; the cloth meets a tented one
    Body shown_;
    std::vector<Vec3f> body_points_;
    DressReport report_;
    std::unique_ptr<Simulation> simulation_;  // never null
    std::vector<std::string> panel_names_;
    std::unique_ptr<MotionRun> run_;
    MotionQuality quality_;
    std::unique_ptr<KeptPlace> kept_place_;
    std::vector<double> frame_ms_;
    int frame_count_ = 1, frame_ = 0;
};

}  // namespace selvedge::sim
