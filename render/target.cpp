#include "render/target.h"

#include "render/gl/gl.h"
#include "render/shaders.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

struct ColourFormat {
    GLenum internal;
    GLenum type;
};

void check_framebuffer(const GladGLContext& gl) {
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void make_colour(const GladGLContext& gl, const Framebuffer& framebuffer, const Texture& texture, ColourFormat format,
                 int width_px, int height_px) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), width_px, height_px, 0, GL_RGBA, format.type,
                  nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    check_framebuffer(gl);
}

}  // namespace

Target::Target(const GladGLContext& gl, const TargetSize& size)
    : gl_(gl),
      size_(size),
      program_(make_program(gl, {"screen.vert"}, {"finish.frag"})),
      no_vertices_(gl),
      drawn_colour_(gl),
      drawn_depth_(gl),
      drawn_(gl),
      resolved_colour_(gl),
      resolved_(gl),
      finished_colour_(gl),
      finished_(gl) {
    make_drawn(size);
    make_colour(gl, resolved_, resolved_colour_, {GL_RGBA16F, GL_HALF_FLOAT}, size.width_px * size.supersample,
                size.height_px * size.supersample);
    make_colour(gl, finished_, finished_colour_, {GL_RGBA8, GL_UNSIGNED_BYTE}, size.width_px, size.height_px);
}

void Target::make_drawn(const TargetSize& size) {
    const int width = size.width_px * size.supersample, height = size.height_px * size.supersample;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    gl_.BindRenderbuffer(GL_RENDERBUFFER, drawn_colour_.id());
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, size.samples, GL_RGBA16F, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, drawn_colour_.id());
    gl_.BindRenderbuffer(GL_RENDERBUFFER, drawn_depth_.id());
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, size.samples, GL_DEPTH_COMPONENT32F, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, drawn_depth_.id());
    check_framebuffer(gl_);
}

void Target::begin() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    gl_.Viewport(0, 0, size_.width_px * size_.supersample, size_.height_px * size_.supersample);
    gl_.Enable(GL_MULTISAMPLE);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Image Target::finish(const Vec2f& tile_origin_px) const {
    const int width = size_.width_px * size_.supersample, height = size_.height_px * size_.supersample;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
    gl_.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);

    gl_.BindFramebuffer(GL_FRAMEBUFFER, finished_.id());
    gl_.Viewport(0, 0, size_.width_px, size_.height_px);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    program_.use();
    program_.set("supersample", size_.supersample);
    program_.set("tile_origin_px", tile_origin_px);
    program_.set("light", 0);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, resolved_colour_.id());
    gl_.BindVertexArray(no_vertices_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);

    Image image(size_.width_px, size_.height_px);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, size_.width_px, size_.height_px, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

}  // namespace selvedge
