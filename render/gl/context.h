#pragma once
// A place to draw, behind one interface. Two makers need no window: their libraries are opened at run time, so that the
// program starts where one is absent. A window's context is made with the window (app/window.h).
// One thread owns every context, and draws to framebuffers of its own, so that the makers' pictures are the same.
#include <glad/gl.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct GladGLContext;

namespace selvedge::render {

enum class ContextMaker { OSMesa, Egl, Window };

const char* name(ContextMaker maker);

class GlContext {
 public:
    virtual ~GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    virtual void make_current() = 0;
    virtual ContextMaker maker() const = 0;

    // The functions of this context (core profile, 3.3 or above). Valid while the context lives.
    const GladGLContext& gl() const { return *gl_; }

    // Renderer and version, as the driver names itself.
    std::string description() const;

    // Waits until all is drawn, for benchmarks. Pre: current.
    void finish() const;

    // Per pixel that a framebuffer can have. Pre: current.
    int most_samples() const;

 protected:
    using GetProcAddress = void (*(*)(const char*))();

    GlContext();
    void load_functions(GetProcAddress get_proc);  // Pre: current

 private:
    struct Deleter {
        void operator()(GladGLContext* gl) const;
    };
    std::unique_ptr<GladGLContext, Deleter> gl_;
};

// A current context by `maker`; without one, by that which the environment names in SELVEDGE_GL (osmesa or egl), or
// else OSMesa's and, where it is absent, EGL's. Throws InputError with every maker's reason when there is none.
// No other context may be current. Pre: not a window's.
std::unique_ptr<GlContext> make_context(std::optional<ContextMaker> maker = {});

}  // namespace selvedge::render

// GL's names and the type of its function table, by glad. Every use goes through a context's table (context.h), so that
// contexts of two makers can live in one program; no other room names the loader.
