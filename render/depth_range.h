#pragma once
// The scene seen along parallel rays, from both ends at once: how near and how far along each ray there is anything.
// Drawn by the processor, so that it serves many small views faster than reading them back from GL, and has the same
// bits under every driver.
#include <vector>

#include "render/casters.h"

namespace selvedge {

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

}  // namespace selvedge
