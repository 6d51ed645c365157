#pragma once
// Cloths, bodies and measurements shared by the tests of sim/cloth.
#include <optional>
#include <random>

#include "sim/adaptive/criteria.h"
#include "sim/body/body.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/step.h"
#include "sim/collide/body_collider.h"

namespace selvedge::sim::test {

// A body with its collider. The collider points to the body, so it cannot be copied or moved.
struct Obstacle {
    explicit Obstacle(Body shape, const DistanceFieldOptions& field = {})
        : body(std::move(shape)), collider(body, field) {}
    Obstacle(const Obstacle&) = delete;
    Obstacle& operator=(const Obstacle&) = delete;

    const Body body;
    const BodyCollider collider;
};

inline constexpr float kNoFloor = -1000.0F;  // m: out of reach

// A small sphere far away, for tests without contact.
const BodyCollider& nothing_near();
// A sphere of radius 0.15 m about (0, 1, 0).
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

// Where a patch is painted: there its triangles are split once.
inline const MinimumLevelDisc kDab{.panel = 0, .centre = Vec2f(0.05F, 0.03F), .radius = 0.04F, .level = 1};

// A vertical rectangle meshed by the garment mesher and pinned at its upper edge. The warp runs along the length.
// mesh_angle (rad): rotation of the mesher's grid against the length.
struct StripOptions {
    double width = 0.1;   // m
    double length = 1.0;  // m
    double mesh_angle = 0;
    int level = 0;  // of all leaves
};
Cloth make_strip(const Fabric& fabric, const StripOptions& options = {});

// Brings all leaves to this level. A new vertex is placed in the middle of its edge, and is pinned if both ends are.
// Updates solver lists and contact samples.
void refine(Cloth& cloth, int level);

// Displaces every leaf vertex independently and at random by up to `reach` m; velocities become zero.
void shake(Cloth& cloth, float reach, std::mt19937& random);
float draw(std::mt19937& random, float low, float high);

// Rotates about the origin, then translates. Velocities become zero.
void move_to(Cloth& cloth, const Eigen::Matrix3f& rotation, const Vec3f& shift);

double total_mass(const Cloth& cloth);  // kg, of the vertices that are not pinned
Vec3d centre_of_mass(const Cloth& cloth);

// Positions as the kernels take them: with inverse masses as w, followed by the dummy vertex.
std::vector<Vec4f> solver_points(const Cloth& cloth, const std::vector<Vec4f>& x);

// Signed distance to the exact surface, m, negative inside.
float exact_distance(const BodyCollider& body, const Vec3f& p);
float deepest(const Cloth& cloth, const BodyCollider& body);  // minimum exact distance of a leaf vertex, m

void run(Cloth& cloth, const BodyCollider& body, const StepOptions& options, double seconds);

// Mass-weighted root mean square speed, m/s: at this moment; and of the mean motion over a further run of 1/15 s.
float speed_now(const Cloth& cloth);
float speed_of_next_frames(Cloth& cloth, const BodyCollider& body, const StepOptions& options);

}  // namespace selvedge::sim::test
