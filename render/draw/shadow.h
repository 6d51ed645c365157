#pragma once
// The shadow map: the scene's depths as seen from the key light, and a coarse grid of the nearest depth around each
// texel, from which the shader sees that nothing blocks the light for most of a picture. Also the shadow mask: how much
// of the key light each pixel of a view receives.
#include <array>
#include <cstdint>
#include <vector>

#include "render/draw/casters.h"
#include "render/gl/target.h"
#include "render/scene/scene.h"
#include "sim/core/math.h"

namespace selvedge::render {

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
