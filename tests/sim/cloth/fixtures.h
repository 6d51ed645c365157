#pragma once
// Cloths and bodies that the tests of sim/cloth share.
#include <optional>
#include <random>

#include "sim/body/body.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/body_collider.h"

namespace selvedge::sim::test {

// A body with its collider, which points to it: neither copied nor moved.
struct Obstacle {
    explicit Obstacle(Body shape, const DistanceFieldOptions& field = {})
        : body(std::move(shape)), collider(body, field) {}
    Obstacle(const Obstacle&) = delete;
    Obstacle& operator=(const Obstacle&) = delete;

    const Body body;
    const BodyCollider collider;
};

inline constexpr float kNoFloor = -1000.0F;  // m: so far down that nothing reaches it

// A small sphere that nothing reaches, for tests in which nothing is touched.
const BodyCollider& nothing_near();
// 0.15 m about (0, 1, 0).
const BodyCollider& ball();

// A shipped fabric without damping, so that motion can be compared with theory.
Fabric undamped(std::string_view name = "cotton_shirting");

// A horizontal square, centred on the y axis.
struct PatchOptions {
    double side = 0.4;    // m
    int quads = 4;        // along each side
    double height = 2.0;  // m
    int max_level = 3;
    float substep = 1.0F / 960.0F;  // s
};
Cloth make_patch(const Fabric& fabric, const PatchOptions& options = {});

// A rectangle cut by the garment mesher, its length vertical, held at both ends of its upper edge. mesh_angle (rad):
// how the mesher's grid, and with it the fabric's outline, is turned against the length; the warp runs along the
// length.
struct StripOptions {
    double width = 0.1;   // m
    double length = 1.0;  // m
    double mesh_angle = 0;
    int level = 0;  // of all leaves
};
Cloth make_strip(const Fabric& fabric, const StripOptions& options = {});

// All leaves to this level; a new vertex stands in the middle of its edge, and is pinned where both ends are. Solver
// lists and contact points are fresh.
void refine(Cloth& cloth, int level);

// Every leaf vertex up to `reach` m away from where it is, independently, at zero speed.
void shake(Cloth& cloth, float reach, std::mt19937& random);
float draw(std::mt19937& random, float low, float high);

// Turned about the origin, then moved. Speeds become zero.
void move_to(Cloth& cloth, const Eigen::Matrix3f& rotation, const Vec3f& shift);

double total_mass(const Cloth& cloth);  // kg, of what is not pinned
Vec3d centre_of_mass(const Cloth& cloth);

// Places as the solver's loops want them: with inverse masses, and the spare point behind them.
std::vector<Vec4f> solver_points(const Cloth& cloth, const std::vector<Vec4f>& x);

// Signed distance by the exact surface, m, negative inside.
float exact_distance(const BodyCollider& body, const Vec3f& p);
float deepest(const Cloth& cloth, const BodyCollider& body);  // least exact distance of a leaf vertex, m

void run(Cloth& cloth, const BodyCollider& body, const StepOptions& options, double seconds);

// Root mean square over mass, m/s: at this moment, and of the mean motion over a further run of a fifteenth of a
// second.
float speed_now(const Cloth& cloth);
float speed_of_next_frames(Cloth& cloth, const BodyCollider& body, const StepOptions& options);

}  // namespace selvedge::sim::test
