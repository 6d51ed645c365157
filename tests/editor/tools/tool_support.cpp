#include "tests/editor/tools/tool_support.h"

#include <algorithm>

#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"

namespace selvedge::editor {
sim::Panel square_panel(const std::string& name, const Vec2d& low, const Vec2d& high) {
    sim::Panel panel = make_rectangle(Vec2d(0, 0), high - low);
    panel.name = name;
    panel.sheet_position = low;
    return panel;
}

sim::PatternDocument two_squares() {
    sim::PatternDocument source;
    source.pattern.panels = {square_panel("left", {0, 0}, {0.2, 0.2}), square_panel("right", {0.3, 0}, {0.5, 0.2})};
    return source;
}

SheetUser::SheetUser(sim::PatternDocument source) : document(std::move(source)) {
    tools.begin_frame(document, camera_, 1);
}

const sim::Panel& SheetUser::panel(const std::string& name) const {
    return pattern().panels.at(static_cast<std::size_t>(find_panel(pattern(), name)));
}

Vec2d SheetUser::vertex(const std::string& panel, int index) {
    tools.begin_frame(document, camera_, 1);
    return tools.geometry().vertex({panel, index}).value();
}

void SheetUser::move(const Vec2d& sheet, const Modifiers& modifiers) {
    tools.begin_frame(document, camera_, 1);
    tools.move(host(), to_px(camera_, sheet), modifiers);
}

void SheetUser::press(const Vec2d& sheet, const Modifiers& modifiers) {
    move(sheet, modifiers);
    tools.press(host(), to_px(camera_, sheet), modifiers);
}

void SheetUser::release(const Vec2d& sheet, const Modifiers& modifiers) {
    tools.release(host(), to_px(camera_, sheet), modifiers);
}

void SheetUser::click(const Vec2d& sheet, const Modifiers& modifiers) {
    press(sheet, modifiers);
    release(sheet, modifiers);
}

void SheetUser::double_click(const Vec2d& sheet) {
    click(sheet);
    click(sheet);
    tools.double_click(host(), to_px(camera_, sheet), {});
}

void SheetUser::drag(const Vec2d& from, const Vec2d& to, const Modifiers& modifiers) {
    press(from, modifiers);
    move(from + 0.4 * (to - from), modifiers);
    move(to, modifiers);
    release(to, modifiers);
}

bool SheetUser::key(Key key, const Modifiers& modifiers) {
    return tools.key(host(), key, modifiers);
}

void SheetUser::type(const std::string& text, Key then) {
    for (const char c : text) tools.text(host(), std::string(1, c));
    if (then != Key::None) key(then);
}

ToolOverlay SheetUser::overlay() {
    return tools.overlay(host());
}

}  // namespace selvedge::editor
