#include "render/gl/context.h"

#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "render/gl/gl.h"
#include "render/gl/makers.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

std::vector<ContextMaker> makers_to_try(std::optional<ContextMaker> maker) {
    if (maker) return {*maker};
    const char* wished = std::getenv("SELVEDGE_GL");
    if (wished == nullptr || *wished == '\0') return {ContextMaker::OSMesa, ContextMaker::Egl};
    for (const ContextMaker known : {ContextMaker::OSMesa, ContextMaker::Egl}) {
        if (std::string_view(wished) == name(known)) return {known};
    }
    throw InputError("", "SELVEDGE_GL", "'" + std::string(wished) + "' is neither osmesa nor egl");
}

std::unique_ptr<GlContext> make(ContextMaker maker) {
    switch (maker) {
        case ContextMaker::OSMesa:
            return make_osmesa_context();
        case ContextMaker::Egl:
            return make_egl_context();
        case ContextMaker::Window:
            break;
    }
    SELVEDGE_ASSERT(!"a window makes its own context");
    return nullptr;
}

std::string text_of(const GLubyte* text) {
    return text == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(text));
}

}  // namespace

const char* name(ContextMaker maker) {
    if (maker == ContextMaker::Window) return "window";
    return maker == ContextMaker::OSMesa ? "osmesa" : "egl";
}

GlContext::GlContext() : gl_(new GladGLContext{}) {}

void GlContext::Deleter::operator()(GladGLContext* gl) const {
    delete gl;
}

void GlContext::load_functions(GetProcAddress get_proc) {
    const int version = gladLoadGLContext(gl_.get(), get_proc);
    if (version < GLAD_MAKE_VERSION(3, 3)) throw std::runtime_error("no OpenGL 3.3");
}

void GlContext::finish() const {
    gl_->Finish();
}

int GlContext::most_samples() const {
    GLint most = 1;
    gl_->GetIntegerv(GL_MAX_SAMPLES, &most);
    return most;
}

std::string GlContext::description() const {
    return text_of(gl_->GetString(GL_RENDERER)) + ", OpenGL " + text_of(gl_->GetString(GL_VERSION));
}

std::unique_ptr<GlContext> make_context(std::optional<ContextMaker> maker) {
    std::string reasons;
    for (const ContextMaker candidate : makers_to_try(maker)) {
        try {
            return make(candidate);
        } catch (const std::runtime_error& error) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(name(candidate)) + ": " + error.what();
        }
    }
    throw InputError("", "OpenGL", "no way to draw without a window (" + reasons + ")");
}

}  // namespace selvedge
