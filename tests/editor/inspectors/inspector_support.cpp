#include "tests/editor/inspectors/inspector_support.h"

#include <imgui_internal.h>
#include <filesystem>

#include "editor/frame/keyboard.h"
#include "sim/pattern/pattern_file.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
sim::PatternDocument shipped_pattern(const std::string& file) {
    return sim::load_pattern(std::filesystem::path(source_folder()) / "patterns" / file);
}

InspectorFixture::InspectorFixture(sim::PatternDocument source, Draw draw, const WindowSize& size)
    : workspace(std::move(source), sim::SessionDrive::Caller, make_mannequin_body),
      draw_(draw),
      size_(size),
      imgui_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(imgui_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {size.width_px * size.scale, 4000 * size.scale};
    io.DeltaTime = 1.0F / 60;
    io.MousePos = {-1000, -1000};
    map_keys(io);
    ImFontConfig font;
    font.SizePixels = 13 * size.scale;
    io.Fonts->AddFontDefault(&font);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImGui::GetStyle().ScaleAllSizes(size.scale);
    frame();
}

InspectorFixture::~InspectorFixture() {
    ImGui::DestroyContext(imgui_);
}

void InspectorFixture::frame() {
    ImGui::SetCurrentContext(imgui_);
    output = {};
    widgets.clear();
    InspectorContext context{.workspace = workspace, .output = output, .state = state, .theme = theme};
    context.widgets = &widgets;
    context.take_texture = [this] { return textures_++; };
    context.open_body = [] {};
    context.open_fabric = [this] { asked.emplace_back("open fabric"); };
    context.open_fabric_picture = [this](const std::string& name) { asked.push_back("open picture for " + name); };
    context.save_fabric = [this](const std::string& name) { asked.push_back("save fabric " + name); };
    context.save_fabric_as = [this](const std::string& name) { asked.push_back("save fabric as " + name); };
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("inspectors", nullptr, ImGuiWindowFlags_NoDecoration);
    update_inspectors(context);
    ImGui::BeginChild("box");  // as the editor does
    draw_(context);
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    overhang_px_ = window.DC.CursorMaxPos.x - window.WorkRect.Max.x;
    ImGui::EndChild();
    ImGui::End();
    ImGui::Render();
}

void InspectorFixture::click(const std::string& name) {
    drag(name, 0);
    let_go();
}

void InspectorFixture::drag(const std::string& name, float by_px) {
    const Vec2f at = widgets.at(name).centre();
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {at.x(), at.y()};
    frame();
    io.MouseDown[0] = true;
    frame();
    if (by_px == 0) return;
    io.MousePos.x += by_px;
    frame();
}

void InspectorFixture::let_go() {
    ImGui::GetIO().MouseDown[0] = false;
    frame();
    frame();
}

void InspectorFixture::type(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frame();
}

void InspectorFixture::key(Key key) {
    set_key(ImGui::GetIO(), key, true);
    frame();
    set_key(ImGui::GetIO(), key, false);
    frame();
}

}  // namespace selvedge::editor
