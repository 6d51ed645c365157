#pragma once
// The host of the editor: draws its frames in a window, or offscreen for scripts and tests. Both use the same drawing
// code, so a screenshot equals what the window shows. Also: frame times, and value maps painted on the cloth.
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui_draw.h"
#include "app/window.h"
#include "editor/frame/frame.h"
#include "render/draw/renderer.h"
#include "render/marks/legend.h"
#include "render/preview/preview_renderer.h"
#include "render/scene/scene.h"

namespace selvedge::app {

// Per-frame timing of the editor; `--frame-times` writes it as a CSV file.

// Wall-clock time of the parts of one frame, ms, without the time spent waiting for input.
struct FrameTimes {
    double events_and_ui = 0;
    double scenes = 0;
    double ui_draw = 0;
    double swap = 0;

    double total() const { return events_and_ui + scenes + ui_draw + swap; }
};

class FrameTimesFile {
 public:
    // Throws InputError if the file cannot be written.
    explicit FrameTimesFile(const std::string& path);

    // Throws InputError if the disk is full.
    void add(const FrameTimes& times);

 private:
    void check_written() const;

    std::string path_;
    std::ofstream file_;
    long frame_ = 0;
};

// Colours the cloth of a scene whose mode maps values to colours (render/marks/show.h), and makes the legend. Caches
// the result of the last scene.

struct PaintedScene {
    std::shared_ptr<const render::Scene> scene;
    std::optional<render::Legend> legend;
};

class ScenePaint {
 public:
    // The same scene pointer returns the cached result. If the scene lacks the data that its mode requires, the cloth
    // is drawn plain.
    const PaintedScene& painted(const std::shared_ptr<const render::Scene>& scene);

 private:
    std::shared_ptr<const render::Scene> last_;
    PaintedScene painted_;
};

struct FrameInput {
    std::vector<editor::InputEvent> events;
    int width_px = 0;
    int height_px = 0;
    float scale = 1;     // of the interface
    double seconds = 0;  // since the previous frame; must be positive
};

class EditSurface {
 public:
    virtual ~EditSurface() = default;
    EditSurface(const EditSurface&) = delete;
    EditSurface& operator=(const EditSurface&) = delete;

    // Builds one frame. Ends with ImGui::Render() in an ImGui context that stays current.
    virtual editor::FrameOutput frame(const FrameInput& input) = 0;

 protected:
    EditSurface() = default;
};

// Draws the output of a frame. The GL context must outlive it.
class FramePainter {
 public:
    // legend_font: null: the built-in bitmap font.
    explicit FramePainter(render::GlContext& context, std::shared_ptr<const render::OutlineFont> legend_font = nullptr);

    // Draws to a framebuffer of the context that has the input's size. If `times` is given, waits for GL after each
    // part and adds the durations to it.
    editor::FrameOutput paint(EditSurface& surface, const FrameInput& input, unsigned framebuffer,
                              FrameTimes* times = nullptr);

 private:
    // The texture of a scene and the resources that are cached to draw it.
    struct SceneTexture {
        explicit SceneTexture(render::GlContext& context) : picture(context.gl()), preview(context) {}
        render::PictureTexture picture;
        render::PreviewRenderer preview;
        ScenePaint paint;
    };
    void draw_scene(const editor::SceneRequest& scene);
    void hold_legend(const editor::SceneRequest& scene, const std::optional<render::Legend>& legend);

    render::GlContext& context_;
    std::shared_ptr<const render::OutlineFont> legend_font_;
    UiDraw ui_draw_;
    std::map<editor::UiTexture, SceneTexture> scenes_;
    std::optional<render::Renderer> renderer_;  // for scenes that need full quality; made on first use
};

struct EditLoopOptions {
    std::string frame_times;       // path of a CSV file; empty: none
    std::optional<long> frames{};  // stop after this many frames; none: when the surface closes
    std::shared_ptr<const render::OutlineFont> legend_font{};
};

// Draws at most about 60 frames per second; draws none while there is no input and the surface is not animating, except
// one per 0.25 s.
// Throws InputError if the frame times cannot be written.
void run_edit_loop(EditSurface& surface, Window& window, const EditLoopOptions& options = {});

struct OffscreenOptions {
    int width_px = 1280;
    int height_px = 800;
    float scale = 1;
    double seconds = 1.0 / 60;  // s, simulated time between frames
    std::optional<render::ContextKind> maker{};
    std::shared_ptr<const render::OutlineFont> legend_font{};
};

// Runs a surface without a window. Time advances by a fixed step per frame, so the same events give the same images.
class OffscreenEditLoop {
 public:
    explicit OffscreenEditLoop(const OffscreenOptions& options = {});

    editor::FrameOutput step(EditSurface& surface, const std::vector<editor::InputEvent>& events = {},
                             FrameTimes* times = nullptr);

    render::Image screenshot() const;  // of the last step. Pre: there was one

 private:
    OffscreenOptions options_;
    std::unique_ptr<render::GlContext> context_;
    render::PictureTexture picture_;
    FramePainter painter_;
};

}  // namespace selvedge::app
