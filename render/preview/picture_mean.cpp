#include "render/preview/picture_mean.h"

#include "render/gl/context.h"
#include "sim/core/assert.h"

namespace selvedge::render {

PictureMean::PictureMean(const GladGLContext& gl)
    : gl_(gl),
      add_(make_program(gl, {"screen.vert"}, {"add_sample.frag"})),
      mean_(make_program(gl, {"screen.vert"}, {"encode.glsl", "mean_of_samples.frag"})),
      no_vertices_(gl),
      sum_(gl),
      framebuffer_(gl) {}

void PictureMean::clear(int width_px, int height_px) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    if (width_px != width_px_ || height_px != height_px_) {
        width_px_ = width_px;
        height_px_ = height_px;
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.BindTexture(GL_TEXTURE_2D, sum_.id());
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width_px, height_px, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sum_.id(), 0);
        require_framebuffer(gl_);
    }
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void PictureMean::fill(const Program& program, unsigned texture, unsigned framebuffer) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_.Viewport(0, 0, width_px_, height_px_);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    program.use();
    program.set("picture", 0);
    program.set("sum", 0);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.BindVertexArray(no_vertices_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void PictureMean::add(const PictureTexture& picture) {
    SELVEDGE_ASSERT(picture.width_px() == width_px_ && picture.height_px() == height_px_);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE);
    fill(add_, picture.texture(), framebuffer_.id());
    gl_.Disable(GL_BLEND);
}

void PictureMean::draw(PictureTexture& to) const {
    SELVEDGE_ASSERT(to.width_px() == width_px_ && to.height_px() == height_px_);
    gl_.Disable(GL_BLEND);
    fill(mean_, sum_.id(), to.framebuffer());
}

}  // namespace selvedge::render
