#pragma once
// Owners of GL objects: made with the handle, deleted with it. The context must outlive its handles and be current.
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

// A picture that stays with GL: drawn into, shown, and read back only where someone asks for it. sRGB bytes; the first
// row is the uppermost, as in an Image and in a window's memory, though GL would have it the lowest.

class PictureTexture {
 public:
    explicit PictureTexture(const GladGLContext& gl);  // empty

    // Forgets what was drawn, where the size is another.
    void resize(int width_px, int height_px);

    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }
    unsigned texture() const { return texture_.id(); }
    unsigned framebuffer() const { return framebuffer_.id(); }

    Image read() const;  // Pre: not empty

 private:
    const GladGLContext& gl_;
    Texture texture_;
    Framebuffer framebuffer_;
    int width_px_ = 0;
    int height_px_ = 0;
};

}  // namespace selvedge::render

// A GLSL program: its sources compiled and linked, its uniforms set by name.

struct GladGLContext;

namespace selvedge::render {

struct ShaderText {
    std::string name;  // for errors
    std::string text;
};

class Program {
 public:
    // The texts of a stage are joined under one #version line. Throws std::runtime_error with the compiler's words.
    Program(const GladGLContext& gl, const std::vector<ShaderText>& vertex, const std::vector<ShaderText>& fragment);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const;

    // Pre: in use. A uniform that the program does not read is passed over.
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
