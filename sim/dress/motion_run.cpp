#include "sim/dress/motion_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/cloth/solver_state.h"
#include "sim/cloth/standoff.h"
#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

// A step is divided where a part of the body that is near the cloth moves farther within it relative to the rest: the
// tangent planes of its contacts serve for this way.
constexpr float kLongestMotion = 0.02F;  // m, half the radius of a wrist and a forearm, on average
constexpr int kMostParts = 4;

// Where the cloth may meet the body within a step.
Region near(const Cloth& cloth) {
    constexpr float kNear = 0.1F;  // m: cloth that is faster than 12 m/s relative to the body round it may miss it
    std::vector<Vec3f> points;
    for (const VertexId v : cloth.mesh.leaf_vertices()) points.emplace_back(cloth.x[v.value].head<3>());
    return {points, kNear};
}

}  // namespace

MotionRun::MotionRun(Simulation& simulation, const Body& body, BodyAt body_at, const MotionOptions& options)
    : body_at_(std::move(body_at)), options_(options), collider_(body) {
    Cloth& cloth = simulation.cloth();
    body_at_(0, near(cloth), end_);
    collider_.place(end_);
    forget_contacts(cloth);
    set_substep(cloth, static_cast<float>(options_.step_seconds / options_.substeps));
}

MotionFrame MotionRun::advance_to(Simulation& simulation, double seconds) {
    const Cloth& cloth = simulation.cloth();
    MotionFrame frame;
    const int interval =
        std::max(1, static_cast<int>(std::lround(options_.adaptation_seconds / options_.step_seconds)));
    const long last = std::lround(seconds / options_.step_seconds);
    std::vector<Vec4f> before = cloth.x;
    long first = steps_;
    while (steps_ < last) {
        if (steps_ % interval == 0) {
            adapt(simulation, frame);
            before = cloth.x;  // with the vertices that are new
            first = steps_;
        }
        step_once(simulation, frame);
    }
    if (steps_ > first)
        frame.rms_speed = rms_speed(cloth, before, static_cast<double>(steps_ - first) * options_.step_seconds);
    frame.has_bad_number = find_bad_vertex(cloth).has_value();
    return frame;
}

void MotionRun::step_once(Simulation& simulation, MotionFrame& frame) {
    const Cloth& cloth = simulation.cloth();
    Schedule part_of_step = schedule();
    const double start = seconds(), length = options_.step_seconds;
    Region region = near(cloth);
    body_at_(start + length, region, end_);
    const float motion = collider_.deformation_to(end_, region);
    const int parts =
        std::clamp(static_cast<int>(std::ceil(motion / kLongestMotion)), 1, std::min(kMostParts, options_.substeps));
    int done = 0;
    for (int part = 1; part <= parts; ++part) {
        if (part > 1) region = near(cloth);
        if (parts > 1) body_at_(start + length * part / parts, region, end_);
        collider_.move_to(end_, region);
        const int until = options_.substeps * part / parts;
        part_of_step.substeps = until - done;
        part_of_step.kinematic = pins_.follow(cloth, collider_.surface(), end_);
        simulation.step(collider_, part_of_step);
        done = until;
        collider_.arrive();
    }
    ++steps_;
    ++frame.steps;
    frame.pinched = cloth.solver->contacts.moving.pinched;
}

void MotionRun::adapt(Simulation& simulation, MotionFrame& frame) {
    const AdaptReport adapted = simulation.adapt(collider_, schedule());
    frame.adapted.splits += adapted.splits;
    frame.adapted.rejoins += adapted.rejoins;
    frame.adapted.transitions += adapted.transitions;
    update_standoffs(simulation.cloth(), collider_, {.free = options_.free_standoff});
}

Schedule MotionRun::schedule() const {
    Schedule schedule = moving(options_.air_damping);
    schedule.substeps = options_.substeps;
    return schedule;
}

PinnedFollowers::Follower PinnedFollowers::bound(const Vec3f& x, const SurfaceBvh& surface) {
    const auto closest = surface.closest(x, std::numeric_limits<float>::infinity());
    if (!closest) return {};
    const auto [a, b, c] = surface.triangles()[closest->triangle];
    const std::span<const Vec3f> points = surface.points();
    return {.is_bound = true,
            .triangle = closest->triangle,
            .shares = barycentric(x, points[a], points[b], points[c]),
            .height = surface.face_normal(closest->triangle).dot(x - points[a])};
}

Vec3f PinnedFollowers::place_of(const Follower& follower, const SurfaceBvh& surface, std::span<const Vec3f> x) {
    const auto [a, b, c] = surface.triangles()[follower.triangle];
    const Vec3f normal = (x[b] - x[a]).cross(x[c] - x[a]).stableNormalized();
    return follower.shares[0] * x[a] + follower.shares[1] * x[b] + follower.shares[2] * x[c] + follower.height * normal;
}

// An adaptation may have given an id to another vertex, which is then elsewhere.
std::span<const KinematicVertex> PinnedFollowers::follow(const Cloth& cloth, const SurfaceBvh& surface,
                                                         std::span<const Vec3f> end) {
    constexpr float kElsewhere = 0.001F;  // m, from where the follower of that id would be
    places_.clear();
    followers_.resize(cloth.x.size());
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (!cloth.is_pinned[v.value]) continue;
        const Vec3f x = cloth.x[v.value].head<3>();
        Follower& follower = followers_[v.value];
        if (!follower.is_bound || (place_of(follower, surface, surface.points()) - x).norm() > kElsewhere) {
            follower = bound(x, surface);
        }
        places_.push_back({v.value, follower.is_bound ? place_of(follower, surface, end) : x});
    }
    return places_;
}

}  // namespace selvedge::sim
