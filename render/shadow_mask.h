#pragma once
// Where the key light is kept off, pixel by pixel of one view: first the places that are seen, then what each of them
// sees of the light.
#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/shadow_map.h"

namespace selvedge {

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

}  // namespace selvedge
