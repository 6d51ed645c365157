#pragma once
// Owns the active tool and forwards user input to it. Catches GeometryError and shows it as a message. Where a drag is
// not possible, the pattern is as before the drag, and the overlay shows what was wanted and why it cannot be.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/geometry/draft.h"
#include "editor/tools/tool.h"
#include "editor/tools/tool_table.h"
#include "editor/workspace/workspace.h"

namespace selvedge::editor {

// The parts of the workspace that tools need.
struct ToolHostContext {
    Document& document;
    Hover& hover;
    Messages& messages;
    const Drape* drape = nullptr;
};

class ToolHost {
 public:
    ToolHost();

    const ToolInfo& info() const { return *info_; }

    // Switches to another tool and cancels the operation in progress. `tool` must outlive the host.
    void choose(ToolHostContext host, const ToolInfo& tool);

    // Call once per frame, before anything else. `ui_scale`: scale of the interface, 1 at 96 dpi.
    void begin_frame(const Document& document, const SheetCamera& camera, double ui_scale);

    // Mouse events of the left button, positions in screen px (see SheetCamera). The sheet's view handles panning and
    // zooming.
    void move(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers);
    void press(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers);
    void release(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers);
    void double_click(ToolHostContext host, const Vec2d& px, const Modifiers& modifiers);
    void leave(ToolHostContext host);  // the mouse is outside the view; clears the hover once

    // Each returns whether the input was used. `text` receives typed characters. `key` also handles tool shortcuts.
    bool key(ToolHostContext host, Key key, const Modifiers& modifiers);
    bool text(ToolHostContext host, std::string_view typed);
    bool cancel(ToolHostContext host);

    // Opens the box for typed numbers beside the cursor, if the tool would use one now: it drags, or shows a length of
    // what it draws. Until Enter or Escape the mouse moves nothing, and a drag does not end with the button. Returns
    // whether the box is open.
    bool ask_number(ToolHostContext host);
    bool is_asking() const { return is_asking_; }

    // Applies a command; a GeometryError becomes a message. Returns whether the command was applied.
    bool run(ToolHostContext host, const Command& command);

    ToolOverlay overlay(ToolHostContext host);
    std::string hint(ToolHostContext host);

    const SheetGeometry& geometry() const { return geometry_; }
    const TypedInput& typed() const { return typed_; }
    const SheetPointer& pointer() const { return pointer_; }

    bool is_snapping = true;
    KeyMap key_map = KeyMap::Selvedge;

 private:
    enum class MouseState { Up, Pressed, Dragging };

    ToolContext context(ToolHostContext host);
    template <class Action>
    bool guarded(ToolHostContext host, Action&& action);
    void drag(ToolContext& given);
    void drop(ToolHostContext host);
    void add_refused(ToolOverlay& overlay) const;
    bool key_unguarded(ToolHostContext host, Key key, const Modifiers& modifiers);
    bool nudge(ToolHostContext host, Key key, const Modifiers& modifiers);
    bool remove_selected(ToolHostContext host);
    bool select_all(ToolHostContext host);
    bool select_next(ToolHostContext host, bool is_back);
    bool enter_number(ToolHostContext host);
    void end_asking(ToolHostContext host);

    const ToolInfo* info_ = &default_tool();
    std::unique_ptr<Tool> tool_;
    SheetCamera camera_;
    double ui_scale_ = 1;
    SheetGeometry geometry_;
    SheetPointer pointer_;
    Vec2d pressed_px_ = Vec2d::Zero();
    MouseState state_ = MouseState::Up;
    bool is_over_ = false;
    std::optional<GeometryError> refused_;  // why the drag is not possible where the mouse is
    TypedInput typed_;
    bool is_asking_ = false;  // the box for numbers is open, also while it is empty
};

// The context from a workspace.

inline ToolHostContext tool_host_context(Workspace& workspace) {
    return {.document = *workspace.document,
            .hover = workspace.hover,
            .messages = workspace.messages,
            .drape = &workspace.drape};
}

}  // namespace selvedge::editor
