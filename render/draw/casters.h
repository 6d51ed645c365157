#pragma once
// The geometry that casts shadows, as one mesh; the parallel projection for shadows and ambient occlusion; and depth
// images along parallel rays, with the nearest and the farthest surface in each texel, for ambient occlusion. The
// images are rasterized on the CPU: faster for many small ones than reading them back from GL, and byte-identical under
// every driver.
#include <array>
#include <cstdint>
#include <vector>

#include "render/scene/scene.h"
#include "sim/core/math.h"

namespace selvedge::render {

// A sphere that contains all shadow casters.
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
Casters casters_of(const Scene& scene);  // cloths and bodies

Bounds bounds_of(const std::vector<Vec3f>& points);

// A somewhat larger sphere, quantized: it is the same for points that differ a little, so that shadows do not shimmer
// when the cloth moves.
Bounds steady_bounds_of(const std::vector<Vec3f>& points);

// World space to -1..1 on all three axes. Looks from `direction` (unit) at the centre; depth grows away from it.
Eigen::Matrix4f parallel_matrix(const Bounds& bounds, const Vec3f& direction);

// Texels in rows. Depth 0..1 in the direction of view of parallel_matrix: 0 is nearest to the viewer.
struct DepthRange {
    struct Span {
        float nearest = 2;    // initial value: no surface in this texel
        float farthest = -1;  // initial value: no surface in this texel
    };

    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();  // world space to texels (x, y) and depth (z)
    int side_px = 0;
    std::vector<Span> spans;

    const Span& at(int x, int y) const {
        return spans[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_px) + static_cast<std::size_t>(x)];
    }
};

// An image without surfaces. Pre: direction is unit.
DepthRange empty_depth_range(const Bounds& bounds, const Vec3f& direction, int side_px);

// Draws casters into the image. The result does not depend on the order of calls. Pre: triangles' indices are in range.
void draw_casters(DepthRange& picture, const Casters& casters);

}  // namespace selvedge::render
