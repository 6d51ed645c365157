#pragma once
// Inspectors in an offscreen ImGui window, with simulated mouse and keyboard input.
#include <imgui.h>
#include <functional>
#include <string>
#include <vector>

#include "editor/frame/frame.h"
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

    // These use the widgets' names. Throws std::out_of_range if there is no such widget.
    void click(const std::string& name);
    void drag(const std::string& name, float by_px);  // presses and moves; keeps the button down
    void let_go();
    void type(const std::string& text);
    void key(Key key);

    Workspace workspace;
    FrameOutput output;
    InspectorState state;
    Theme theme;
    WidgetMap widgets;
    std::vector<std::string> asked;  // of the program: "open fabric", "save fabric silk", ...

    Document& document() { return *workspace.document; }
    const sim::Panel& panel(std::size_t index) { return document().pattern().panels.at(index); }
    float overhang_px() const { return overhang_px_; }  // content beyond the window's inner width

 private:
    Draw draw_;
    WindowSize size_;
    ImGuiContext* imgui_;
    UiTexture textures_ = 1;
    float overhang_px_ = 0;
};

}  // namespace selvedge::editor
