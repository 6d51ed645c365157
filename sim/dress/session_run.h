#pragma once
// What a session does, without its thread: panels that stand, are sewn, and hang; changes come in between frames.
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/adaptive/triangle_budget.h"
#include "sim/collide/body_collider.h"
#include "sim/dress/drag_constraint.h"
#include "sim/dress/drape.h"
#include "sim/dress/session.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {

// The last frames' times.
class FrameTimes {
 public:
    void note(const SessionTimes& frame);
    SessionTimes medians() const;

 private:
    std::vector<SessionTimes> last_;  // a ring
    std::size_t next_ = 0;
};

class SessionRun {
 public:
    // interrupt: called often while what takes long is done; what it throws comes out of any call here.
    explicit SessionRun(std::function<void()> interrupt = {});
    SessionRun(const SessionRun&) = delete;
    SessionRun& operator=(const SessionRun&) = delete;

    void set_body(std::shared_ptr<const Body> body);
    void set_pattern(Pattern pattern);
    void set_options(const SessionOptions& options);
    void start();
    void pause();
    void reset();
    void pull(const MaterialPoint& at, const Vec3f& to);
    void pull_to(const Vec3f& to);
    void let_go();
    void pin(const MaterialPoint& at);
    void unpin_all();
    void keep(const std::string& name);
    void restore(const std::string& name);
    void say(std::string message);

    // It stands still, and says why, until something changes.
    void fail(const std::string& problem);

    // Running, and not at rest.
    bool moves() const;
    // One frame. Pre: moves().
    void advance();
    double frame_seconds() const;  // s, simulated in one

    // What start() would have to do first and takes long: for when there is nothing else to do.
    bool may_prepare() const;
    void prepare() { meet_body(); }

    // Whether anything that is seen has changed since this was asked the last time.
    bool take_change();
    std::shared_ptr<SessionFrame> make_frame();

    const SessionOptions& options() const { return options_; }

 private:
    struct BodyToMeet {
        std::shared_ptr<const Body> body;
        BodyCollider collider;
    };
    struct Drape {
        Cloth cloth;
        Pattern pattern;              // that it was meshed from
        GarmentMesh unsewn;           // its mesh
        std::vector<int> open_seams;  // ascending
        std::vector<int> pins;        // base vertices, the pattern's own
        std::optional<DrapeRun> run;  // always one
    };
    struct KeptDrape {
        Drape drape;
        SessionStage stage = SessionStage::Draping;
    };

    // session_run.cpp: what moves
    void sew_frame();
    void drape_frame();
    void begin_sewing();
    void end_sewing();
    void hang(Drape drape, double relax_time);
    void follow_hands();
    DrapeOptions draping() const;
    void apply_options();
    void wake();
    bool is_sewn() const { return drape_.has_value(); }

    // session_changes.cpp: what is changed
    void place();
    void take_pattern(Pattern pattern);
    void change_cloth(const Pattern& pattern);
    void change_outlines(const Pattern& pattern);
    void sew_anew(const std::string& why);
    void forget_drape();
    void meet_body();
    const Pattern& anchored();
    MeshOptions meshing() const;
    GarmentMesh unsewn_mesh();

    std::function<void()> interrupt_;
    SessionOptions options_;
    SessionStage stage_ = SessionStage::Empty;
    bool is_running_ = false;
    bool has_changed_ = true;
    std::string problem_;
    std::vector<std::string> messages_;

    std::shared_ptr<const Body> body_;
    std::unique_ptr<const BodyToMeet> met_;  // of body_; made when it is first met
    Pattern pattern_;                        // the newest that can be meshed
    Pattern anchored_;                       // the same, moved to the body
    bool is_anchored_ = false;
    struct NamedBody {
        std::string text;
        double height = 0;  // m
        Body body;
    };
    std::optional<NamedBody> placed_for_;  // the body that a pattern named

    std::vector<KeptPanelMesh> quick_meshes_, meshes_;
    GarmentMesh placed_;  // the quick mesh, to be seen
    std::optional<SewingRun> sewing_;
    std::optional<Drape> drape_;
    std::map<std::string, KeptDrape> kept_;
    DragConstraint hands_;
    std::optional<TriangleBudget> budget_;
    FrameTimes times_;
    double past_seconds_ = 0;  // s, simulated before what hangs now
    int splits_ = 0, rejoins_ = 0;
};

// What a session makes of options that nobody checked.

inline constexpr int kDeepestSessionLevel = 8;  // a base edge of 5 cm then is 0.2 mm long

// The nearest options that can be worked with.
SessionOptions within_limits(SessionOptions options);

}  // namespace selvedge::sim
