#include "tests/app/edit_stand_in.h"
#include "editor/frame/keyboard.h"

#include <imgui.h>

namespace selvedge::app {
namespace {

constexpr editor::UiTexture kSceneTexture = 7;
constexpr int kSceneSide = 640;  // px at scale 1

}  // namespace

FakeEditor::FakeEditor(render::Scene scene, float turn, const std::string& font, bool is_preview)
    : context_(ImGui::CreateContext()),
      scene_(std::make_shared<const render::Scene>(std::move(scene))),
      camera_(scene_->camera),
      turn_(turn),
      is_preview_(is_preview) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    if (font.empty()) {
        io.Fonts->AddFontDefault();
    } else {
        io.Fonts->AddFontFromFileTTF(font.c_str(), 15);
    }
    io.Fonts->Build();
    editor::map_keys(io);
    io.KeyMap[ImGuiKey_Escape] = -1;  // it ends the program, and would first take back what was typed
}

FakeEditor::~FakeEditor() {
    ImGui::DestroyContext(context_);
}

editor::SceneRequest FakeEditor::scene_to_draw() {
    camera_ = turned(camera_, turn_, Vec3f::Zero());
    return {.texture = kSceneTexture,
            .scene = scene_,
            .camera = camera_,
            .light = scene_->light,
            .width_px = kSceneSide,
            .height_px = kSceneSide,
            .is_preview = is_preview_};
}

void FakeEditor::fill() {
    ImGui::SetNextWindowPos({620, 20}, ImGuiCond_Always);
    ImGui::SetNextWindowSize({kSceneSide + 16, kSceneSide + 40}, ImGuiCond_Always);
    ImGui::Begin("Scene");
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(kSceneTexture)), {kSceneSide, kSceneSide});
    ImGui::End();
    ImGui::ShowDemoWindow();
    ImGui::SetWindowPos("Dear ImGui Demo", {20, 20});  // afterwards, because the demo window sets its own position
    ImGui::SetWindowSize("Dear ImGui Demo", {560, 620});
    ImGui::SetNextWindowPos({20, 660}, ImGuiCond_Always);
    ImGui::SetNextWindowSize({560, 90}, ImGuiCond_Always);
    ImGui::Begin("Tried");
    if (ImGui::Button("Press", {100, 40})) ++presses_;
    ImGui::SameLine();
    ImGui::InputText("box", typed_.data(), typed_.size());
    ImGui::End();
}

editor::FrameOutput FakeEditor::frame(const FrameInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    for (const editor::InputEvent& event : input.events) {
        using Kind = editor::InputEvent::Kind;
        const bool is_escape = event.kind == Kind::Key && event.key == editor::Key::Escape;
        was_asked_to_close_ |= is_escape || event.kind == Kind::CloseRequest;
    }
    input_.add(input.events);
    input_.begin_frame(io);
    io.DisplaySize = {float(input.width_px), float(input.height_px)};
    io.DeltaTime = static_cast<float>(input.seconds);
    ImGui::NewFrame();
    fill();
    ImGui::Render();
    editor::FrameOutput output;
    output.window_title = "Stand-in, pressed " + std::to_string(presses_);
    output.wants_to_close = was_asked_to_close_;
    output.is_animating = turn_ != 0 || input_.has_more();
    if (turn_ != 0 || frames_ == 0) output.scenes.push_back(scene_to_draw());
    ++frames_;
    return output;
}

}  // namespace selvedge::app
