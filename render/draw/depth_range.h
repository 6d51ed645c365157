#pragma once
// The scene seen along parallel rays, from both ends at once: how near and how far along each ray there is anything.
// Drawn by the processor, so that it serves many small views faster than reading them back from GL, and has the same
// bits under every driver.
#include <array>
#include <cstdint>
#include <vector>

#include "render/scene/scene.h"
#include "sim/core/math.h"

namespace selvedge::render {

// All that casts shadows, as one mesh, and the parallel views of it that shadows and the room's light are made from.

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

// Texels in rows; depths in 0..1 along the view, as parallel_matrix has them.
struct DepthRange {
    struct Span {
        float nearest = 2;    // of no blocker
        float farthest = -1;  // of no blocker
    };

    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();  // room to texels (x, y) and depth (z)
    int side_px = 0;
    std::vector<Span> spans;

    const Span& at(int x, int y) const {
        return spans[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_px) + static_cast<std::size_t>(x)];
    }
};

// Nothing yet. Pre: direction is unit.
DepthRange empty_depth_range(const Bounds& bounds, const Vec3f& direction, int side_px);

// Adds casters; in which order they are added does not matter. Pre: triangles' indices are in range.
void draw_casters(DepthRange& picture, const Casters& casters);

}  // namespace selvedge::render
