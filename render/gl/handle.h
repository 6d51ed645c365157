#pragma once
// Owners of GL objects: made with the handle, deleted with it. The context must outlive its handles and be current.
#include <utility>

struct GladGLContext;

namespace selvedge {

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

}  // namespace selvedge
