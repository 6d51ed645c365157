#include "render/gl/target.h"

#include <algorithm>
#include <span>

#include "render/gl/context.h"
#include "sim/core/assert.h"
#include "sim/core/file.h"

namespace selvedge::render {
namespace {

void check_framebuffer(const GladGLContext& gl) {
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

}  // namespace

Target::Target(const GladGLContext& gl, const TargetSize& size)
    : gl_(gl),
      size_(size),
      program_(make_program(gl, {"screen.vert"}, {"backdrop.glsl", "encode.glsl", "finish.frag"})),
      no_vertices_(gl),
      drawn_colour_(gl),
      drawn_depth_(gl),
      drawn_(gl),
      finished_colour_(gl),
      finished_(gl) {
    const int width = size.width_px * size.supersample, height = size.height_px * size.supersample;
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, drawn_colour_.id());
    gl_.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, size.samples, GL_RGBA16F, width, height, GL_TRUE);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, drawn_colour_.id(), 0);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, drawn_depth_.id());
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, size.samples, GL_DEPTH_COMPONENT32F, width, height);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, drawn_depth_.id());
    check_framebuffer(gl_);

    gl_.BindTexture(GL_TEXTURE_2D, finished_colour_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width_px, size.height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, finished_.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, finished_colour_.id(), 0);
    check_framebuffer(gl_);
}

void Target::begin() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    gl_.Viewport(0, 0, size_.width_px * size_.supersample, size_.height_px * size_.supersample);
    gl_.Enable(GL_MULTISAMPLE);
    gl_.Disable(GL_BLEND);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Target::finish(const std::function<void(const Program&)>& set_backdrop) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, finished_.id());
    gl_.Viewport(0, 0, size_.width_px, size_.height_px);
    gl_.Disable(GL_DEPTH_TEST);
    program_.use();
    set_backdrop(program_);
    program_.set("samples", size_.samples);
    program_.set("supersample", size_.supersample);
    program_.set("light", 0);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, drawn_colour_.id());
    gl_.BindVertexArray(no_vertices_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

Image Target::read() const {
    Image image(size_.width_px, size_.height_px);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, finished_.id());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, size_.width_px, size_.height_px, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

std::span<const sim::EmbeddedFile> shader_files();

namespace {

ShaderText find_shader(std::string_view name) {
    const std::span<const sim::EmbeddedFile> files = shader_files();
    const auto file = std::ranges::find(files, "shaders/" + std::string(name), &sim::EmbeddedFile::name);
    SELVEDGE_ASSERT(file != files.end());  // a shader of that name is embedded
    return {std::string(name), std::string(file->text)};
}

std::vector<ShaderText> find_shaders(std::initializer_list<std::string_view> names) {
    std::vector<ShaderText> texts;
    for (const std::string_view name : names) texts.push_back(find_shader(name));
    return texts;
}

}  // namespace

Program make_program(const GladGLContext& gl, std::initializer_list<std::string_view> vertex,
                     std::initializer_list<std::string_view> fragment) {
    return Program(gl, find_shaders(vertex), find_shaders(fragment));
}

}  // namespace selvedge::render
