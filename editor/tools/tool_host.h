#pragma once
// Holds the tool that is at work and hands it what a person does. Errors of drafts end here: their words become the
// status message, their places are lit up.
#include <memory>
#include <string>
#include <vector>

#include "editor/drafting/draft_error.h"
#include "editor/tools/tool.h"
#include "editor/tools/typed_input.h"

namespace selvedge {

class ToolHost {
 public:
    ToolHost();

    ToolKind kind() const { return kind_; }
    const ToolInfo& info() const { return info_of(kind_); }

    // What was begun is given up.
    void choose(Document& document, ToolKind kind);

    // Once per frame, before anything else: where the sheet lies. `ui_scale`: of the interface, 1 at 96 dpi.
    void begin_frame(const Document& document, const SheetCamera& camera, double ui_scale);

    // The mouse in px of the view. Only the left button; the sheet's view pans and zooms by itself.
    void move(Document& document, const Vec2d& px, const Modifiers& modifiers);
    void press(Document& document, const Vec2d& px, const Modifiers& modifiers);
    void release(Document& document, const Vec2d& px, const Modifiers& modifiers);
    void double_click(Document& document, const Vec2d& px, const Modifiers& modifiers);
    void leave();  // the mouse left the view

    // Return whether it was used. Text: what letters and digits write. Keys choose tools, too.
    bool key(Document& document, Key key, const Modifiers& modifiers);
    bool text(Document& document, std::string_view typed);
    bool cancel(Document& document);

    // Runs a command as tools do: an error becomes the message. Returns whether it was carried out.
    bool run(Document& document, const Command& command);

    ToolOverlay overlay(Document& document);
    std::string hint(Document& document);

    const SheetGeometry& geometry() const { return geometry_; }
    const Hover& hover() const { return hover_; }
    void set_hover(const Hover& hover) { hover_ = hover; }  // of another view
    const std::string& message() const { return message_; }
    bool is_message_error() const { return is_error_; }
    const std::vector<DraftPlace>& lit_places() const { return lit_places_; }
    void clear_message();
    const TypedInput& typed() const { return typed_; }
    bool is_dragging() const { return state_ == MouseState::Dragging; }
    const SheetPointer& pointer() const { return pointer_; }

    bool is_snapping = true;

 private:
    enum class MouseState { Up, Pressed, Dragging };

    ToolContext context(Document& document);
    template <class Action>
    bool guarded(Document& document, Action&& action);
    bool key_unguarded(Document& document, Key key, const Modifiers& modifiers);
    bool nudge(Document& document, Key key, const Modifiers& modifiers);
    bool remove_selected(Document& document);
    bool select_all(Document& document);

    ToolKind kind_ = ToolKind::Select;
    std::unique_ptr<Tool> tool_;
    SheetCamera camera_;
    double ui_scale_ = 1;
    SheetGeometry geometry_;
    Hover hover_;
    SheetPointer pointer_;
    Vec2d pressed_px_ = Vec2d::Zero();
    MouseState state_ = MouseState::Up;
    TypedInput typed_;
    std::string message_;
    bool is_error_ = false;
    std::vector<DraftPlace> lit_places_;
};

}  // namespace selvedge
