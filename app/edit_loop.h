#pragma once
// Shows whatever makes frames as the editor does: in a window, or without one, for scripts and tests. Both paint in the
// same way, so that a screenshot is what the window shows.
#include <filesystem>
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

// Where the editor's frames take their time, as a table that `--frame-times` writes.

// ms of one frame by wall clock, without waiting for the person.
struct FrameTimes {
    double events_and_ui = 0;
    double scenes = 0;
    double ui_draw = 0;
    double swap = 0;

    double total() const { return events_and_ui + scenes + ui_draw + swap; }
};

class FrameTimesFile {
 public:
    // Throws InputError when it cannot be written.
    explicit FrameTimesFile(const std::string& path);

    void add(const FrameTimes& times);

 private:
    std::ofstream file_;
    long frame_ = 0;
};

// Scenes whose mode paints figures on the cloth (render/marks/show.h), as the editor asks for them: painted once, with
// the legend beside them.

struct PaintedScene {
    std::shared_ptr<const render::Scene> scene;
    std::optional<render::Legend> legend;
};

class ScenePaint {
 public:
    // The same scene gives the same pointer. Where the mode asks for what is not there, cloth is plain.
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
    double seconds = 0;  // since the frame before; above 0
};

class EditSurface {
 public:
    virtual ~EditSurface() = default;
    EditSurface(const EditSurface&) = delete;
    EditSurface& operator=(const EditSurface&) = delete;

    // One frame; ends with ImGui::Render in an ImGui context that stays the present one.
    virtual editor::FrameOutput frame(const FrameInput& input) = 0;

 protected:
    EditSurface() = default;
};

// Draws what a frame asks for. Its context must outlive it.
class FramePainter {
 public:
    explicit FramePainter(render::GlContext& context);

    // To a framebuffer of the context that has the input's size. With times given, its parts wait for GL, and are added
    // up there.
    editor::FrameOutput paint(EditSurface& surface, const FrameInput& input, unsigned framebuffer,
                              FrameTimes* times = nullptr);

 private:
    // A scene's texture, with what is kept to draw it quickly.
    struct SceneTexture {
        explicit SceneTexture(render::GlContext& context) : picture(context.gl()), draft(context) {}
        render::PictureTexture picture;
        render::PreviewRenderer draft;
        ScenePaint paint;
    };
    void draw_scene(const editor::SceneToDraw& scene);
    void hold_legend(const editor::SceneToDraw& scene, const std::optional<render::Legend>& legend);

    render::GlContext& context_;
    UiDraw ui_draw_;
    std::map<editor::UiTexture, SceneTexture> scenes_;
    std::optional<render::Renderer> renderer_;  // for what is no draft; made when it is first asked for
};

struct EditLoopOptions {
    std::string frame_times;       // a CSV file; empty: none
    std::optional<long> frames{};  // ends after so many; else when the surface wants to close
};

// At most some sixty frames a second; none while nothing happens and the surface is not animating.
// Throws InputError when the frame times cannot be written.
void run_edit_loop(EditSurface& surface, Window& window, const EditLoopOptions& options = {});

struct OffscreenOptions {
    int width_px = 1280;
    int height_px = 800;
    float scale = 1;
    double seconds = 1.0 / 60;  // from one frame to the next
    std::optional<render::ContextMaker> maker{};
};

// A window's place without a window. Time passes by frames alone, so the same events make the same pictures.
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

// A real font for the interface, from the system's packages, found when the program runs.

struct FontFiles {
    std::filesystem::path regular;  // empty: none was found
    std::filesystem::path medium;   // for headings; the regular one where the family has no other
};

// The first family that is there: Inter, Noto Sans, DejaVu Sans. folders: where the system keeps its fonts.
FontFiles find_fonts(const std::vector<std::filesystem::path>& folders = {"/usr/share/fonts",
                                                                          "/usr/local/share/fonts"});

}  // namespace selvedge::app
