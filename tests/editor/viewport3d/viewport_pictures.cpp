// Writes pictures of the 3D view for inspection, of a garment placed, sewn and draped:
//   viewport_pictures patterns/tshirt.json FOLDER
#include <imgui.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "app/edit_loop.h"
#include "editor/frame/keyboard.h"
#include "editor/ui/ui_input.h"
#include "editor/viewport3d/viewport.h"
#include "render/image/image.h"
#include "render/output/interface_fonts.h"
#include "sim/core/error.h"

namespace selvedge::editor {
namespace {

constexpr float kSide = 860;  // px
constexpr UiTexture kTexture = 1;

// A surface with only the 3D view.
class ViewportSurface : public app::EditSurface {
 public:
    ViewportSurface(sim::PatternDocument document, float scale)
        : workspace(std::move(document), sim::SessionDrive::Caller, make_mannequin_body),
          context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        map_keys(io);
        const std::filesystem::path font = render::find_fonts().regular;
        if (!font.empty()) io.Fonts->AddFontFromFileTTF(font.c_str(), 15 * scale);
        io.Fonts->Build();
    }
    ~ViewportSurface() override { ImGui::DestroyContext(context_); }

    FrameOutput frame(const app::FrameInput& input) override {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {float(input.width_px), float(input.height_px)};
        io.DeltaTime = static_cast<float>(input.seconds);
        workspace.drape.update(*workspace.document, workspace.messages);
        events_.add(input.events);
        events_.begin_frame(io);
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(io.DisplaySize);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        FrameOutput output;
        const auto start = std::chrono::steady_clock::now();
        view.show({.workspace = workspace,
                   .output = output,
                   .texture = kTexture,
                   .seconds = static_cast<float>(input.seconds),
                   .scale = input.scale,
                   .choice = choice});
        spent_ms = std::max(
            spent_ms, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        ImGui::End();
        ImGui::PopStyleVar();
        ImGui::Render();
        return output;
    }

    Workspace workspace;
    Viewport view;
    ClothChoice choice = ClothChoice::Panels;
    double spent_ms = 0;

 private:
    ImGuiContext* context_;
    UiInput events_;
};

class Photographer {
 public:
    Photographer(const std::string& pattern, std::filesystem::path folder, float scale)
        : folder_(std::move(folder)),
          loop_({.width_px = int(kSide * scale), .height_px = int(kSide * scale), .scale = scale, .seconds = 0.3}),
          surface_(sim::load_pattern(pattern), scale) {}

    Workspace& workspace() { return surface_.workspace; }
    ViewportSurface& surface() { return surface_; }

    void rest(int frames) {
        for (int i = 0; i < frames; ++i) loop_.step(surface_);
    }
    void advance(int frames) {
        workspace().drape.session().advance(frames);
        rest(2);
    }
    void move_to(const Vec2f& px) {
        loop_.step(surface_, {{.kind = InputEvent::Kind::MouseMove, .x = px.x(), .y = px.y()}});
        cursor_ = px;
    }
    void button(bool is_down, MouseButton which = MouseButton::Left) {
        loop_.step(surface_, {{.kind = InputEvent::Kind::MouseButton,
                               .x = cursor_.x(),
                               .y = cursor_.y(),
                               .button = which,
                               .is_down = is_down}});
    }
    Vec2f seen(const Vec3f& x) { return surface_.view.world_to_px(x).value_or(Vec2f(0, 0)); }

    void take(const std::string& name) {
        rest(2);
        write_png(folder_ / (name + ".png"), loop_.screenshot());
        std::printf("%-14s the view took at most %.2f ms, %zu triangles\n", name.c_str(), surface_.spent_ms,
                    surface_.view.controller().garment().mesh().triangles.size());
        surface_.spent_ms = 0;
    }

 private:
    std::filesystem::path folder_;
    app::OffscreenEditLoop loop_;
    ViewportSurface surface_;
    Vec2f cursor_{0, 0};
};

void select_first(Workspace& workspace) {
    Selection first;
    first.panels.insert(workspace.document->pattern().panels.front().name);
    workspace.document->select(first);
}

void take_placed(Photographer& photographer) {
    photographer.rest(2);
    photographer.advance(0);
    photographer.take("placed");
    select_first(photographer.workspace());
    photographer.take("selected");
    const std::vector<sim::ArrangementPoint>& points = photographer.workspace().drape.current_body().points;
    for (const sim::ArrangementPoint& point : points) {
        if (point.name == "left upper arm outside")
            photographer.move_to(photographer.seen(point.position.cast<float>()));
    }
    photographer.take("point");
    photographer.rest(1);
    const Gizmo gizmo = *photographer.surface().view.controller().gizmo();
    photographer.move_to(photographer.seen(arrow_of(gizmo, 0)[1]));
    photographer.take("handle");
    photographer.button(true);
    photographer.move_to(photographer.seen(arrow_of(gizmo, 0)[1] + Vec3f(0.1F, 0, 0)));
    photographer.move_to(photographer.seen(arrow_of(gizmo, 0)[1] + Vec3f(0.15F, 0, 0)));
    photographer.take("drag");
    photographer.button(false);
    photographer.workspace().document->undo();
}

void take_draped(Photographer& photographer) {
    Workspace& workspace = photographer.workspace();
    workspace.document->select({});
    photographer.move_to({3, 3});
    workspace.drape.session().start();
    photographer.advance(12);
    photographer.take("sewing");
    photographer.advance(150);
    photographer.take("draped");
    const sim::DrawMesh& mesh = photographer.surface().view.controller().garment().mesh();
    workspace.drape.session().pin(
        {.frame = workspace.drape.frame()->number, .triangle = 40, .weights = Vec3f::Constant(1.0F / 3)});
    photographer.move_to(photographer.seen(mesh.x[mesh.triangles[mesh.triangles.size() / 4][0]]));
    photographer.button(true);
    photographer.move_to(photographer.seen(mesh.x[mesh.triangles[mesh.triangles.size() / 4][0]]) + Vec2f(90, -20));
    photographer.advance(12);
    photographer.take("pulled");
    photographer.button(false);
    workspace.drape.session().pause();
    photographer.advance(1);
    select_first(workspace);
    photographer.take("paused");
    const std::string name = workspace.document->pattern().panels.front().name;
    Selection parts;
    parts.vertices = {{name, 0}, {name, 1}};
    parts.edges = {{name, 2}, {name, 4}};
    workspace.document->select(parts);
    workspace.hover = {};
    photographer.take("parts");
    workspace.look.as_placed = true;
    photographer.take("as_placed");
}

}  // namespace
}  // namespace selvedge::editor

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    try {
        selvedge::editor::Photographer photographer(argv[1], argv[2], argc > 3 ? std::stof(argv[3]) : 1);
        selvedge::editor::take_placed(photographer);
        selvedge::editor::take_draped(photographer);
    } catch (const selvedge::sim::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
