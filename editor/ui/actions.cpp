#include "editor/ui/actions.h"

#include "editor/tools/tool_desk.h"
#include "editor/ui/desk.h"
#include "editor/ui/files.h"
#include "editor/ui/panel_actions.h"
#include "editor/ui/view_actions.h"

namespace selvedge {
namespace {

Chord ctrl(char key) {
    return {key_of(key), {.ctrl = true}};
}
Chord ctrl_shift(char key) {
    return {key_of(key), {.ctrl = true, .shift = true}};
}

void add_file_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "file.new", .menu = "File", .title = "New", .chords = {ctrl('N')}, .run = new_document});
    actions.push_back({.id = "file.open",
                       .menu = "File",
                       .title = "Open...",
                       .tip = "A garment file; files can be dropped on the window, too",
                       .chords = {ctrl('O')},
                       .run = browse_to_open});
    actions.push_back({.id = "file.save",
                       .menu = "File",
                       .title = "Save",
                       .chords = {ctrl('S')},
                       .begins_group = true,
                       .run = [](Desk& desk) { save(desk); }});
    actions.push_back({.id = "file.save_as",
                       .menu = "File",
                       .title = "Save as...",
                       .chords = {ctrl_shift('S')},
                       .run = browse_to_save});
    const auto exports = [&](const char* id, const char* title, const char* tip, const char* ending) {
        actions.push_back({.id = id,
                           .menu = "File",
                           .title = title,
                           .tip = tip,
                           .begins_group = std::string_view(ending) == ".png",
                           .run = [ending](Desk& desk) { browse_to_export(desk, ending); }});
    };
    exports("file.export_png", "Export picture...", "The 3D view as a PNG file, with shadows and fine edges", ".png");
    exports("file.export_obj", "Export OBJ...", "The garment as it hangs", ".obj");
    exports("file.export_glb", "Export GLB...", "The garment as it hangs, for other 3D programs", ".glb");
    actions.push_back({.id = "file.body",
                       .menu = "File",
                       .title = "Put on a body...",
                       .tip = "A body from an OBJ or GLB file wears the garment",
                       .begins_group = true,
                       .run = browse_for_body});
    actions.push_back({.id = "file.quit",
                       .menu = "File",
                       .title = "Quit",
                       .chords = {ctrl('Q')},
                       .begins_group = true,
                       .run = close});
}

// During a drag it takes back the drag, and nothing before it.
void undo(Desk& desk) {
    if (!desk.workspace.document->is_attempting()) return desk.workspace.document->undo();
    desk.tools.cancel(tool_desk(desk.workspace));
}

// As the sheet does with a key, wherever the cursor is.
void press_on_sheet(Desk& desk, const Chord& chord) {
    desk.tools.key(tool_desk(desk.workspace), chord.key, chord.modifiers);
}

void add_selection_actions(std::vector<Action>& actions) {
    const Chord all = ctrl('A'), remove{Key::Delete, {}};
    actions.push_back({.id = "edit.select_all",
                       .menu = "Edit",
                       .title = "Select all panels",
                       .chords = {all},
                       .begins_group = true,
                       .run = [all](Desk& desk) { press_on_sheet(desk, all); },
                       .can = [](const Desk& desk) { return !desk.workspace.document->pattern().panels.empty(); }});
    actions.push_back({.id = "edit.delete",
                       .menu = "Edit",
                       .title = "Delete what is selected",
                       .chords = {remove},
                       .run = [remove](Desk& desk) { press_on_sheet(desk, remove); },
                       .can = [](const Desk& desk) { return !desk.workspace.document->selection().is_empty(); }});
}

