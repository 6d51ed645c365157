#pragma once
// The shadow map: the scene's depths as seen from the key light, and a coarse grid of the nearest depth around each
// texel, from which the shader sees that nothing blocks the light for most of a picture. Also the shadow mask: how much
// of the key light each pixel of a view receives. Also depth images, for the shadow map and for ambient occlusion.
#include <array>
#include <cstdint>
#include <vector>

#include "render/gl/target.h"
#include "render/scene/scene.h"
#include "sim/core/math.h"

namespace selvedge::render {

// The geometry that casts shadows, as one mesh, and the parallel projection for shadows and ambient occlusion.

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

inline constexpr int kShadowMapSide = 2048;  // px

// m: radius across the light within which blockers are searched; also the largest blur radius of a shadow's edge.
inline constexpr float kShadowReach = 0.07F;

class ShadowMap {
 public:
    explicit ShadowMap(const GladGLContext& gl);

    // Uploads the shadow casters for the following calls of draw().
    void load(const Casters& casters);

    // Draws the depths. matrix: world space to -1..1; reach: radius within which blockers are searched, as a fraction
    // of the map's width.
    void draw(const Eigen::Matrix4f& matrix, float reach) const;

    unsigned depth() const { return depth_.id(); }
    unsigned nearest() const { return nearest_.id(); }

 private:
    struct View {
        unsigned framebuffer;
        int side_px;
    };
    void draw_nearest(const Program& program, const View& to, unsigned from, int cells) const;

    const GladGLContext& gl_;
    int index_count_ = 0;
    Program depth_program_, tile_program_, spread_program_;
    VertexArray vertex_array_, no_vertices_;
    Buffer positions_, indices_;
    Texture depth_, nearest_, rows_;
    Framebuffer depth_frame_, nearest_frame_, rows_frame_;
};

// How much of the key light each pixel of a view receives. First pass: the visible position in each pixel; second pass:
// the key light's visibility at that position.

class ShadowMask {
 public:
    ShadowMask(const GladGLContext& gl, int width_px, int height_px);

    void begin() const;  // binds and clears the first pass; then draw surfaces with place.frag

    // shadow_width: m, covered by the map.
    void finish(const ShadowMap& map, float shadow_width) const;

    unsigned texture() const { return mask_.id(); }

 private:
    const GladGLContext& gl_;
    int width_px_, height_px_;
    Program program_;
    VertexArray no_vertices_;
    Sampler compare_sampler_;
    Texture places_, mask_;
    Renderbuffer depth_;
    Framebuffer places_frame_, mask_frame_;
};

}  // namespace selvedge::render
