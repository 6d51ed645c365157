#pragma once
// A garment that is being draped while a person works on it: the running drape that the editor holds. It runs on a
// thread of its own; whoever looks takes the newest frame, whoever wants something else says so at any time, and no
// call waits for the simulation.  (SPEC 1.4, 3.1; thesis ch. 4)
//
// Pattern, body and options may change while it runs. A changed pattern is sewn anew; where its panels, their outline
// edges and seams are the same in number and kind, the cloth goes on from where it hangs, else from where it is placed,
// and a message says why.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/cloth/adapt_cloth.h"
#include "sim/mesh/plain_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

enum class SessionStage {
    Empty,    // no panels, or none that can be meshed: see SessionFrame::problem
    Placed,   // panels stand round the body, unsewn
    Sewing,   // seams close
    Draping,  // the sewn garment moves
    Settled,  // it has come to rest, and moves on only when something changes
    Failed    // a number went bad: see SessionFrame::problem
};

struct SessionOptions {
    std::optional<double> edge_length{};  // m, of the base mesh, instead of the pattern's
    int max_level = 3;
    double shortest_edge = 0.02;  // m
    CriteriaOptions criteria{};
    CurvatureOptions curvature{};
    std::optional<int> triangle_budget{};  // leaf triangles aimed at; none: as many as the criteria ask for
    bool keeps_real_time = true;           // false: as fast as it can
    bool has_gravity = true;

    bool operator==(const SessionOptions&) const;
};

// Wall time of the last frames, ms: medians.
struct SessionTimes {
    double adaptation = 0;
    double steps = 0;  // all of one frame
    double frame = 0;  // with making the mesh that is shown
};

struct SessionStatistics {
    int base_triangles = 0;
    int leaf_triangles = 0;
    int leaf_vertices = 0;
    std::vector<int> by_level;  // leaf triangles
    double simulated_seconds = 0;
    double rms_speed = 0;  // m/s
    int splits = 0;        // of the last adaptation
    int rejoins = 0;
    SessionTimes times;
};

// What is seen of the drape at one moment. Never changed once it is published.
struct SessionFrame {
    std::uint64_t number = 0;  // counts up with each that is published
    SessionStage stage = SessionStage::Empty;
    bool is_running = false;
    PlainMesh mesh;  // leaves, with material coordinates; of panels that are apart while unsewn
    TriangleHierarchy hierarchy;
    std::vector<std::array<Vec3f, 2>> threads;  // m: links of seams that are not closed, from side to side
    std::vector<int> thread_seams;              // of each: index into Pattern::seams
    std::vector<Vec3f> pins;                    // m, where cloth is pinned by hand
    SessionStatistics statistics;
    std::string problem;                // in words; empty: none
    std::vector<std::string> messages;  // what was done that a person should know, newest last
};

// A point of the cloth as it is seen: a triangle of a frame's mesh and weights of its corners.
struct ClothPoint {
    std::uint64_t frame = 0;
    std::uint32_t triangle = 0;
    Vec3f weights = Vec3f::Constant(1.0F / 3);
};

enum class SessionDrive {
    Thread,  // runs by itself
    Caller   // runs only inside advance(): for tests and scripts, the same bits each time
};

class Session {
 public:
    explicit Session(SessionDrive drive = SessionDrive::Thread);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void set_body(std::shared_ptr<const Body> body);  // the collider is made on the session's thread
    void set_pattern(const Pattern& pattern);         // as often as it changes; only the newest is taken
    void set_options(const SessionOptions& options);

    void start();  // sews first, where need be
    void pause();
    void reset();  // panels back to where they are placed, unsewn; hands off

    // Pulling: one point follows `to` (m) until it is let go. Pinned points stay where they are.
    void pull(const ClothPoint& point, const Vec3f& to);
    void pull_to(const Vec3f& to);
    void let_go();
    void pin(const ClothPoint& point);
    void unpin_all();

    // The newest frame; never null. Cheap.
    std::shared_ptr<const SessionFrame> frame() const;

    // Drapes that are kept under a name, and shown or gone on from later.
    void keep(const std::string& name);
    void restore(const std::string& name);  // only where the pattern still has the same mesh: else a message says so

    // Drive Caller only: takes in what was asked for, and simulates so many frames, each one adaptation and its steps.
    void advance(int frames);

 private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace selvedge::sim