void add_edit_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "edit.undo",
                       .menu = "Edit",
                       .title = "Undo",
                       .chords = {ctrl('Z')},
                       .run = undo,
                       .can = [](const Desk& desk) {
                           return desk.workspace.document->can_undo() || desk.workspace.document->is_attempting();
                       }});
    actions.push_back({.id = "edit.redo",
                       .menu = "Edit",
                       .title = "Redo",
                       .chords = {ctrl('Y'), ctrl_shift('Z')},
                       .run = [](Desk& desk) { desk.workspace.document->redo(); },
                       .can = [](const Desk& desk) { return desk.workspace.document->can_redo(); }});
}

void add_simulate_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "simulate.run",
                       .menu = "Simulate",
                       .title = "Start or pause",
                       .tip = "Sews the panels and lets the garment fall; editing goes on meanwhile",
                       .chords = {{Key::Space, {}}},
                       .run =
                           [](Desk& desk) {
                               Session& session = desk.workspace.drape.session();
                               if (session.frame()->is_running) return session.pause();
                               session.start();
                           },
                       .can = [](const Desk& desk) { return !desk.workspace.document->pattern().panels.empty(); },
                       .is_on = [](const Desk& desk) { return desk.workspace.drape.frame()->is_running; }});
    actions.push_back({.id = "simulate.reset",
                       .menu = "Simulate",
                       .title = "Reset",
                       .tip = "Panels go back to where they are placed, unsewn",
                       .chords = {ctrl('R')},
                       .run = [](Desk& desk) { desk.workspace.drape.session().reset(); }});
    actions.push_back({.id = "simulate.unpin",
                       .menu = "Simulate",
                       .title = "Unpin all",
                       .tip = "Takes out the pins that were set with P in the 3D view",
                       .run = [](Desk& desk) { desk.workspace.drape.session().unpin_all(); },
                       .can = [](const Desk& desk) { return !desk.workspace.drape.frame()->pins.empty(); }});
}

void add_help_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "help.find",
                       .menu = "Help",
                       .title = "Find an action...",
                       .tip = "Type some of its letters",
                       .chords = {ctrl('K')},
                       .run = [](Desk& desk) { desk.finder.open(); }});
    actions.push_back({.id = "help.start",
                       .menu = "Help",
                       .title = "Start page",
                       .tip = "Examples, recent files and the most useful keys",
                       .chords = {{Key::F1, {}}},
                       .run = [](Desk& desk) { desk.shows_start_page = !desk.shows_start_page; },
                       .is_on = [](const Desk& desk) { return desk.shows_start_page; }});
}

// One for each tool of the sheet, by its key.
void add_tool_actions(std::vector<Action>& actions) {
    for (const ToolInfo& tool : all_tools()) {
        Action action{.id = "tool." + std::string(tool.id),
                      .menu = "Tools",
                      .title = std::string(tool.title),
                      .tip = std::string(tool.what),
                      .run = [kind = tool.kind](Desk& desk) { desk.tools.choose(tool_desk(desk.workspace), kind); },
                      .is_on = [kind = tool.kind](const Desk& desk) { return desk.tools.kind() == kind; }};
        if (tool.key != Key::None) action.chords.push_back({tool.key, {}});
        if (tool.kind == ToolKind::Select) action.chords.push_back({key_of('A'), {}});  // as in other programs
        actions.push_back(std::move(action));
    }
}

}  // namespace

std::vector<Action> make_actions() {
    std::vector<Action> actions;
    add_file_actions(actions);
    add_edit_actions(actions);
    add_panel_actions(actions);
    add_selection_actions(actions);
    add_tool_actions(actions);
    add_simulate_actions(actions);
    add_view_actions(actions);
    add_help_actions(actions);
    return actions;
}

std::vector<std::string> menu_names() {
    return {"File", "Edit", "Panel", "Seam", "Tools", "Simulate", "View", "Help"};
}

bool run_action(Desk& desk, const Action& action) {
    if (action.can && !action.can(desk)) return false;
    desk.workspace.messages.dismiss();  // an error was about what was done before
    action.run(desk);
    return true;
}

}  // namespace selvedge
