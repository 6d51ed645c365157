#pragma once
// An interactive drape: a dressing that runs on its own thread while the user edits the pattern. The caller reads the
// newest frame and posts requests at any time; no call waits for the simulation. (thesis 3.6.7, ch. 4)
//
// Pattern, body and options may change while it runs (sim/dress/dressing.h). Once the garment hangs, its body may take
// other poses and move, and carries it along (sim/session/body_mover.h). The garment as it was dressed is kept: the
// body can be put back into it, and a pattern that changes is dressed on the body at rest, which then goes on from
// there. A body whose arms are not where patterns expect them is dressed with lowered arms (dressing_pose()), and goes
// into its own pose when the garment hangs.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/body/pose.h"
#include "sim/core/view_point.h"
#include "sim/dress/dress_options.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/pattern.h"
#include "sim/session/body_mover.h"

namespace selvedge::sim {

class Collider;
class PreparedBody;
struct Cloth;
struct DressReport;

enum class SessionStage {
    Empty,    // no panels, or they cannot be meshed: see SessionFrame::problem
    Placed,   // panels are placed around the body, unsewn
    Sewing,   // seams are closing
    Draping,  // the sewn garment is moving
    Moving,   // the body moves, or has moved and the garment comes to rest
    Settled,  // at rest; continues only after a change
    Failed    // a value is not finite, or an error: see SessionFrame::problem
};

// The drape has no time limit, and steps skip a cloth at rest.
struct SessionOptions : DressOptions {
    SessionOptions();

    bool keeps_real_time = true;       // false: as fast as possible
    bool reports_faults = false;       // at rest: SessionFrame::report
    bool coarsens_back_faces = false;  // coarse where the fabric's right side faces away from the viewer (look_from)

    bool operator==(const SessionOptions&) const = default;
};

// Wall time of the last 30 frames, ms: medians.
struct SessionTimes {
    double adaptation = 0;
    double steps = 0;  // all steps of one frame
    double frame = 0;  // whole frame: adaptation and steps
};

struct SessionStatistics {
    int base_triangles = 0;
    int leaf_triangles = 0;
    int leaf_vertices = 0;
    std::vector<int> by_level;  // leaf triangles per level
    double simulated_seconds = 0;
    double rms_speed = 0;  // m/s
    int splits = 0;        // in the last adaptation
    int rejoins = 0;
    SessionTimes times;
};

// What the body does.
struct SessionMotion {
    bool can_move = false;    // the body has bones and a skin
    bool is_waiting = false;  // it is to move, but the garment does not hang yet
    bool is_playing = false;
    bool is_blending = false;                       // it goes over into a pose, or into the motion
    bool is_at_rest = true;                         // it stands where it is dressed
    bool is_in_motion = false;                      // the motion was played or sought last, rather than a pose
    double seconds = 0;                             // of the motion, 0 to its length
    double length = 0;                              // s, of the motion; 0: none
    Vec3f way = Vec3f::Zero();                      // m over the floor, from where the body was dressed
    std::shared_ptr<const Pose> pose{};             // of the body; null: its rest pose
    std::shared_ptr<const std::vector<Vec3f>> x{};  // m, of its surface; null: Body::x
    // What the motion did to the garment, since the body left the pose in which it was dressed, as `animate` reports
    // it: "the garment of 'front' left the waist at 1.20 s and hangs on the left hand".
    std::vector<std::string> faults{};
};

// Snapshot of the drape. Immutable once published.
struct SessionFrame {
    std::uint64_t number = 0;  // increases with each published frame
    SessionStage stage = SessionStage::Empty;
    bool is_running = false;
    DrawMesh mesh;  // leaf triangles with material coordinates; panels are separate while unsewn
    TriangleHierarchy hierarchy;
    std::vector<std::array<Vec3f, 2>> seam_lines;  // m: links of unclosed seams, the positions of both ends
    std::vector<int> seam_line_seams;              // per link: index into Pattern::seams
    std::vector<Vec3f> pins;                       // m, vertices that the user pinned
    SessionMotion motion;
    SessionStatistics statistics;
    std::string problem;                // error message; empty: none
    std::vector<std::string> messages;  // events that the user should know about, newest last

    // At rest only: the cloth itself and the collider that it hangs on, for a curved surface over it.
    std::shared_ptr<const Cloth> cloth{};
    std::shared_ptr<const Collider> collider{};

    // What is right and wrong with the garment as it came to rest where it is dressed, as dress() reports it; also
    // while its body moves from there, and of a garment that should have come to rest and still moves. Null: it was
    // not looked at yet.
    std::shared_ptr<const DressReport> report{};
};

// A point on the displayed cloth: a triangle of a frame's mesh and barycentric weights.
struct ClothPoint {
    std::uint64_t frame = 0;
    std::uint32_t triangle = 0;
    Vec3f weights = Vec3f::Constant(1.0F / 3);
};

enum class SessionDrive {
    Thread,  // runs on its own thread
    Caller   // runs only inside advance(): for tests and scripts, deterministic
};

class Session {
 public:
    explicit Session(SessionDrive drive = SessionDrive::Thread);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void set_body(std::shared_ptr<const PreparedBody> body);  // its collider is built on the session's thread
    void set_body(std::shared_ptr<const Body> body);          // the same, prepared first
    void set_pattern(const Pattern& pattern);                 // may be called often; outdated requests are skipped
    void set_options(const SessionOptions& options);
    // The files of the pattern's fabrics were written: the garment takes their values, from where it hangs. Nothing
    // happens while the last pattern is refused.
    void reread_fabrics();

    void look_from(const ViewPoint& viewer);  // may be called often

    void start();  // closes the seams first when needed
    void pause();
    void reset();  // panels return to their placed position, unsewn; removes pins and drag

    // Dragging: one point follows the target `to` (m) until let_go(). Pinned points stay in place.
    void pull(const ClothPoint& point, const Vec3f& to);
    void pull_to(const Vec3f& to);
    void let_go();
    void pin(const ClothPoint& point);
    void unpin_all();

    // The body's motion (BodyMover). Poses and clips are of `body`; a request for another body than that which the
    // session has by then is ignored.
    void go_to(std::shared_ptr<const Body> body, const Pose& pose);
    void follow(std::shared_ptr<const Body> body, const Pose& pose);  // a pose that changes: may be called often
    void set_clip(std::shared_ptr<const Body> body, std::shared_ptr<const Clip> clip);  // null: none
    void set_playback(const Playback& playback);
    void play();
    void pause_motion();
    void seek(double seconds);
    void back_to_start();  // the body and the garment are as when it was dressed

    // The newest frame; never null. Does not wait for the simulation.
    std::shared_ptr<const SessionFrame> frame() const;

    // Saves the current drape under a name, to restore it later.
    void save_drape(const std::string& name);
    void restore_drape(const std::string& name);  // needs an unchanged base mesh; otherwise only a message is added

    // SessionDrive::Caller only: applies pending requests, then simulates up to `frames` frames of one adaptation and
    // its steps.
    void advance(int frames);

 private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace selvedge::sim
