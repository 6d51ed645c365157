// EGL without a surface: what takes OSMesa's place in newer Mesa, and drives a GPU where there is one.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

#include "render/gl/makers.h"
#include "render/gl/shared_library.h"

namespace selvedge {
namespace {

struct Egl {
    SharedLibrary library{"libEGL.so.1"};
    PFNEGLGETPROCADDRESSPROC get_proc = library.function<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress");
    PFNEGLGETPLATFORMDISPLAYPROC get_display = library.function<PFNEGLGETPLATFORMDISPLAYPROC>("eglGetPlatformDisplay");
    PFNEGLINITIALIZEPROC initialize = library.function<PFNEGLINITIALIZEPROC>("eglInitialize");
    PFNEGLBINDAPIPROC bind_api = library.function<PFNEGLBINDAPIPROC>("eglBindAPI");
    PFNEGLCHOOSECONFIGPROC choose_config = library.function<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig");
    PFNEGLCREATECONTEXTPROC create = library.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
    PFNEGLDESTROYCONTEXTPROC destroy = library.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
    PFNEGLMAKECURRENTPROC make_current = library.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
};

class SurfacelessContext final : public GlContext {
 public:
    SurfacelessContext() {
        display_ = egl_.get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY) throw std::runtime_error("has no surfaceless display");
        if (!egl_.initialize(display_, nullptr, nullptr)) throw std::runtime_error("does not start");
        try {
            create();
            make_current();
            load_functions(egl_.get_proc);
        } catch (...) {
            destroy();
            throw;
        }
    }

    ~SurfacelessContext() override { destroy(); }

    void make_current() override {
        if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            throw std::runtime_error("does not make its context current");
        }
    }

    ContextMaker maker() const override { return ContextMaker::Egl; }

 private:
    void create() {
        const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                           EGL_NONE};
        const std::array<EGLint, 7> attributes{
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!egl_.bind_api(EGL_OPENGL_API)) throw std::runtime_error("has no OpenGL");
        if (!egl_.choose_config(display_, wanted.data(), &config, 1, &count) || count == 0) {
            throw std::runtime_error("has no configuration for OpenGL");
        }
        context_ = egl_.create(display_, config, EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT) throw std::runtime_error("makes no core profile context");
    }

    // The display stays: it is one for the whole process, and others may have contexts on it.
    void destroy() {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) egl_.destroy(display_, context_);
    }

    Egl egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() {
    return std::make_unique<SurfacelessContext>();
}

}  // namespace selvedge
