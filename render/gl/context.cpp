#include "render/gl/context.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>
#include <array>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/core/assert.h"
#include "sim/core/atomic_file.h"
#include "sim/core/file.h"
#include "sim/core/passing_error.h"
#include "sim/core/process_memory.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace selvedge::render {
namespace {

// A library opened at run time. It is never closed, because Mesa's libraries leave threads and thread-local data
// behind.
class SharedLibrary {
 public:
    explicit SharedLibrary(const std::string& name) : handle_(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
        if (handle_ == nullptr) throw std::runtime_error(dlerror());
    }

    // Where it was found.
    std::string path() const {
        const link_map* map = nullptr;
        if (dlinfo(handle_, RTLD_DI_LINKMAP, static_cast<void*>(&map)) != 0) throw std::runtime_error(dlerror());
        return map->l_name;
    }

    template <class Function>
    Function function(const char* name) const {
        void* address = dlsym(handle_, name);
        if (address == nullptr) throw std::runtime_error(std::string("lacks ") + name);
        return reinterpret_cast<Function>(address);
    }

 private:
    void* handle_;
};

// Mesa keeps threads for the life of a process. A forked child has Mesa's state but not its threads, for which it would
// wait for ever. Set when a context is first made; 0: none was.
struct DrawingProcess {
    pid_t id = 0;
    std::string library;  // that it draws by: its path

    bool is_parent() const { return id != 0 && id != getpid(); }
};

// EGL without a surface: replaces OSMesa in newer Mesa versions, and uses a GPU if there is one.
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
            throw std::runtime_error("cannot make its context current");
        }
    }

    ContextKind maker() const override { return ContextKind::Egl; }

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
        if (context_ == EGL_NO_CONTEXT) throw std::runtime_error("cannot create a core profile context");
    }

    // Keeps the display: the process has only one, and other contexts may use it.
    void destroy() {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) egl_.destroy(display_, context_);
    }

    Egl egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

std::unique_ptr<GlContext> make_egl_context() {
    static DrawingProcess process;
    if (process.is_parent())
        throw std::runtime_error(
            "cannot draw in a process that was forked from one that has drawn (of Python's multiprocessing, use the "
            "start method spawn)");
    process.id = getpid();
    return std::make_unique<SurfacelessContext>();
}

// OSMesa: software rendering without display, device or server. Declared by hand, because its header conflicts with
// glad's.
using OSMesaHandle = struct osmesa_context*;

constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajor = 0x36, kMinor = 0x37, kRgba = 0x1908;
constexpr unsigned kUnsignedByte = 0x1401;
constexpr std::size_t kLargestLibrary = 1U << 30U;  // B, of Mesa's; today 12e6

// A copy of a library, which no process has opened, as the name of a file for dlopen().
std::string copy_of_library(const std::string& path) {
    const std::string bytes = sim::read_file(path, kLargestLibrary);
    const int file = memfd_create("libOSMesa", MFD_CLOEXEC);  // kept open: its name is good as long as it is
    if (file < 0) throw std::runtime_error("no memory for a copy of it");
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
        if (written <= 0) throw std::runtime_error("no memory for a copy of it");
        done += static_cast<std::size_t>(written);
    }
    return "/proc/self/fd/" + std::to_string(file);
}

// The library for this process: a forked child of one that has drawn opens a copy, with state and threads of its own.
SharedLibrary open_osmesa() {
    constexpr const char* kName = "libOSMesa.so.8";
    static DrawingProcess process;
    static std::string original;
    if (process.is_parent()) {
        process = {.id = getpid(), .library = copy_of_library(original)};
    } else if (process.id == 0) {
        original = SharedLibrary(kName).path();
        process = {.id = getpid(), .library = kName};
    }
    return SharedLibrary(process.library);
}

struct OSMesa {
    SharedLibrary library = open_osmesa();
    OSMesaHandle (*create)(const int*, OSMesaHandle) =
        library.function<OSMesaHandle (*)(const int*, OSMesaHandle)>("OSMesaCreateContextAttribs");
    void (*destroy)(OSMesaHandle) = library.function<void (*)(OSMesaHandle)>("OSMesaDestroyContext");
    unsigned char (*make_current)(OSMesaHandle, void*, unsigned, int, int) =
        library.function<unsigned char (*)(OSMesaHandle, void*, unsigned, int, int)>("OSMesaMakeCurrent");
    void (*(*get_proc)(const char*))() = library.function<void (*(*)(const char*))()>("OSMesaGetProcAddress");
};

