#pragma once
// Holds the tool that is at work and hands it what a person does. Errors of drafts end here, as
// messages.
#include <memory>
#include <string>
#include <vector>

#include "editor/geometry/draft.h"
#include "editor/tools/tool.h"
#include "editor/workspace/workspace.h"

namespace selvedge::editor {

// What tools work on: parts of the workspace.
struct ToolDesk {
    Document& document;
    Hover& hover;
    Messages& messages;
};

class ToolHost {
 public:
    ToolHost();

    ToolKind kind() const { return kind_; }
    const ToolInfo& info() const { return info_of(kind_); }

    // What was begun is given up.
    void choose(ToolDesk desk, ToolKind kind);

    // Once per frame, before anything else: where the sheet lies. `ui_scale`: of the interface, 1 at 96 dpi.
    void begin_frame(const Document& document, const SheetCamera& camera, double ui_scale);

    // The mouse in px of the view. Only the left button; the sheet's view pans and zooms by itself.
    void move(ToolDesk desk, const Vec2d& px, const Modifiers& modifiers);
    void press(ToolDesk desk, const Vec2d& px, const Modifiers& modifiers);
    void release(ToolDesk desk, const Vec2d& px, const Modifiers& modifiers);
    void double_click(ToolDesk desk, const Vec2d& px, const Modifiers& modifiers);
    void leave(ToolDesk desk);  // the mouse left the view

    // Return whether it was used. Text: what letters and digits write. Keys choose tools, too.
    bool key(ToolDesk desk, Key key, const Modifiers& modifiers);
    bool text(ToolDesk desk, std::string_view typed);
    bool cancel(ToolDesk desk);

    // Runs a command as tools do: an error becomes the message. Returns whether it was carried out.
    bool run(ToolDesk desk, const Command& command);

    ToolOverlay overlay(ToolDesk desk);
    std::string hint(ToolDesk desk);

    const SheetGeometry& geometry() const { return geometry_; }
    const TypedInput& typed() const { return typed_; }
    bool is_dragging() const { return state_ == MouseState::Dragging; }
    const SheetPointer& pointer() const { return pointer_; }

    bool is_snapping = true;

 private:
    enum class MouseState { Up, Pressed, Dragging };

    ToolContext context(ToolDesk desk);
    template <class Action>
    bool guarded(ToolDesk desk, Action&& action);
    bool key_unguarded(ToolDesk desk, Key key, const Modifiers& modifiers);
    bool nudge(ToolDesk desk, Key key, const Modifiers& modifiers);
    bool remove_selected(ToolDesk desk);
    bool select_all(ToolDesk desk);

    ToolKind kind_ = ToolKind::Select;
    std::unique_ptr<Tool> tool_;
    SheetCamera camera_;
    double ui_scale_ = 1;
    SheetGeometry geometry_;
    SheetPointer pointer_;
    Vec2d pressed_px_ = Vec2d::Zero();
    MouseState state_ = MouseState::Up;
    TypedInput typed_;
};

// The parts of the workspace that tools work on.

inline ToolDesk tool_desk(Workspace& workspace) {
    return {.document = *workspace.document, .hover = workspace.hover, .messages = workspace.messages};
}

}  // namespace selvedge::editor
