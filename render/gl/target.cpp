#include "render/gl/target.h"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "render/gl/context.h"
#include "sim/core/assert.h"
#include "sim/core/file.h"
#include "sim/core/passing_error.h"

namespace selvedge::render {

void require_framebuffer(const GladGLContext& gl) {
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw sim::PassingError("", "OpenGL", "not enough memory to draw a picture");
}

void upload_bytes(const GladGLContext& gl, unsigned target, const Buffer& buffer, std::span<const std::byte> data,
                  unsigned usage) {
    gl.BindBuffer(target, buffer.id());
    gl.BufferData(target, static_cast<GLsizeiptr>(data.size()), data.data(), usage);
}

void add_floats(const GladGLContext& gl, unsigned index, int floats, std::size_t stride, std::size_t offset) {
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
}

void add_bytes(const GladGLContext& gl, unsigned index, int bytes, std::size_t stride, std::size_t offset) {
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(index, bytes, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
}

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
    require_framebuffer(gl_);

    gl_.BindTexture(GL_TEXTURE_2D, finished_colour_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width_px, size.height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, finished_.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, finished_colour_.id(), 0);
    require_framebuffer(gl_);
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

unsigned make_gl_object(const GladGLContext& gl, GlObject kind) {
    GLuint id = 0;
    switch (kind) {
        case GlObject::Buffer:
            gl.GenBuffers(1, &id);
            break;
        case GlObject::VertexArray:
            gl.GenVertexArrays(1, &id);
            break;
        case GlObject::Texture:
            gl.GenTextures(1, &id);
            break;
        case GlObject::Framebuffer:
            gl.GenFramebuffers(1, &id);
            break;
        case GlObject::Renderbuffer:
            gl.GenRenderbuffers(1, &id);
            break;
        case GlObject::Sampler:
            gl.GenSamplers(1, &id);
            break;
    }
    return id;
}

void delete_gl_object(const GladGLContext& gl, GlObject kind, unsigned id) {
    switch (kind) {
        case GlObject::Buffer:
            gl.DeleteBuffers(1, &id);
            break;
        case GlObject::VertexArray:
            gl.DeleteVertexArrays(1, &id);
            break;
        case GlObject::Texture:
            gl.DeleteTextures(1, &id);
            break;
        case GlObject::Framebuffer:
            gl.DeleteFramebuffers(1, &id);
            break;
        case GlObject::Renderbuffer:
            gl.DeleteRenderbuffers(1, &id);
            break;
        case GlObject::Sampler:
            gl.DeleteSamplers(1, &id);
            break;
    }
}

PictureTexture::PictureTexture(const GladGLContext& gl) : gl_(gl), texture_(gl), framebuffer_(gl) {}

void PictureTexture::resize(int width_px, int height_px) {
    SELVEDGE_ASSERT(width_px >= 1 && height_px >= 1);
    if (width_px == width_px_ && height_px == height_px_) return;
    width_px_ = width_px;
    height_px_ = height_px;
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, texture_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
    require_framebuffer(gl_);
}

Image PictureTexture::read() const {
    SELVEDGE_ASSERT(width_px_ >= 1);
    Image image(width_px_, height_px_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, width_px_, height_px_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return image;
}

namespace {

constexpr const char* kVersionLine = "#version 330 core\n";

// The compiler's messages number the sources in this order.
std::string names_of(const std::vector<ShaderText>& texts) {
    std::string names;
    for (const ShaderText& text : texts) names += (names.empty() ? "" : "+") + text.name;
    return names;
}

template <class GetLog>
std::string read_log(GetLog get_log) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    get_log(static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

GLuint compile(const GladGLContext& gl, GLenum stage, const std::vector<ShaderText>& texts) {
    std::string source = kVersionLine;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        source += "#line 1 " + std::to_string(i) + "\n" + texts[i].text + "\n";
    }
    const GLuint shader = gl.CreateShader(stage);
    const char* pointer = source.c_str();
    gl.ShaderSource(shader, 1, &pointer, nullptr);
    gl.CompileShader(shader);
    GLint compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    const std::string log =
        read_log([&](GLsizei size, GLsizei* length, char* text) { gl.GetShaderInfoLog(shader, size, length, text); });
    gl.DeleteShader(shader);
    throw std::runtime_error("shader " + names_of(texts) + ": " + log);
}

}  // namespace

Program::Program(const GladGLContext& gl, const std::vector<ShaderText>& vertex,
                 const std::vector<ShaderText>& fragment)
    : gl_(gl) {
    const GLuint vertex_shader = compile(gl, GL_VERTEX_SHADER, vertex);
    GLuint fragment_shader = 0;
    try {
        fragment_shader = compile(gl, GL_FRAGMENT_SHADER, fragment);
    } catch (...) {
        gl.DeleteShader(vertex_shader);
        throw;
    }
    id_ = gl.CreateProgram();
    gl.AttachShader(id_, vertex_shader);
    gl.AttachShader(id_, fragment_shader);
    gl.LinkProgram(id_);
    gl.DeleteShader(vertex_shader);
    gl.DeleteShader(fragment_shader);
    GLint linked = 0;
    gl.GetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked) return;
    const std::string log =
        read_log([&](GLsizei size, GLsizei* length, char* text) { gl.GetProgramInfoLog(id_, size, length, text); });
    gl.DeleteProgram(id_);
    throw std::runtime_error("program " + names_of(vertex) + " with " + names_of(fragment) + ": " + log);
}

Program::~Program() {
    gl_.DeleteProgram(id_);
}

void Program::use() const {
    gl_.UseProgram(id_);
}

int Program::location(const char* uniform) const {
    return gl_.GetUniformLocation(id_, uniform);
}

void Program::set(const char* uniform, int value) const {
    gl_.Uniform1i(location(uniform), value);
}
void Program::set(const char* uniform, float value) const {
    gl_.Uniform1f(location(uniform), value);
}
void Program::set(const char* uniform, const Vec2f& value) const {
    gl_.Uniform2f(location(uniform), value.x(), value.y());
}
void Program::set(const char* uniform, const Vec3f& value) const {
    gl_.Uniform3f(location(uniform), value.x(), value.y(), value.z());
}
void Program::set(const char* uniform, const Eigen::Matrix4f& value) const {
    gl_.UniformMatrix4fv(location(uniform), 1, GL_FALSE, value.data());
}

}  // namespace selvedge::render
