#pragma once
// An interactive drape: a dressing that runs on its own thread while the user edits the pattern. The caller reads the
// newest frame and posts requests at any time; no call waits for the simulation. (thesis 3.6.7, ch. 4)
//
// Pattern, body and options may change while it runs (sim/dress/dressing.h).
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/dress/dressing.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

enum class SessionStage {
    Empty,    // no panels, or they cannot be meshed: see SessionFrame::problem
    Placed,   // panels are placed around the body, unsewn
    Sewing,   // seams are closing
    Draping,  // the sewn garment is moving
    Settled,  // at rest; continues only after a change
    Failed    // a value is not finite, or an error: see SessionFrame::problem
};

// The drape has no time limit, and steps skip a cloth at rest.
struct SessionOptions : DressOptions {
    SessionOptions();

    bool keeps_real_time = true;  // false: as fast as possible

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
    SessionStatistics statistics;
    std::string problem;                // error message; empty: none
    std::vector<std::string> messages;  // events that the user should know about, newest last

    // At rest only: the cloth itself and the collider that it hangs on, for a curved surface over it.
    std::shared_ptr<const Cloth> cloth{};
    std::shared_ptr<const Collider> collider{};
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

    void set_body(std::shared_ptr<const Body> body);  // the collider is built on the session's thread
    void set_pattern(const Pattern& pattern);         // may be called often; outdated requests are skipped
    void set_options(const SessionOptions& options);

    void start();  // closes the seams first when needed
    void pause();
    void reset();  // panels return to their placed position, unsewn; removes pins and drag

    // Dragging: one point follows the target `to` (m) until let_go(). Pinned points stay in place.
    void pull(const ClothPoint& point, const Vec3f& to);
    void pull_to(const Vec3f& to);
    void let_go();
    void pin(const ClothPoint& point);
    void unpin_all();

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
