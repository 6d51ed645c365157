#pragma once
// The scene's depths as the key light sees them, and how near its nearest part is round each place, coarsely: most
// of a picture is told by that alone that nothing stands before it.
#include "render/draw/depth_range.h"
#include "render/gl/handle.h"

namespace selvedge::render {

// How far across the light a blocker is looked for, which is the softest a shadow's edge becomes, m.
inline constexpr float kShadowReach = 0.07F;

class ShadowMap {
 public:
    explicit ShadowMap(const GladGLContext& gl);

    // Uploads what casts shadows from now on.
    void load(const Casters& casters);

    // Draws the depths. matrix: room to -1..1; reach: the greatest distance at which a shadow is looked for, as a
    // share of the map's width.
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

// Where the key light is kept off, pixel by pixel of one view: first the places that are seen, then what each of them
// sees of the light.

class ShadowMask {
 public:
    ShadowMask(const GladGLContext& gl, int width_px, int height_px);

    void begin() const;  // binds and clears; surfaces are drawn next, by place.frag

    // shadow_width: m that the map spans.
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
