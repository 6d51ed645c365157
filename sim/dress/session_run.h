#pragma once
// The state and logic of a session, without its thread: placed panels, sewing, draping, and changes between frames.
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

// Timings of the last frames.
class FrameTimes {
 public:
    void note(const SessionTimes& frame);
    SessionTimes medians() const;

 private:
    std::vector<SessionTimes> last_;  // ring buffer
    std::size_t next_ = 0;
};

class SessionRun {
 public:
    // interrupt: called regularly during long operations; its exceptions propagate from any method here.
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

    // Stops with the stage Failed and this error message, until something changes.
    void fail(const std::string& problem);

    // Whether a frame can be simulated: running, and sewing or draping.
    bool moves() const;
    // Simulates one frame. Pre: moves().
    void advance();
    double frame_seconds() const;  // simulated time per frame, s

    // The slow preparation that start() needs (building the collider), to do while idle.
    bool may_prepare() const;
    void prepare() { ensure_collider(); }

    // Whether anything visible has changed since the last call.
    bool take_change();
    std::shared_ptr<SessionFrame> make_frame();

    const SessionOptions& options() const { return options_; }

 private:
    struct ColliderOfBody {
        std::shared_ptr<const Body> body;
        BodyCollider collider;
    };
    struct Drape {
        Cloth cloth;
        Pattern pattern;              // the pattern it was meshed from
        GarmentMesh unsewn;           // the mesh of that pattern
        std::vector<int> open_seams;  // ascending
        std::vector<int> pins;        // base vertices that the pattern pins
        std::optional<DrapeRun> run;  // never empty
    };
    struct SavedDrape {
        Drape drape;
        SessionStage stage = SessionStage::Draping;
    };

    // Simulation.
    void sew_frame();
    void drape_frame();
    void begin_sewing();
    void end_sewing();
    void hang(Drape drape, double relax_time);
    void update_drag();
    DrapeOptions draping() const;
    void apply_options();
    void reactivate();
    bool is_sewn() const { return drape_.has_value(); }

    // Changes between frames.
    void place();
    void take_pattern(Pattern pattern);
    void change_cloth(const Pattern& pattern);
    void change_outlines(const Pattern& pattern);
    void restart_sewing(const std::string& why);
    void clear_drape();
    void ensure_collider();
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
    std::unique_ptr<const ColliderOfBody> met_;  // collider of body_; built when first needed
    Pattern pattern_;                            // the newest one that can be meshed
    Pattern anchored_;                           // pattern_ with its panels moved to the body
    bool is_anchored_ = false;
    struct NamedBody {
        std::string text;
        double height = 0;  // m
        Body body;
    };
    std::optional<NamedBody> placed_for_;  // cache: the body that a pattern named

    std::vector<CachedPanelMesh> quick_meshes_, meshes_;
    GarmentMesh placed_;  // the quick mesh, for display
    std::optional<SewingRun> sewing_;
    std::optional<Drape> drape_;
    std::map<std::string, SavedDrape> kept_;
    DragConstraint drag_constraint_;
    std::optional<TriangleBudget> budget_;
    FrameTimes times_;
    double past_seconds_ = 0;  // s, simulated before the current drape
    int splits_ = 0, rejoins_ = 0;
};

// Limits on session options.

inline constexpr int kDeepestSessionLevel = 8;  // a base edge of 5 cm is 0.2 mm long at this level

// Clamps options to their valid ranges.
SessionOptions within_limits(SessionOptions options);

}  // namespace selvedge::sim
