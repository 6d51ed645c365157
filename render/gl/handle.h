#pragma once
// RAII owners of GL objects: handles, a texture that holds a picture (PictureTexture), and a shader program (Program).
// The context must outlive them and be current when they are made, used and deleted.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/image/image.h"
#include "sim/core/math.h"

struct GladGLContext;

namespace selvedge::render {

enum class GlObject { Buffer, VertexArray, Texture, Framebuffer, Renderbuffer, Sampler };

unsigned make_gl_object(const GladGLContext& gl, GlObject kind);
void delete_gl_object(const GladGLContext& gl, GlObject kind, unsigned id);

template <GlObject kind>
class Handle {
 public:
    Handle() = default;  // empty
    explicit Handle(const GladGLContext& gl) : gl_(&gl), id_(make_gl_object(gl, kind)) {}
    ~Handle() {
        if (gl_ != nullptr) delete_gl_object(*gl_, kind, id_);
    }
    Handle(Handle&& other) noexcept : gl_(std::exchange(other.gl_, nullptr)), id_(std::exchange(other.id_, 0U)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(id_, other.id_);
        return *this;
    }

    unsigned id() const { return id_; }

 private:
    const GladGLContext* gl_ = nullptr;
    unsigned id_ = 0;
};

using Buffer = Handle<GlObject::Buffer>;
using VertexArray = Handle<GlObject::VertexArray>;
using Texture = Handle<GlObject::Texture>;
using Framebuffer = Handle<GlObject::Framebuffer>;
using Renderbuffer = Handle<GlObject::Renderbuffer>;
using Sampler = Handle<GlObject::Sampler>;

// A picture in GL memory: drawn into, displayed, and read back only on request. sRGB bytes. Row 0 is the top row, as in
// an Image, although GL's convention is that row 0 is the bottom row.

class PictureTexture {
 public:
    explicit PictureTexture(const GladGLContext& gl);  // no pixels until resize()

    // Discards the picture if the size changes.
    void resize(int width_px, int height_px);

    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }
    unsigned texture() const { return texture_.id(); }
    unsigned framebuffer() const { return framebuffer_.id(); }

    Image read() const;  // Pre: resize() was called

 private:
    const GladGLContext& gl_;
    Texture texture_;
    Framebuffer framebuffer_;
    int width_px_ = 0;
    int height_px_ = 0;
};

}  // namespace selvedge::render

// A GLSL program: compiles and links its sources; sets uniforms by name.

struct GladGLContext;

namespace selvedge::render {

struct ShaderText {
    std::string name;  // for error messages
    std::string text;
};

class Program {
 public:
    // Joins the texts of each stage under one #version line. Throws std::runtime_error with the compiler's message.
    Program(const GladGLContext& gl, const std::vector<ShaderText>& vertex, const std::vector<ShaderText>& fragment);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const;

    // Pre: the program is in use. A uniform that the program does not have is ignored.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const Vec2f& value) const;
    void set(const char* uniform, const Vec3f& value) const;
    void set(const char* uniform, const Eigen::Matrix4f& value) const;

 private:
    int location(const char* uniform) const;

    const GladGLContext& gl_;
    unsigned id_ = 0;
};

}  // namespace selvedge::render
