#pragma once
// What a session does with requests and between frames, without its thread: the dressing, and then the motion of the
// body. Used by session.cpp only.
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/dress/dressing.h"
#include "sim/inspection/report.h"
#include "sim/place/fit.h"
#include "sim/session/live_motion.h"
#include "sim/session/session.h"

namespace selvedge::sim {

inline constexpr int kDeepestSessionLevel = 8;  // a base edge of 5 cm is 0.2 mm long at this level

// What the session is asked for; each is carried out on its thread.
namespace request {
struct SetBody {
    std::shared_ptr<const PreparedBody> body;
};
struct SetPattern {
    Pattern pattern;
};
struct RereadFabrics {};
struct SetOptions {
    SessionOptions options;
};
struct LookFrom {
    ViewPoint viewer;
};
struct Start {};
struct Pause {};
struct Reset {};
struct Pull {
    MaterialPoint at;
    Vec3f to;
};
struct PullTo {
    Vec3f to;
};
struct LetGo {};
struct Pin {
    MaterialPoint at;
};
struct UnpinAll {};
struct SaveDrape {
    std::string name;
};
struct RestoreDrape {
    std::string name;
};
struct GoTo {
    std::shared_ptr<const Body> body;
    Pose pose;
};
struct Follow {
    std::shared_ptr<const Body> body;
    Pose pose;
};
struct SetClip {
    std::shared_ptr<const Body> body;
    std::shared_ptr<const Clip> clip;
};
struct SetPlayback {
    Playback playback;
};
struct Play {};
struct PauseMotion {};
struct Seek {
    double seconds = 0;
};
struct BackToStart {};
struct Message {
    std::string message;
};
}  // namespace request

using Request =
    std::variant<request::SetBody, request::SetPattern, request::RereadFabrics, request::SetOptions, request::LookFrom,
                 request::Start, request::Pause, request::Reset, request::Pull, request::PullTo, request::LetGo,
                 request::Pin, request::UnpinAll, request::SaveDrape, request::RestoreDrape, request::GoTo,
                 request::Follow, request::SetClip, request::SetPlayback, request::Play, request::PauseMotion,
                 request::Seek, request::BackToStart, request::Message>;

// Timings of the last frames.
class FrameTimes {
 public:
    void note(const SessionTimes& frame);
    SessionTimes medians() const;

 private:
    std::vector<SessionTimes> last_;  // ring buffer
    std::size_t next_ = 0;
};

// What a session does with requests and between frames, without its thread.
class SessionState {
 public:
    explicit SessionState(std::function<void()> interrupt) : dressing_(std::move(interrupt)) {
        dressing_.set_options(options_);
    }

    // Each carries out one request.
    void operator()(request::SetBody& request);
    void operator()(request::SetPattern& request);
    void operator()(request::RereadFabrics);
    void operator()(const request::SetOptions& request);
    void operator()(const request::LookFrom& request);
    void operator()(request::Start);
    void operator()(request::Pause);
    void operator()(request::Reset);
    void operator()(const request::Pull& request);
    void operator()(const request::PullTo& request);
    void operator()(request::LetGo);
    void operator()(const request::Pin& request);
    void operator()(request::UnpinAll);
    void operator()(const request::SaveDrape& request);
    void operator()(const request::RestoreDrape& request);
    void operator()(const request::GoTo& request);
    void operator()(const request::Follow& request);
    void operator()(request::SetClip& request);
    void operator()(const request::SetPlayback& request);
    void operator()(request::Play);
    void operator()(request::PauseMotion);
    void operator()(const request::Seek& request);
    void operator()(request::BackToStart);
    void operator()(request::Message& request) { say(std::move(request.message)); }

    // Stops with the stage Failed and this error message, until something changes.
    void fail(const std::string& problem);

    // Whether a frame can be simulated: running, and sewing or draping.
    bool moves() const;
    // Simulates one frame. Pre: moves().
    void advance();
    double frame_seconds() const;  // simulated time per frame, s

    // The slow preparation that sewing needs (the collider), to do while idle.
    bool may_prepare() const;
    void prepare() { dressing_.collider(); }

    // Finds what is wrong with the garment at rest, which takes some tenths of a second: to do while idle.
    bool may_inspect() const;
    bool is_overdue() const;
    void inspect();

    // Whether anything visible has changed since the last call.
    bool take_change() { return std::exchange(has_changed_, false); }
    std::shared_ptr<SessionFrame> make_frame();

    bool keeps_real_time() const { return options_.keeps_real_time; }

 private:
    SessionStage stage() const;
    bool take_pattern(Pattern pattern);
    void show_changed_cloth(bool is_seen);
    void forget_rest();
    void sew();
    void sew_if_running();
    void say(std::string message);
    void report_sewing();
    void advance_dressing();

    bool wants_motion() const { return mover_ && !mover_->has_arrived(); }
    bool hangs() const;
    void begin_body();
    void begin_motion();
    void advance_motion();
    void leave_motion();
    bool may_touch();
    void update_visibility();
    bool shows_another_side() const;
    void show_drape(SessionFrame& frame) const;
    void show_motion(SessionFrame& frame) const;

    Dressing dressing_;
    SessionOptions options_;
    bool is_running_ = false;
    bool has_failed_ = false;
    bool has_changed_ = true;
    std::string problem_;
    std::vector<std::string> messages_;
    std::map<std::string, Dressing::Drape> saved_;
    FrameTimes times_;
    int splits_ = 0, rejoins_ = 0;  // in the last frame
    // Copies, made for the first frame at rest; the collider, of a body that has moved.
    std::shared_ptr<const Cloth> cloth_at_rest_;
    std::shared_ptr<const Collider> collider_at_rest_;
    std::shared_ptr<const DressReport> report_;      // of the dressing at rest
    std::optional<TightLevel> too_small_when_sewn_;  // of what was sewn: fits_nowhere()
    ViewPoint viewer_, adapted_to_;                  // now, and when the cloth adapted last
    std::optional<Visibility> visibility_;           // while back faces are coarsened
    std::shared_ptr<const PreparedBody> body_;
    std::optional<BodyMover> mover_;  // of a body with bones
    // Where the dressing's body stands, m, and in which pose, if that is not its own; otherwise null.
    std::shared_ptr<const std::vector<Vec3f>> start_x_;
    std::shared_ptr<const Pose> start_pose_;
    std::unique_ptr<LiveMotion> motion_;  // the garment while the body is not as it was dressed, or null
};

}  // namespace selvedge::sim
