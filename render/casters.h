#pragma once
// All that casts shadows, as one mesh, and the parallel views of it that shadows and the room's light are made from.
#include <array>
#include <cstdint>
#include <vector>

#include "render/scene/scene.h"
#include "sim/core/vec.h"

namespace selvedge {

// A ball that holds all that casts shadows.
struct Bounds {
    Vec3f centre = Vec3f::Zero();
    float radius = 1;  // m

    bool operator==(const Bounds&) const = default;
};

struct Casters {
    std::vector<Vec3f> x;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    bool operator==(const Casters&) const = default;
};

Casters cloth_casters_of(const Scene& scene);
Casters body_casters_of(const Scene& scene);
Casters casters_of(const Scene& scene);  // both

Bounds bounds_of(const std::vector<Vec3f>& points);

// A somewhat larger ball, the same for points that differ a little: what is drawn within it does not swim when cloth
// moves.
Bounds steady_bounds_of(const std::vector<Vec3f>& points);

// Room to -1..1 in all three, looking from `direction` (unit) towards the ball's centre; depth grows away from it.
Eigen::Matrix4f parallel_matrix(const Bounds& bounds, const Vec3f& direction);

}  // namespace selvedge
