#include "app/edit_loop.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <iomanip>
#include <thread>
#include <utility>

#include "render/marks/show.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/place/fit.h"

namespace selvedge::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned kWindowFramebuffer = 0;
constexpr double kMinPeriod = 0.016;  // s, shortest frame period: slightly less than a 60 Hz screen's
constexpr double kIdlePeriod = 0.25;  // s: the caret's blink period; limits the delay of other CPU threads' updates
constexpr int kFramesToSettle = 3;    // frames after an event: its effect shows in the next frame

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Adds the time since the last lap to one part of the frame time, after GL has finished. Does nothing without `times`.
class FrameClock {
 public:
    FrameClock(const render::GlContext& context, FrameTimes* times)
        : context_(context), times_(times), last_(Clock::now()) {}

    void lap(double FrameTimes::*part) {
        if (times_ == nullptr) return;
        context_.finish();
        times_->*part += 1e3 * seconds_since(last_);
        last_ = Clock::now();
    }

 private:
    const render::GlContext& context_;
    FrameTimes* times_;
    Clock::time_point last_;
};

// Title and cursor of the window; sets them only when they change.
class WindowDecorations {
 public:
    void put_on(Window& window, const editor::FrameOutput& output) {
        if (output.window_title != title_) window.set_title(title_ = output.window_title);
        if (output.cursor != cursor_) window.set_cursor(*(cursor_ = output.cursor));
    }

 private:
    std::string title_;
    std::optional<editor::MouseCursor> cursor_;
};

// Schedules frames: waits until the next one is due and collects its events.
class FrameScheduler {
 public:
    std::vector<editor::InputEvent> events_of_next(Window& window, bool is_animating) {
        const bool is_hidden = window.width_px() == 0;
        const bool may_wait = is_hidden || (!is_animating && frames_to_settle_ == 0);
        std::vector<editor::InputEvent> events =
            may_wait ? window.wait(kIdlePeriod) : std::vector<editor::InputEvent>{};
        const double left = kMinPeriod - seconds_since(started_);
        if (left > 0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
        for (editor::InputEvent& event : window.poll()) events.push_back(std::move(event));
        frames_to_settle_ = events.empty() ? std::max(frames_to_settle_ - 1, 0) : kFramesToSettle;
        return events;
    }

    // s, since the previous frame.
    double start_frame() {
        const double seconds = started_ == Clock::time_point{} ? 1.0 / 60 : seconds_since(started_);
        started_ = Clock::now();
        return std::clamp(seconds, 1e-4, 1.0);
    }

 private:
    Clock::time_point started_{};  // start of the last frame
    int frames_to_settle_ = kFramesToSettle;
};

}  // namespace

FramePainter::FramePainter(render::GlContext& context, std::shared_ptr<const render::OutlineFont> legend_font)
    : context_(context), legend_font_(std::move(legend_font)), ui_draw_(context) {}

editor::FrameOutput FramePainter::paint(EditSurface& surface, const FrameInput& input, unsigned framebuffer,
                                        FrameTimes* times) {
    SELVEDGE_ASSERT(input.width_px >= 1 && input.height_px >= 1 && input.scale > 0 && input.seconds > 0);
    context_.make_current();
    FrameClock clock(context_, times);
    editor::FrameOutput output = surface.frame(input);
    clock.lap(&FrameTimes::events_and_ui);
    for (const editor::TextureUpload& picture : output.pictures) ui_draw_.hold(picture);
    for (const editor::SceneRequest& scene : output.scenes) draw_scene(scene);
    clock.lap(&FrameTimes::scenes);
    ui_draw_.draw({.framebuffer = framebuffer, .width_px = input.width_px, .height_px = input.height_px});
    clock.lap(&FrameTimes::ui_draw);
    return output;
}

void FramePainter::draw_scene(const editor::SceneRequest& scene) {
    if (scene.width_px < 1 || scene.height_px < 1 || !scene.scene) return;  // a collapsed view
    const auto [found, is_new] = scenes_.try_emplace(scene.texture, context_);
    SceneTexture& drawn = found->second;
    drawn.picture.resize(scene.width_px, scene.height_px);
    render::SceneView view{.scene = scene.scene, .camera = scene.camera, .light = scene.light};
    if (scene.fills_show_mode) {
        const PaintedScene& painted = drawn.paint.painted(scene.scene);
        view.scene = painted.scene;
        if (!scene.sample) hold_legend(scene, painted.legend);
    }
    if (scene.is_preview && scene.sample) {
        drawn.preview.refine(view, *scene.sample, drawn.picture);
    } else if (scene.is_preview) {
        drawn.preview.draw(view, drawn.picture);
    } else {
        if (!renderer_) renderer_.emplace(context_);
        renderer_->draw(view, drawn.picture);
    }
    if (is_new) ui_draw_.lend(scene.texture, drawn.picture);
}

