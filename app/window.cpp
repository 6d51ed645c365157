#include "app/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/core/math.h"

namespace selvedge::app {
namespace {

[[noreturn]] void fail_to_open() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw sim::InputError("", "window",
                          std::string("cannot be opened: ") + (reason == nullptr ? "no reason given" : reason));
}

}  // namespace

// The parts of a window. They are not in the unnamed namespace, because Window::Impl has them as members: g++ warns of
// that in a batch of sources.

class GlfwLibrary {
 public:
    GlfwLibrary() {
#ifdef GLFW_PLATFORM
        // Since 3.4 GLFW looks for Wayland first, whose library complains on stderr where there is none.
        const char* wayland = std::getenv("WAYLAND_DISPLAY");
        if (wayland == nullptr || *wayland == '\0') glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
        if (!glfwInit()) fail_to_open();
    }
    ~GlfwLibrary() {
        glfwTerminate();
    }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

// The context that belongs to the window, and the window itself: the destructor releases the context before another one
// is made.
class WindowContext final : public render::GlContext {
 public:
    explicit WindowContext(const WindowOptions& options) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        glfwWindowHint(GLFW_MAXIMIZED, options.is_maximised ? GLFW_TRUE : GLFW_FALSE);
        glfwWindowHintString(GLFW_X11_CLASS_NAME, "selvedge");
        window_ = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
        if (window_ == nullptr) fail_to_open();
        try {
            make_current();
            load_functions(glfwGetProcAddress);
        } catch (const std::runtime_error& error) {
            destroy();
            throw sim::InputError("", "window", std::string("cannot be opened: ") + error.what());
        }
        glfwSwapInterval(1);
    }
    ~WindowContext() override { destroy(); }

    void make_current() override { glfwMakeContextCurrent(window_); }
    render::ContextKind maker() const override { return render::ContextKind::Window; }
    GLFWwindow* window() const { return window_; }

 private:
    void destroy() {
        glfwMakeContextCurrent(nullptr);
        glfwDestroyWindow(window_);
    }

    GLFWwindow* window_ = nullptr;
};

// GLFW's shapes for the editor's cursors; Hidden has none.
constexpr std::array<int, 6> kCursorShapes{GLFW_ARROW_CURSOR,     GLFW_IBEAM_CURSOR,   GLFW_HAND_CURSOR,
                                           GLFW_CROSSHAIR_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR};

class WindowCursors {
 public:
    WindowCursors() {
        std::transform(kCursorShapes.begin(), kCursorShapes.end(), cursors_.begin(), glfwCreateStandardCursor);
    }
    ~WindowCursors() {
        for (GLFWcursor* cursor : cursors_) glfwDestroyCursor(cursor);
    }
    WindowCursors(const WindowCursors&) = delete;
    WindowCursors& operator=(const WindowCursors&) = delete;

    // Null if the system's theme lacks the shape: GLFW then uses the default arrow.
    GLFWcursor* of(editor::MouseCursor cursor) const { return cursors_[static_cast<std::size_t>(cursor)]; }

 private:
    std::array<GLFWcursor*, kCursorShapes.size()> cursors_{};
};

// Collects events until they are taken.
class WindowEvents {
 public:
    explicit WindowEvents(GLFWwindow* window) : window_(window) {
        glfwGetCursorPos(window, &cursor_.x(), &cursor_.y());
        glfwSetWindowUserPointer(window, this);
        listen_to_mouse();
        listen_to_keys();
        glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
            editor::InputEvent event = of(w).event_at_cursor(editor::InputEvent::Kind::DropFiles);
            event.files.assign(paths, paths + count);
            of(w).events_.push_back(event);
        });
        glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int is_focused) {
            editor::InputEvent event = of(w).event_at_cursor(editor::InputEvent::Kind::Focus);
            event.is_down = is_focused != 0;
            of(w).events_.push_back(event);
        });
        glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
            glfwSetWindowShouldClose(w, GLFW_FALSE);  // the editor decides
            of(w).events_.push_back(of(w).event_at_cursor(editor::InputEvent::Kind::CloseRequest));
        });
    }
    WindowEvents(const WindowEvents&) = delete;
    WindowEvents& operator=(const WindowEvents&) = delete;

    std::vector<editor::InputEvent> take() { return std::exchange(events_, {}); }

 private:
    static WindowEvents& of(GLFWwindow* window) {
        return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
    }

    void listen_to_mouse() {
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
            of(w).cursor_ = {x, y};
            of(w).events_.push_back(of(w).event_at_cursor(editor::InputEvent::Kind::MouseMove));
        });
        // A mouse that has left points at nothing; one that drags still does.
        glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int is_within) {
            for (int button = 0; button <= GLFW_MOUSE_BUTTON_MIDDLE; ++button) {
                if (is_within != 0 || glfwGetMouseButton(w, button) == GLFW_PRESS) return;
            }
            of(w).cursor_ = {-1, -1};
            of(w).events_.push_back(of(w).event_at_cursor(editor::InputEvent::Kind::MouseMove));
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
            if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
            editor::InputEvent event = of(w).event_at_cursor(editor::InputEvent::Kind::MouseButton);
            event.button = static_cast<editor::MouseButton>(button);
            event.is_down = action == GLFW_PRESS;
            of(w).events_.push_back(event);
        });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
            editor::InputEvent event = of(w).event_at_cursor(editor::InputEvent::Kind::Wheel);
            event.x = static_cast<float>(x);
            event.y = static_cast<float>(y);
            of(w).events_.push_back(event);
        });
    }

    void listen_to_keys() {
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int code, int scancode, int action, int) {
            const char* printed = code >= 32 && code <= 96 ? glfwGetKeyName(code, scancode) : nullptr;
            editor::InputEvent event = of(w).event_at_cursor(editor::InputEvent::Kind::Key);
            event.key = key_of_code(code, printed == nullptr ? "" : printed);
            event.is_down = action != GLFW_RELEASE;
            of(w).events_.push_back(event);  // also without a known key: the modifiers may have changed
        });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code_point) {
            editor::InputEvent event = of(w).event_at_cursor(editor::InputEvent::Kind::Text);
            event.text = utf8_of(code_point);
            of(w).events_.push_back(event);
        });
    }

    editor::InputEvent event_at_cursor(editor::InputEvent::Kind kind) const {
        editor::InputEvent event{.kind = kind, .modifiers = modifiers()};
        int width = 0, height = 0, width_px = 0, height_px = 0;
        glfwGetWindowSize(window_, &width, &height);
        glfwGetFramebufferSize(window_, &width_px, &height_px);
        event.x = static_cast<float>(cursor_.x() * width_px / std::max(width, 1));
        event.y = static_cast<float>(cursor_.y() * height_px / std::max(height, 1));
        return event;
    }

    editor::Modifiers modifiers() const {
        const auto is_held = [&](int left, int right) {
            return glfwGetKey(window_, left) == GLFW_PRESS || glfwGetKey(window_, right) == GLFW_PRESS;
        };
        return {.ctrl = is_held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                .shift = is_held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                .alt = is_held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
    }

    GLFWwindow* window_;
    Vec2d cursor_{0, 0};  // cursor of the window as of the last event; it may have moved since
    std::vector<editor::InputEvent> events_;
};

