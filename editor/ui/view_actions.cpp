#include "editor/ui/view_actions.h"

#include <algorithm>

#include "editor/ui/desk.h"

namespace selvedge {
namespace {

struct ModeAction {
    const char* id;
    const char* title;
    ShowMode mode;
};

// `of`: the switch in a desk, constant or not.
template <class Of>
void add_switch(std::vector<Action>& actions, Action action, Of of) {
    action.menu = "View";
    action.run = [of](Desk& desk) { of(desk) = !of(desk); };
    action.is_on = [of](const Desk& desk) { return of(desk); };
    actions.push_back(std::move(action));
}

void add_modes(std::vector<Action>& actions) {
    constexpr ModeAction modes[] = {{"view.tartan", "Show tartan", ShowMode::Tartan},
                                    {"view.plain", "Show plain cloth", ShowMode::Plain},
                                    {"view.level", "Show levels", ShowMode::Level},
                                    {"view.edges", "Show triangles", ShowMode::Edges},
                                    {"view.strain", "Show strain", ShowMode::Strain},
                                    {"view.clearance", "Show distance from the body", ShowMode::Clearance},
                                    {"view.panels", "Show panels", ShowMode::Panels},
                                    {"view.seams", "Show seams", ShowMode::Seams}};
    for (const ModeAction& mode : modes) {
        actions.push_back({.id = mode.id,
                           .menu = "View",
                           .title = mode.title,
                           .begins_group = mode.mode == ShowMode::Tartan,
                           .run = [show = mode.mode](Desk& desk) { desk.workspace.look.show = show; },
                           .is_on = [show = mode.mode](const Desk& desk) { return desk.workspace.look.show == show; }});
    }
}

void scale_by(Desk& desk, float step) {
    constexpr float kSmallest = 0.75F, kLargest = 2.5F;
    desk.user_scale = std::clamp(desk.user_scale + step, kSmallest, kLargest);
}

void add_sizes(std::vector<Action>& actions) {
    constexpr float kStep = 0.125F;
    actions.push_back({.id = "view.larger",
                       .menu = "View",
                       .title = "Larger interface",
                       .chords = {{key_of('='), {.ctrl = true}}, {Key::KeypadAdd, {.ctrl = true}}},
                       .begins_group = true,
                       .run = [](Desk& desk) { scale_by(desk, kStep); }});
    actions.push_back({.id = "view.smaller",
                       .menu = "View",
                       .title = "Smaller interface",
                       .chords = {{key_of('-'), {.ctrl = true}}, {Key::KeypadSubtract, {.ctrl = true}}},
                       .run = [](Desk& desk) { scale_by(desk, -kStep); }});
}

}  // namespace

void add_view_actions(std::vector<Action>& actions) {
    add_switch(
        actions, {.id = "view.sheet", .title = "Pattern", .tip = "The 2D view", .chords = {{Key::F3, {}}}},
        [](auto& desk) -> auto& { return desk.layout.has_sheet; });
    add_switch(
        actions, {.id = "view.fitting", .title = "Fitting", .tip = "The 3D view", .chords = {{Key::F4, {}}}},
        [](auto& desk) -> auto& { return desk.layout.has_fitting; });
    add_switch(
        actions, {.id = "view.inspectors", .title = "Inspectors", .chords = {{Key::F5, {}}}},
        [](auto& desk) -> auto& { return desk.layout.has_inspectors; });
    add_switch(
        actions, {.id = "view.tools", .title = "Tools", .chords = {{Key::F6, {}}}},
        [](auto& desk) -> auto& { return desk.layout.has_tools; });
    add_modes(actions);
    add_switch(
        actions, {.id = "view.body", .title = "Body", .begins_group = true},
        [](auto& desk) -> auto& { return desk.workspace.look.has_body; });
    add_switch(
        actions, {.id = "view.points", .title = "Arrangement points"},
        [](auto& desk) -> auto& { return desk.workspace.look.has_points; });
    add_switch(
        actions, {.id = "view.threads", .title = "Threads of open seams"},
        [](auto& desk) -> auto& { return desk.workspace.look.has_threads; });
    add_switch(
        actions,
        {.id = "view.as_placed",
         .title = "Panels as they are placed",
         .tip = "Before sewing, also while the garment hangs",
         .chords = {{Key::F7, {}}}},
        [](auto& desk) -> auto& { return desk.workspace.look.as_placed; });
    add_switch(
        actions, {.id = "view.own_axes", .title = "Move panels along their own axes", .tip = "Else along the room's"},
        [](auto& desk) -> auto& { return desk.workspace.look.own_axes; });
    add_switch(
        actions, {.id = "view.snap", .title = "Snap to grid and points", .begins_group = true},
        [](auto& desk) -> auto& { return desk.tools.is_snapping; });
    add_sizes(actions);
}

}  // namespace selvedge
