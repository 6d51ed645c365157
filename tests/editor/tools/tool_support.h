#pragma once
// Simulates a user of the sheet without a screen: moves, clicks and types at sheet positions.
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/tools/tool_host.h"

namespace selvedge::editor {

// A rectangular panel that covers low to high on the sheet, m.
sim::Panel square_panel(const std::string& name, const Vec2d& low, const Vec2d& high);

// Two squares of 20 cm: "left" from (0, 0), "right" from (0.3, 0); edges 0 bottom, 1 right, 2 top, 3 left.
sim::PatternDocument two_squares();

class SheetUser {
 public:
    explicit SheetUser(sim::PatternDocument source = two_squares());

    Document document;
    Hover hover;
    Messages messages;
    ToolHost tools;

    ToolHostContext host() { return {document, hover, messages}; }
    const sim::Pattern& pattern() const { return document.pattern(); }
    const sim::Panel& panel(const std::string& name) const;
    Vec2d vertex(const std::string& panel, int index);  // on the sheet

    void choose(std::string_view id) { tools.choose(host(), info_of(id)); }
    void move(const Vec2d& sheet, const Modifiers& modifiers = {});
    void press(const Vec2d& sheet, const Modifiers& modifiers = {});
    void release(const Vec2d& sheet, const Modifiers& modifiers = {});
    void click(const Vec2d& sheet, const Modifiers& modifiers = {});
    void double_click(const Vec2d& sheet);
    void drag(const Vec2d& from, const Vec2d& to, const Modifiers& modifiers = {});
    bool key(Key key, const Modifiers& modifiers = {});
    void type(const std::string& text, Key then = Key::Enter);

    std::string message() const { return messages.shown() ? messages.shown()->text : ""; }
    ToolOverlay overlay();

 private:
    SheetCamera camera_{.centre = Vec2d(0.25, 0.1), .scale = 1000};  // px/m: one px is 1 mm
};

}  // namespace selvedge::editor