struct Window::Impl {
    explicit Impl(const WindowOptions& options)
        : context(options), window(context.window()), events(window), requested_scale(options.scale) {}

    GlfwLibrary library;
    WindowContext context;
    WindowCursors cursors;
    GLFWwindow* window;
    WindowEvents events;
    std::optional<float> requested_scale;
};

Window::Window(const WindowOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Window::~Window() = default;

render::GlContext& Window::context() {
    return impl_->context;
}

int Window::width_px() const {
    int width = 0;
    glfwGetFramebufferSize(impl_->window, &width, nullptr);
    return width;
}

int Window::height_px() const {
    int height = 0;
    glfwGetFramebufferSize(impl_->window, nullptr, &height);
    return height;
}

float Window::scale() const {
    if (impl_->requested_scale) return *impl_->requested_scale;
    float x = 1, y = 1;
    glfwGetWindowContentScale(impl_->window, &x, &y);
    return std::max({x, y, 0.5F});
}

std::vector<editor::InputEvent> Window::poll() {
    glfwPollEvents();
    return impl_->events.take();
}

std::vector<editor::InputEvent> Window::wait(double seconds) {
    glfwWaitEventsTimeout(seconds);
    return impl_->events.take();
}

void Window::show() {
    glfwSwapBuffers(impl_->window);
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(impl_->window, title.c_str());
}

void Window::set_cursor(editor::MouseCursor cursor) {
    const bool is_hidden = cursor == editor::MouseCursor::Hidden;
    glfwSetInputMode(impl_->window, GLFW_CURSOR, is_hidden ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
    if (!is_hidden) glfwSetCursor(impl_->window, impl_->cursors.of(cursor));
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(impl_->window);
    return text == nullptr ? std::string{} : std::string(text);
}

void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(impl_->window, text.c_str());
}

namespace {

bool is_between(int code, editor::Key first, editor::Key last) {
    return code >= static_cast<int>(first) && code <= static_cast<int>(last);
}

}  // namespace

// The editor's key codes equal GLFW's.
editor::Key key_of_code(int code, const std::string& printed) {
    if (printed.size() == 1) {
        const char c = printed[0];
        if (c >= 'a' && c <= 'z') return editor::key_of(static_cast<char>(c - 'a' + 'A'));
        if (c >= 'A' && c <= 'Z') return editor::key_of(c);
    }
    const bool is_known = (code >= 32 && code <= 96) || is_between(code, editor::Key::Escape, editor::Key::End) ||
                          is_between(code, editor::Key::F1, editor::Key::F12) ||
                          is_between(code, editor::Key::Keypad0, editor::Key::KeypadEnter);
    return is_known ? static_cast<editor::Key>(code) : editor::Key::None;
}

std::string utf8_of(std::uint32_t code_point) {
    std::string text;
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code_point < 0x80) {
        add(code_point);
    } else if (code_point < 0x800) {
        add(0xC0 | code_point >> 6);
    } else if (code_point < 0x10000) {
        add(0xE0 | code_point >> 12);
        add(0x80 | (code_point >> 6 & 0x3F));
    } else {
        add(0xF0 | code_point >> 18);
        add(0x80 | (code_point >> 12 & 0x3F));
        add(0x80 | (code_point >> 6 & 0x3F));
    }
    if (code_point >= 0x80) add(0x80 | (code_point & 0x3F));
    return text;
}

}  // namespace selvedge::app
