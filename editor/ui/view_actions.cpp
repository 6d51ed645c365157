// Implements add_view_actions of actions.h.
#include <algorithm>
#include <array>
#include <utility>

#include "editor/tools/tool_host.h"
#include "editor/ui/actions.h"
#include "editor/ui/app_state.h"

namespace selvedge::editor {
namespace {

struct ModeAction {
    const char* id;
    const char* title;
    render::ShowMode mode;
};

// `of` returns a reference to the flag in an AppState, const or not.
template <class Of>
void add_switch(std::vector<Action>& actions, Action action, Of of) {
    action.menu = "View";
    action.run = [of](AppState& state) { of(state) = !of(state); };
    action.is_on = [of](const AppState& state) { return of(state); };
    actions.push_back(std::move(action));
}

void add_modes(std::vector<Action>& actions) {
    constexpr ModeAction modes[] = {{"view.tartan", "Show tartan", render::ShowMode::Tartan},
                                    {"view.plain", "Show plain cloth", render::ShowMode::Plain},
                                    {"view.level", "Show levels", render::ShowMode::Level},
                                    {"view.edges", "Show triangles", render::ShowMode::Edges},
                                    {"view.strain", "Show strain", render::ShowMode::Strain},
                                    {"view.clearance", "Show distance from the body", render::ShowMode::Clearance},
                                    {"view.panels", "Show panels", render::ShowMode::Panels},
                                    {"view.seams", "Show seams", render::ShowMode::Seams}};
    for (const ModeAction& mode : modes) {
        actions.push_back(
            {.id = mode.id,
             .menu = "View",
             .title = mode.title,
             .begins_group = mode.mode == render::ShowMode::Tartan,
             .run = [show = mode.mode](AppState& state) { state.workspace.look.show = show; },
             .is_on = [show = mode.mode](const AppState& state) { return state.workspace.look.show == show; }});
    }
}

void add_keys(std::vector<Action>& actions) {
    actions.push_back({.id = "view.dark",
                       .menu = "View",
                       .title = "Dark colours",
                       .tip = "Of the interface, the sheet and the 3D view",
                       .begins_group = true,
                       .run =
                           [](AppState& state) {
                               state.is_dark = !state.is_dark;
                               save_settings(state);
                           },
                       .is_on = [](const AppState& state) { return state.is_dark; }});
    actions.push_back(
        {.id = "view.keys_marvelous",
         .menu = "View",
         .title = "Keys as in Marvelous Designer",
         .tip = "Tools, views and commands by the keys that are usual there",
         .run =
             [](AppState& state) {
                 const bool is_on = state.tools.key_map == KeyMap::MarvelousDesigner;
                 choose_key_map(state, is_on ? KeyMap::Selvedge : KeyMap::MarvelousDesigner);
             },
         .is_on = [](const AppState& state) { return state.tools.key_map == KeyMap::MarvelousDesigner; }});
}

// The inspectors' tabs by key, Ctrl+1 to Ctrl+7.
void add_tabs(std::vector<Action>& actions) {
    constexpr std::array kTabs{"Edit", "Seams", "Cloth", "Body", "Drape", "History", "Objects"};
    for (std::size_t i = 0; i < kTabs.size(); ++i) {
        actions.push_back({.id = std::string("view.tab_") + kTabs[i],
                           .menu = "View",
                           .title = std::string("Inspector ") + kTabs[i],
                           .tip = "Gives it the keyboard: Tab and the arrows go through its fields, Escape leaves it",
                           .chords = {{key_of(static_cast<char>('1' + i)), {.ctrl = true}}},
                           .begins_group = i == 0,
                           .run = [tab = static_cast<InspectorTab>(i)](AppState& state) {
                               state.layout.has_inspectors = true;
                               state.layout.wanted_tab = tab;
                               state.layout.focuses_inspector = true;
                           }});
    }
}

void scale_by(AppState& state, float step) {
    constexpr float kSmallest = 0.75F, kLargest = 2.5F;
    state.user_scale = std::clamp(state.user_scale + step, kSmallest, kLargest);
}

void add_sizes(std::vector<Action>& actions) {
    constexpr float kStep = 0.125F;
    actions.push_back({.id = "view.larger",
                       .menu = "View",
                       .title = "Larger interface",
                       .chords = {{key_of('='), {.ctrl = true}}, {Key::KeypadAdd, {.ctrl = true}}},
                       .begins_group = true,
                       .run = [](AppState& state) { scale_by(state, kStep); }});
    actions.push_back({.id = "view.smaller",
                       .menu = "View",
                       .title = "Smaller interface",
                       .chords = {{key_of('-'), {.ctrl = true}}, {Key::KeypadSubtract, {.ctrl = true}}},
                       .run = [](AppState& state) { scale_by(state, -kStep); }});
}

// Of the window.
void add_parts(std::vector<Action>& actions) {
    add_switch(
        actions, {.id = "view.sheet", .title = "Pattern", .tip = "The 2D view", .chords = {{Key::F3, {}}}},
        [](auto& state) -> auto& { return state.layout.has_sheet; });
    add_switch(
        actions, {.id = "view.fitting", .title = "3D view", .tip = "The 3D view", .chords = {{Key::F4, {}}}},
        [](auto& state) -> auto& { return state.layout.has_viewport; });
    add_switch(
        actions, {.id = "view.inspectors", .title = "Inspectors", .chords = {{Key::F5, {}}}},
        [](auto& state) -> auto& { return state.layout.has_inspectors; });
    add_switch(
        actions, {.id = "view.tools", .title = "Tools", .chords = {{Key::F6, {}}}},
        [](auto& state) -> auto& { return state.layout.has_tools; });
    add_switch(
        actions,
        {.id = "view.timeline",
         .title = "Motion",
         .tip = "The body's motion under the 3D view",
         .chords = {{Key::F8, {}}}},
        [](auto& state) -> auto& { return state.layout.has_timeline; });
}

// What the views show.
void add_contents(std::vector<Action>& actions) {
    add_switch(
        actions,
        {.id = "view.curved",
         .title = "Curved surface",
         .tip = "At rest, instead of the cloth's triangles",
         .begins_group = true},
        [](auto& state) -> auto& { return state.workspace.look.is_curved; });
    add_switch(
        actions, {.id = "view.body", .title = "Body"},
        [](auto& state) -> auto& { return state.workspace.look.has_body; });
    add_switch(
        actions, {.id = "view.points", .title = "Arrangement points"},
        [](auto& state) -> auto& { return state.workspace.look.has_points; });
    add_switch(
        actions,
        {.id = "view.joints", .title = "Joints of the body", .tip = "Dots to choose a joint by, and rings to turn it"},
        [](auto& state) -> auto& { return state.workspace.look.has_joints; });
    add_switch(
        actions, {.id = "view.threads", .title = "Lines of open seams"},
        [](auto& state) -> auto& { return state.workspace.look.has_seam_lines; });
    add_switch(
        actions,
        {.id = "view.as_placed",
         .title = "Panels as they are placed",
         .tip = "Before sewing, also while the garment hangs",
         .chords = {{Key::F7, {}}}},
        [](auto& state) -> auto& { return state.workspace.look.as_placed; });
    add_switch(
        actions, {.id = "view.own_axes", .title = "Move panels along their own axes", .tip = "Else along the room's"},
        [](auto& state) -> auto& { return state.workspace.look.own_axes; });
    add_switch(
        actions, {.id = "view.snap", .title = "Snap to grid and points", .begins_group = true},
        [](auto& state) -> auto& { return state.tools.is_snapping; });
    add_switch(
        actions,
        {.id = "view.lengths",
         .title = "Lengths of all edges",
         .tip = "On the sheet; those of selected edges are always shown"},
        [](auto& state) -> auto& { return state.sheet_shows.lengths; });
}

}  // namespace

void add_view_actions(std::vector<Action>& actions) {
    add_parts(actions);
    add_modes(actions);
    add_contents(actions);
    add_tabs(actions);
    add_keys(actions);
    add_sizes(actions);
}

}  // namespace selvedge::editor
