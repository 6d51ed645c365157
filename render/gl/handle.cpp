#include "render/gl/handle.h"

#include "render/gl/gl.h"

namespace selvedge {

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

}  // namespace selvedge
