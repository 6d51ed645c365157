#pragma once
// A dressed garment that moves with its body: each frame the body goes on to its next pose, the cloth steps fall
// between, and the mesh adapts. (thesis 5.3.5, 5.4)
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/moving_body.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"
#include "sim/core/region.h"
#include "sim/simulation/simulation.h"

namespace selvedge::sim {

// Writes the vertex positions of the body's surface (m) at that time (s) of the motion. They are read in the region
// (m) only; outside of it they need not be exact.
using BodyAt = std::function<void(double seconds, const Region& region, std::vector<Vec3f>& x)>;

struct MotionOptions {
    double step_seconds = 1.0 / 120;
    double adaptation_seconds = 1.0 / 30;
    int substeps = 2 * Schedule{}.substeps;  // per step: twice as many as at rest, where stretch has time to even out
    float air_damping = 2;                   // 1/s
    // m, that vertices which do not touch the body keep beyond the contact offset
    float free_standoff = ContactOptions{}.offset - kRestOffset;
};

struct MotionFrame {
    int steps = 0;
    int pinched = 0;  // vertices between two sides of the body with less room than the contact offset, at the end
    bool has_bad_number = false;
    float rms_speed = 0;  // m/s, since the last adaptation
    AdaptReport adapted{};
};

// Pinned vertices of a cloth on a body that moves: each keeps its place in the frame of the triangle of the body that
// it is nearest to.
class PinnedFollowers {
 public:
    // Where the pinned vertices of the cloth are when the surface, which is now where they are, has moved to `end`, m.
    // Valid until the next call.
    std::span<const KinematicVertex> follow(const Cloth& cloth, const SurfaceBvh& surface, std::span<const Vec3f> end);

 private:
    struct Follower {
        bool is_bound = false;
        std::uint32_t triangle = 0;
        std::array<float, 3> shares{};
        float height = 0;  // m, along the triangle's normal
    };

    static Follower bound(const Vec3f& x, const SurfaceBvh& surface);
    static Vec3f place_of(const Follower& follower, const SurfaceBvh& surface, std::span<const Vec3f> x);

    std::vector<Follower> followers_;  // by vertex
    std::vector<KinematicVertex> places_;
};

class MotionRun {
 public:
    // The cloth hangs on the body as body_at(0) gives it. All calls must pass the same simulation. Pre: the cloth is
    // sewn.
    MotionRun(Simulation& simulation, const Body& body, BodyAt body_at, const MotionOptions& options = {});

    // Goes on to that time, in whole steps: to the step that ends nearest to it.
    MotionFrame advance_to(Simulation& simulation, double seconds);

    double seconds() const { return static_cast<double>(steps_) * options_.step_seconds; }
    const MovingBodyCollider& collider() const { return collider_; }
    MotionOptions& options() { return options_; }

 private:
    void step_once(Simulation& simulation, MotionFrame& frame);
    void adapt(Simulation& simulation, MotionFrame& frame);
    Schedule schedule() const;

    BodyAt body_at_;
    MotionOptions options_;
    MovingBodyCollider collider_;
    long steps_ = 0;
    std::vector<Vec3f> end_;
    PinnedFollowers pins_;
};

}  // namespace selvedge::sim
