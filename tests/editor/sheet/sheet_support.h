#pragma once
// The sheet without a window: simulated input goes in; ImGui's draw lists, or a picture of them, come out.
#include <imgui.h>
#include <filesystem>
#include <memory>
#include <string>

#include "editor/document/document.h"
#include "editor/sheet/sheet_view.h"
#include "editor/tools/tool_host.h"
#include "render/image/image.h"

namespace selvedge::editor {

class SheetFixture {
 public:
    struct Size {
        int width_px = 1000;
        int height_px = 760;
        double ui_scale = 1;
    };

    explicit SheetFixture(sim::PatternDocument source) : SheetFixture(std::move(source), Size{}) {}
    SheetFixture(sim::PatternDocument source, const Size& size);
    ~SheetFixture();
    SheetFixture(const SheetFixture&) = delete;
    SheetFixture& operator=(const SheetFixture&) = delete;

    Document document;
    Hover hover;
    Messages messages;
    ToolHost tools;
    SheetView view;
    SheetResult answer;  // of the last frame
    FrameOutput output;  // of all frames
    SheetVisibility shows{};

    void frame();
    void move(const Vec2d& sheet);
    void click(const Vec2d& sheet, const Modifiers& modifiers = {});
    void press(const Vec2d& sheet);
    void release();
    void drag(const Vec2d& from, const Vec2d& to);  // and releases
    void wheel(const Vec2d& sheet, float notches);
    void key(Key key, const Modifiers& modifiers = {});
    void type(const std::string& text);

    // Positions on the sheet (m) of a vertex and of a point on an edge.
    Vec2d vertex(const std::string& panel, int index);
    Vec2d on_edge(const std::string& panel, int index, double t);

    std::size_t drawn_vertices() const;  // of ImGui's lists
    render::Image picture();             // of the last frame

 private:
    struct Drawing;

    Size size_;
    ImGuiContext* context_;
    std::unique_ptr<Drawing> drawing_;
};

sim::PatternDocument shipped_pattern(const std::string& name);

}  // namespace selvedge::editor
