#pragma once
// An OpenGL context behind one interface. OSMesa and EGL need no window; their libraries are opened at run time, so
// that the program also starts where one is missing. A window's context is made with the window (app/window.h). One CPU
// thread owns all contexts. Pictures are drawn to framebuffers of our own, so that they are the same in every context.
// Includes glad for GL's names and function table. Every GL call goes through a context's table, so that contexts of
// two kinds can exist in one program. Other modules include this header, not glad.
#include <glad/gl.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct GladGLContext;

namespace selvedge::render {

enum class ContextKind { OSMesa, Egl, Window };

const char* name(ContextKind maker);

class GlContext {
 public:
    virtual ~GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    virtual void make_current() = 0;
    virtual ContextKind maker() const = 0;

    // GL functions of this context (core profile, version 3.3 or above). Valid as long as the context.
    const GladGLContext& gl() const { return *gl_; }

    // The driver's own names for renderer and version.
    std::string description() const;

    // Waits until GL has finished drawing, for benchmarks. Pre: the context is current.
    void finish() const;

    // Largest number of samples per pixel of a framebuffer. Pre: the context is current.
    int max_samples() const;

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

// Creates a context and makes it current. Without `maker`: the one named by the environment variable SELVEDGE_GL
// (osmesa or egl); if that is not set, OSMesa, or EGL if OSMesa is missing. Throws InputError with the reason of each
// maker if none works. Pre: no context of another kind is current; maker is not Window.
// In a forked child of a process that has drawn, contexts of OSMesa work, and EGL throws.
std::unique_ptr<GlContext> make_context(std::optional<ContextKind> maker = {});

// Whether this process, or one that it was forked from, has made a context: Mesa then keeps threads.
bool was_context_made();

}  // namespace selvedge::render