// The picture has the view's size, so that the legend appears in the view's corner; without a legend it is transparent.
void FramePainter::hold_legend(const editor::SceneRequest& scene, const std::optional<render::Legend>& legend) {
    editor::TextureUpload held{.texture = scene.legend,
                               .picture = render::Image(scene.width_px, scene.height_px, {0, 0, 0, 0})};
    if (legend) {
        render::Legend written = *legend;
        written.font = legend_font_;
        draw_legend(held.picture, written, render::Corner::LowerRight);
    }
    ui_draw_.hold(held);
}

void run_edit_loop(EditSurface& surface, Window& window, const EditLoopOptions& options) {
    std::optional<FrameTimesFile> file;
    if (!options.frame_times.empty()) file.emplace(options.frame_times);
    FramePainter painter(window.context(), options.legend_font);
    WindowDecorations dress;
    FrameScheduler pace;
    editor::FrameOutput output;
    for (long frame = 0; !output.wants_to_close && frame != options.frames; ++frame) {
        FrameInput input{.events = pace.events_of_next(window, output.is_animating),
                         .width_px = std::max(window.width_px(), 1),
                         .height_px = std::max(window.height_px(), 1),
                         .scale = window.scale(),
                         .seconds = pace.start_frame()};
        FrameTimes times;
        FrameTimes* wanted = file ? &times : nullptr;
        output = painter.paint(surface, input, kWindowFramebuffer, wanted);
        FrameClock clock(window.context(), wanted);
        dress.put_on(window, output);
        window.show();
        clock.lap(&FrameTimes::swap);
        if (file) file->add(times);
    }
}

OffscreenEditLoop::OffscreenEditLoop(const OffscreenOptions& options)
    : options_(options),
      context_(make_context(options.maker)),
      picture_(context_->gl()),
      painter_(*context_, options.legend_font) {
    picture_.resize(options.width_px, options.height_px);
}

editor::FrameOutput OffscreenEditLoop::step(EditSurface& surface, const std::vector<editor::InputEvent>& events,
                                            FrameTimes* times) {
    return painter_.paint(surface,
                          {.events = events,
                           .width_px = options_.width_px,
                           .height_px = options_.height_px,
                           .scale = options_.scale,
                           .seconds = options_.seconds},
                          picture_.framebuffer(), times);
}

render::Image OffscreenEditLoop::screenshot() const {
    return picture_.read();
}

FrameTimesFile::FrameTimesFile(const std::string& path) : path_(path), file_(path) {
    check_written();
    file_ << "frame,total_ms,events_and_ui_ms,scenes_ms,ui_draw_ms,swap_ms\n" << std::fixed << std::setprecision(3);
}

void FrameTimesFile::add(const FrameTimes& times) {
    file_ << frame_++ << ',' << times.total() << ',' << times.events_and_ui << ',' << times.scenes << ','
          << times.ui_draw << ',' << times.swap << std::endl;  // flush: readable meanwhile
    check_written();
}

void FrameTimesFile::check_written() const {
    if (!file_) throw sim::InputError(path_, "", std::string("cannot write: ") + std::strerror(errno));
}

namespace {

sim::Body body_of(const render::BodyItem& item) {
    sim::Body body;
    for (const Vec3f& x : item.x) body.x.push_back(x.cast<double>());
    for (const auto& t : item.triangles) {
        body.triangles.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
    }
    return body;
}

// Whether the scene has the data that its mode shows.
bool can_show(const render::Scene& scene) {
    if (scene.cloths.empty() || scene.cloths.front().mesh.triangles.empty()) return false;
    const render::ClothItem& cloth = scene.cloths.front();
    if (wants_material(cloth.show) && cloth.mesh.u.empty()) return false;
    return cloth.show != render::ShowMode::Hierarchy &&
           (cloth.show != render::ShowMode::Clearance || !scene.bodies.empty());
}

}  // namespace

const PaintedScene& ScenePaint::painted(const std::shared_ptr<const render::Scene>& scene) {
    if (scene == last_) return painted_;
    last_ = scene;
    auto copy = std::make_shared<render::Scene>(*scene);
    painted_.legend.reset();
    if (can_show(*copy)) {
        render::ShowInput facts;
        const render::ClothItem& cloth = copy->cloths.front();
        if (cloth.show == render::ShowMode::Clearance) {
            facts.clearance = measure_clearance(cloth.mesh.x, body_of(copy->bodies.front()));
        }
        painted_.legend = fill_show(*copy, facts);
    } else {
        for (render::ClothItem& cloth : copy->cloths) cloth.show = render::ShowMode::Plain;
    }
    painted_.scene = std::move(copy);
    return painted_;
}

}  // namespace selvedge::app
