#include "tests/editor/sheet/sheet_support.h"

#include <filesystem>

#include "app/ui_draw.h"
#include "editor/frame/keyboard.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {
namespace {

constexpr const char* kFont = "/usr/share/fonts/opentype/inter/Inter-Regular.otf";

}  // namespace

struct SheetFixture::Drawing {
    Drawing() : context(make_context(render::ContextKind::OSMesa)), drawer(*context), to(context->gl()) {}

    std::unique_ptr<render::GlContext> context;
    app::UiDraw drawer;
    render::PictureTexture to;
};

SheetFixture::SheetFixture(sim::PatternDocument source, const Size& size)
    : document(std::move(source)), size_(size), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {float(size.width_px), float(size.height_px)};
    io.DeltaTime = 1.0F / 60;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    const float font_px = 15 * float(size.ui_scale);
    static constexpr ImWchar kRanges[] = {0x20, 0x17F, 0x2010, 0x2044, 0};
    if (std::filesystem::exists(kFont)) {
        io.Fonts->AddFontFromFileTTF(kFont, font_px, nullptr, kRanges);
    } else {
        io.Fonts->AddFontDefault();
    }
    io.Fonts->Build();
    frame();
    frame();
}

SheetFixture::~SheetFixture() {
    ImGui::DestroyContext(context_);
}

void SheetFixture::frame() {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({float(size_.width_px), float(size_.height_px)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin("sheet window", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    SheetContext context{.host = {document, hover, messages}, .tools = tools, .output = output};
    context.ui_scale = size_.ui_scale;
    context.shows = shows;
    answer = view.show(context);
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::Render();
}

void SheetFixture::move(const Vec2d& sheet) {
    const Vec2d at = to_px(view.camera(), sheet);
    ImGui::GetIO().MousePos = {float(at.x()), float(at.y())};
    frame();
}

void SheetFixture::press(const Vec2d& sheet) {
    move(sheet);
    ImGui::GetIO().MouseDown[0] = true;
    frame();
}

void SheetFixture::release() {
    ImGui::GetIO().MouseDown[0] = false;
    frame();
}

void SheetFixture::click(const Vec2d& sheet, const Modifiers& modifiers) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = modifiers.ctrl;
    io.KeyShift = modifiers.shift;
    io.KeyAlt = modifiers.alt;
    press(sheet);
    release();
    io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
    for (int i = 0; i < 30; ++i) frame();  // so that two clicks are not a double click
}

void SheetFixture::drag(const Vec2d& from, const Vec2d& to) {
    press(from);
    move(from + 0.3 * (to - from));
    move(to);
    release();
    for (int i = 0; i < 30; ++i) frame();
}

void SheetFixture::wheel(const Vec2d& sheet, float notches) {
    move(sheet);
    ImGui::GetIO().MouseWheel = notches;
    frame();
}

void SheetFixture::key(Key key, const Modifiers& modifiers) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = modifiers.ctrl;
    io.KeyShift = modifiers.shift;
    io.KeyAlt = modifiers.alt;
    set_key(io, key, true);
    frame();
    set_key(io, key, false);
    io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
    frame();
}

void SheetFixture::type(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frame();
}

Vec2d SheetFixture::vertex(const std::string& panel, int index) {
    return tools.geometry().vertex({panel, index}).value();
}

Vec2d SheetFixture::on_edge(const std::string& panel, int index, double t) {
    return sheet_point(*tools.geometry().find(panel), index, t);
}

std::size_t SheetFixture::drawn_vertices() const {
    return static_cast<std::size_t>(ImGui::GetDrawData()->TotalVtxCount);
}

render::Image SheetFixture::picture() {
    if (!drawing_) drawing_ = std::make_unique<Drawing>();
    for (const TextureUpload& held : output.pictures) drawing_->drawer.hold(held);
    output.pictures.clear();
    drawing_->to.resize(size_.width_px, size_.height_px);
    drawing_->drawer.draw(app::target_of(drawing_->to));
    return drawing_->to.read();
}

sim::PatternDocument shipped_pattern(const std::string& name) {
    return sim::load_pattern(std::filesystem::path(source_folder()) / "patterns" / (name + ".json"));
}

}  // namespace selvedge::editor
