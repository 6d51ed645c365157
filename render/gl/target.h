#pragma once
// RAII owners of GL objects: handles and what fills a buffer, a texture that holds a picture (PictureTexture), a shader
// program (Program), and the render target of one tile of a picture. The context must outlive them and be current when
// they are made, used and deleted.
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
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

// Throws PassingError if what is bound to be drawn to is incomplete: of attachments that we make, for lack of memory.
void require_framebuffer(const GladGLContext& gl);

// Binds the buffer to `target` and fills it. Allocates new storage instead of overwriting, because GL may still draw
// the previous picture from the old one. `usage` is GL_STATIC_DRAW for data drawn many times, GL_STREAM_DRAW for data
// that is soon replaced.
void upload_bytes(const GladGLContext& gl, unsigned target, const Buffer& buffer, std::span<const std::byte> data,
                  unsigned usage);

template <class T>
void upload(const GladGLContext& gl, unsigned target, const Buffer& buffer, const std::vector<T>& data,
            unsigned usage) {
    upload_bytes(gl, target, buffer, std::as_bytes(std::span(data)), usage);
}

// Reads attribute `index` of the bound vertex array from the bound buffer: `floats` numbers per vertex, the first at
// `offset`, the next vertex `stride` further on (bytes).
void add_floats(const GladGLContext& gl, unsigned index, int floats, std::size_t stride, std::size_t offset);

// The same for numbers 0..1 that are stored as bytes 0..255.
void add_bytes(const GladGLContext& gl, unsigned index, int bytes, std::size_t stride, std::size_t offset);

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

// A GLSL program: compiles and links its sources; sets uniforms by name.

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

struct TargetSize {
    int width_px = 0;  // of the finished tile
    int height_px = 0;
    int samples = 4;
    int supersample = 1;  // drawn pixels per finished pixel, in each direction

    bool operator==(const TargetSize&) const = default;
};

class Target {
 public:
    Target(const GladGLContext& gl, const TargetSize& size);

    const TargetSize& size() const { return size_; }

    void begin() const;  // binds and clears to transparent

    // Averages the samples, blends them over the backdrop and encodes. set_backdrop sets the uniforms of backdrop.glsl.
    void finish(const std::function<void(const Program&)>& set_backdrop) const;

    unsigned finished_framebuffer() const { return finished_.id(); }  // row 0 is the bottom row
    Image read() const;                                               // row 0 is the bottom row

 private:
    const GladGLContext& gl_;
    TargetSize size_;
    Program program_;
    VertexArray no_vertices_;
    Texture drawn_colour_;
    Renderbuffer drawn_depth_;
    Framebuffer drawn_;
    Texture finished_colour_;
    Framebuffer finished_;
};

// Programs from the GLSL files of shaders/, which are embedded in the executable.

// The stages' sources by file name, such as {"shadow.glsl", "place.frag"}, joined in that order.
Program make_program(const GladGLContext& gl, std::initializer_list<std::string_view> vertex,
                     std::initializer_list<std::string_view> fragment);

}  // namespace selvedge::render
