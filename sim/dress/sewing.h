#pragma once
// Closes the seams: the panels, still separate and at level 0, are pulled together along their seams without gravity.
// Each collides with the body from its own side. Closed seams are merged. (thesis fig. 4.3 merges seams at once, which
// can put seam vertices inside the body.)
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/mesh/garment_mesh.h"
#include "sim/simulation/simulation.h"

namespace selvedge::sim {

class ContentStore;
class MeasuredBody;
struct BodyLimbs;

struct SewingOptions {
    float closing_speed = 0.6F;  // m/s, rate at which the allowed gap shrinks
    float closed_gap = 0.006F;   // m, a shorter link is closed: two contact offsets may lie between its ends
    // m; when the time is up, a shorter link is sewn too: limbs are thicker, so what holds it open are folds of gathers
    float sewn_gap = 0.02F;
    float extra_pull_time = 1.5F;                // s of further pulling after the allowed gap has reached zero
    SimulationOptions simulation{};              // without self_contact panels pass through each other
    ClothConstraints constraints{};              // of the cloth, besides the seams
    std::function<void()> interrupt{};           // called during long preparations: see DistanceField
    const ContentStore* store = nullptr;         // for their results: see BodyCollider
    std::shared_ptr<const BodyLimbs> limbs{};    // of the body; null: none get out of the way
    std::shared_ptr<const MeasuredBody> body{};  // round which panels are placed; null: its shoulders are not known
};

struct OpenSeam {
    int seam = 0;   // index into Pattern::seams
    float gap = 0;  // m, of its widest link that was not sewn
};

struct SewingResult {
    GarmentMesh sewn;  // merged at the links that closed, or nearly
    std::vector<OpenSeam> open;
    double simulated_seconds = 0;
    std::optional<VertexId> bad_vertex;  // of the unsewn mesh, where a value is not finite; `sewn` is then invalid
};

// Sewing in progress: one step per advance(). The floor is below all panels: hems that it bends up while they are sewn
// stay so.
class SewingRun {
 public:
    SewingRun(GarmentMesh unsewn, const std::vector<Fabric>& fabrics, const SewingOptions& options);

    // Returns false when done: all links are closed, the time is up, or a value is not finite. Pre: no call returned
    // false.
    bool advance(const Collider& body);

    // These links (by index) are closed before the others begin to, as a tailor sews a sleeve before it is set in.
    // Pre: advance() was not called.
    void close_first(const std::vector<bool>& links);

    // After advance() has returned false: one step with the seams held closed, under this share of gravity or none.
    void fall(const Collider& body, float weight = 1);
    void hold(const Collider& body);
    // Vertices of the unsewn mesh that meet the trunk of a JointedCollider only (ContactState::is_trunk_only); empty:
    // none do.
    void meet_trunk_only(std::vector<bool> vertices);
    // One of these is to be called when the collider has moved, the second if by at most that (m).
    void forget_contacts();
    void keep_far_contacts(float by);
    float rms_speed() const { return rms_speed_; }  // m/s, in the last step of the fall
    float seconds() const { return seconds_; }
    double work() const { return work_; }  // of all steps: see WorkCount
    std::size_t triangle_count() const { return mesh_.triangles.size(); }
    bool has_bad_number() const { return bad_vertex_.has_value(); }

    double fraction() const { return std::min(1.0F, seconds_ / limit_); }
    const Cloth& cloth() const { return simulation_.cloth(); }  // of the separate panels
    std::span<const SeamLink> links() const { return links_; }
    float closed_gap() const { return options_.closed_gap; }  // m
    bool is_closed() const;                                   // all links are
    GarmentMesh unsewn() const;                               // with its links, where its panels were at first
    SewingResult result() &&;                                 // sews the mesh in place

 private:
    void begin_to_close(float gap);
    void step(const Collider& body, const Schedule& schedule);
    void step_held(const Collider& body, const Schedule& schedule);

    GarmentMesh mesh_;
    std::vector<SeamLink> links_;  // taken from the mesh
    SewingOptions options_;
    Simulation simulation_;
    std::vector<SeamPull> pulls_;
    std::vector<SeamPull> first_;  // that are closed before the others; empty from then on
    float begun_ = 0;              // s, when the links that are closing began to
    float start_gap_ = 0;          // m, of these
    float limit_ = 0;              // s
    float rms_speed_ = 0;          // m/s
    float seconds_ = 0;
    double work_ = 0;
    std::optional<VertexId> bad_vertex_;
};

}  // namespace selvedge::sim
