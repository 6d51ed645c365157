#pragma once
// Inspectors in an ImGui window of no screen, with a mouse and keys of its own.
#include <imgui.h>
#include <functional>
#include <string>

#include "editor/inspectors/inspectors.h"

namespace selvedge::editor {

sim::PatternDocument shipped_pattern(const std::string& file);

struct WindowSize {
    float width_px = 300;
    float scale = 1;
};

class InspectorFixture {
 public:
    using Draw = void (*)(InspectorContext& context);

    InspectorFixture(sim::PatternDocument source, Draw draw, const WindowSize& size = {});
    ~InspectorFixture();
    InspectorFixture(const InspectorFixture&) = delete;
    InspectorFixture& operator=(const InspectorFixture&) = delete;

    void show(Draw draw) { draw_ = draw; }
    void frame();

    // By the names that inspectors give their boxes. Throws std::out_of_range when there is none.
    void click(const std::string& name);
    void drag(const std::string& name, float by_px);  // presses there and stays down
    void let_go();
    void type(const std::string& text);
    void key(ImGuiKey key);

    Workspace workspace;
    FrameOutput output;
    InspectorState state;
    Theme theme;
    WidgetMap widgets;

    Document& document() { return *workspace.document; }
    const sim::Panel& panel(std::size_t index) { return document().pattern().panels.at(index); }
    float overhang_px() const { return overhang_px_; }  // how far the last frame reached beyond the window's inside

 private:
    Draw draw_;
    WindowSize size_;
    ImGuiContext* imgui_;
    UiTexture textures_ = 1;
    float overhang_px_ = 0;
};

}  // namespace selvedge::editor
