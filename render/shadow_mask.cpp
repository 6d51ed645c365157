#include "render/shadow_mask.h"

#include <array>

#include "render/gl/gl.h"
#include "render/shaders.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

enum Unit { kPlaces, kMap, kDepth, kNearest };

void make_colour(const GladGLContext& gl, const Texture& texture, const Framebuffer& framebuffer, GLint format,
                 std::array<int, 2> size_px) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, size_px[0], size_px[1], 0, GL_RGBA, GL_FLOAT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
}

}  // namespace

ShadowMask::ShadowMask(const GladGLContext& gl, int width_px, int height_px)
    : gl_(gl),
      width_px_(width_px),
      height_px_(height_px),
      program_(make_program(gl, {"screen.vert"}, {"shadow_mask.frag"})),
      no_vertices_(gl),
      compare_sampler_(gl),
      places_(gl),
      mask_(gl),
      depth_(gl),
      places_frame_(gl),
      mask_frame_(gl) {
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    make_colour(gl, mask_, mask_frame_, GL_RG32F, {width_px, height_px});
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    make_colour(gl, places_, places_frame_, GL_RGBA32F, {width_px, height_px});
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width_px, height_px);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void ShadowMask::begin() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, places_frame_.id());
    gl_.Viewport(0, 0, width_px_, height_px_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.ClearColor(0, 0, -1, -1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void ShadowMask::finish(const ShadowMap& map, float shadow_width) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, mask_frame_.id());
    gl_.Disable(GL_DEPTH_TEST);
    program_.use();
    program_.set("places", kPlaces);
    program_.set("shadow_map", kMap);
    program_.set("shadow_depth", kDepth);
    program_.set("shadow_nearest", kNearest);
    program_.set("shadow_reach", kShadowReach);
    program_.set("shadow_width", shadow_width);
    const std::array<unsigned, 4> textures{places_.id(), map.depth(), map.depth(), map.nearest()};
    for (unsigned unit = 0; unit < textures.size(); ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.BindTexture(GL_TEXTURE_2D, textures[unit]);
    }
    gl_.BindSampler(kMap, compare_sampler_.id());
    gl_.BindVertexArray(no_vertices_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindSampler(kMap, 0);
}

}  // namespace selvedge