class OSMesaContext final : public GlContext {
 public:
    OSMesaContext() {
        const std::array<int, 11> attributes{kFormat, kRgba, kDepthBits, 0, kProfile, kCoreProfile,
                                             kMajor,  3,     kMinor,     3, 0};
        context_ = mesa_.create(attributes.data(), nullptr);
        if (context_ == nullptr) throw std::runtime_error("cannot create a core profile context");
        make_current();
        load_functions(mesa_.get_proc);
    }

    ~OSMesaContext() override {
        mesa_.make_current(nullptr, nullptr, kUnsignedByte, 0, 0);
        mesa_.destroy(context_);
    }

    void make_current() override {
        const int side = kSide;
        if (!mesa_.make_current(context_, default_framebuffer_.data(), kUnsignedByte, side, side)) {
            throw std::runtime_error("cannot make its context current");
        }
    }

    ContextKind maker() const override { return ContextKind::OSMesa; }

 private:
    static constexpr int kSide = 4;  // px; nothing is drawn here

    OSMesa mesa_;
    OSMesaHandle context_ = nullptr;
    std::array<unsigned char, 4UL * kSide * kSide> default_framebuffer_{};
};

std::unique_ptr<GlContext> make_osmesa_context() {
    return std::make_unique<OSMesaContext>();
}

std::vector<ContextKind> makers_to_try(std::optional<ContextKind> maker) {
    if (maker) return {*maker};
    const char* requested = std::getenv("SELVEDGE_GL");
    if (requested == nullptr || *requested == '\0') return {ContextKind::OSMesa, ContextKind::Egl};
    for (const ContextKind known : {ContextKind::OSMesa, ContextKind::Egl}) {
        if (std::string_view(requested) == name(known)) return {known};
    }
    throw sim::InputError("", "SELVEDGE_GL", "'" + std::string(requested) + "' is neither osmesa nor egl");
}

std::unique_ptr<GlContext> make(ContextKind maker) {
    SELVEDGE_ASSERT(maker != ContextKind::Window);  // a window makes its own context
    return maker == ContextKind::OSMesa ? make_osmesa_context() : make_egl_context();
}

// Mesa crashes where it gets no memory. B; what its drivers map for a picture of the usual size: measured 0.85e9 with
// Mesa 22.3 and two threads.
constexpr std::size_t kDriverMemory = 900'000'000;

// For the first context: the later ones find the drivers mapped.
void require_address_space() {
    static const bool is_enough = [] {
        const std::optional<std::size_t> left = sim::address_space_left();
        if (!left || *left >= kDriverMemory) return true;
        throw sim::PassingError("", "OpenGL",
                                "drawing maps " + sim::bytes_text(kDriverMemory) +
                                    " of memory, and the limit of this process (ulimit -v) leaves " +
                                    sim::bytes_text(*left));
    }();
    SELVEDGE_ASSERT(is_enough);
}

std::string text_of(const GLubyte* text) {
    return text == nullptr ? std::string("unknown") : std::string(reinterpret_cast<const char*>(text));
}

}  // namespace

const char* name(ContextKind maker) {
    if (maker == ContextKind::Window) return "window";
    return maker == ContextKind::OSMesa ? "osmesa" : "egl";
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

int GlContext::max_samples() const {
    GLint most = 1;
    gl_->GetIntegerv(GL_MAX_SAMPLES, &most);
    return most;
}

std::string GlContext::description() const {
    return text_of(gl_->GetString(GL_RENDERER)) + ", OpenGL " + text_of(gl_->GetString(GL_VERSION));
}

namespace {

std::atomic<bool>& was_made() {
    static std::atomic<bool> made = false;
    return made;
}

}  // namespace

bool was_context_made() {
    return was_made();
}

std::unique_ptr<GlContext> make_context(std::optional<ContextKind> maker) {
    require_address_space();
    std::string reasons;
    for (const ContextKind candidate : makers_to_try(maker)) {
        try {
            auto context = make(candidate);
            was_made() = true;
            return context;  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): a unique_ptr holds it
        } catch (const std::runtime_error& error) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(name(candidate)) + ": " + error.what();
        }
    }
    throw sim::PassingError("", "OpenGL", "no way to draw without a window (" + reasons + ")");
}

}  // namespace selvedge::render
