#pragma once
// What all boxes and lists are given: what is worked on, and whom they tell.
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "editor/document/command.h"
#include "editor/frame/frame_output.h"
#include "editor/frame/theme.h"
#include "editor/frame/widget_map.h"
#include "editor/inspectors/inspector_state.h"
#include "editor/workspace/workspace.h"

namespace selvedge {

struct InspectorContext {
    Workspace& workspace;
    FrameOutput& output;
    InspectorState& state;
    const Theme& theme;
    const Fonts* fonts = nullptr;               // none: all in the present font
    WidgetMap* widgets = nullptr;               // gets the boxes' places; none: nobody asks
    std::function<UiTexture()> take_texture{};  // a number that nobody else has
    std::function<void()> open_body{};          // lets a body's file be chosen; unset: no button for it
    std::function<std::string(std::string_view action)> key_of{};  // "Ctrl+Z" of an action's id; unset or empty: none

    const Pattern& pattern() const { return workspace.document->pattern(); }
    const Selection& selection() const { return workspace.document->selection(); }
};

// Once per frame of the screen, whichever of the inspectors are seen: counts the drape's frames, takes over a body that
// is finished, and keeps what was being changed in a box that is gone.
void update_inspectors(InspectorContext& context);

// Each fills the present ImGui window from where it stands, as wide as it is; 17 times the font's size or more.
void draw_properties(InspectorContext& context);
void draw_seams(InspectorContext& context);
void draw_materials(InspectorContext& context);
void draw_body(InspectorContext& context);
void draw_drape(InspectorContext& context);
void draw_history(InspectorContext& context);

}  // namespace selvedge
