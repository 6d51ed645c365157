#include "editor/ui/actions.h"

#include <algorithm>
#include <array>
#include <utility>

#include "editor/geometry/draft.h"
#include "editor/geometry/outline_edit.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/sewing.h"
#include "editor/tools/proposal_tool.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/tool_host.h"
#include "editor/tools/underlay_tool.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"
#include "sim/core/assert.h"
#include "sim/core/printable.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

Chord ctrl(char key) {
    return {key_of(key), {.ctrl = true}};
}
Chord ctrl_shift(char key) {
    return {key_of(key), {.ctrl = true, .shift = true}};
}

// Pictures and meshes of the draped garment; the pattern for the cutting table.
void add_exports(std::vector<Action>& actions) {
    const auto exports = [&](const char* id, const char* title, const char* tip, const char* ending) {
        actions.push_back({.id = id,
                           .menu = "File",
                           .title = title,
                           .tip = tip,
                           .begins_group = std::string_view(ending) == ".png",
                           .run = [ending](AppState& state) { browse_to_export(state, ending); }});
    };
    exports("file.export_png", "Export picture...", "The 3D view as a PNG file, with shadows and fine edges", ".png");
    exports("file.export_obj", "Export OBJ...", "The draped garment", ".obj");
    exports("file.export_glb", "Export GLB...", "The draped garment, for other 3D programs", ".glb");
    exports("file.export_ply", "Export PLY...", "The draped garment, with the panel of each vertex", ".ply");
    exports("file.export_stl", "Export STL...", "The draped garment in millimetres, for 3D printers", ".stl");
    const auto prints = [&](const char* id, const char* title, const char* tip, const char* ending) {
        actions.push_back(
            {.id = id,
             .menu = "File",
             .title = title,
             .tip = tip,
             .begins_group = std::string_view(ending) == ".pdf",
             .run = [ending](AppState& state) { browse_to_print(state, ending); },
             .can = [](const AppState& state) { return !state.workspace.document->pattern().panels.empty(); }});
        if (std::string_view(ending) == ".pdf") actions.back().chords = {ctrl('P')};
    };
    prints("file.print", "Print pattern...", "At true size on A4 pages with a test square, as PDF", ".pdf");
    prints("file.print_svg", "Export pattern SVG...", "At true size, a layer for each kind of line", ".svg");
    prints("file.print_dxf", "Export pattern DXF...", "DXF-AAMA, for other pattern programs and cutters", ".dxf");
}

void add_file_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "file.new", .menu = "File", .title = "New", .chords = {ctrl('N')}, .run = new_document});
    actions.push_back({.id = "file.open",
                       .menu = "File",
                       .title = "Open...",
                       .tip = "A garment file; files can be dropped on the window, too",
                       .chords = {ctrl('O')},
                       .run = browse_to_open});
    actions.push_back(
        {.id = "file.import",
         .menu = "File",
         .title = "Import...",
         .tip = "A pattern of another program (SVG, DXF, PDF, FreeSewing's data), or a photo to trace (PNG, JPEG)",
         .chords = {ctrl('I')},
         .run = browse_to_import});
    actions.push_back(
        {.id = "file.wear_over",
         .menu = "File",
         .title = "Wear over...",
         .tip = "Another garment file, worn over this one as the outermost",
         .run = browse_to_wear_over,
         .can = [](const AppState& state) { return !state.workspace.document->pattern().panels.empty(); }});
    actions.push_back({.id = "file.save",
                       .menu = "File",
                       .title = "Save",
                       .chords = {ctrl('S')},
                       .begins_group = true,
                       .run = [](AppState& state) { save(state); }});
    actions.push_back({.id = "file.save_as",
                       .menu = "File",
                       .title = "Save as...",
                       .chords = {ctrl_shift('S')},
                       .run = browse_to_save});
    add_exports(actions);
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

// During a drag, cancels the drag instead of undoing a command.
void undo(AppState& state) {
    if (!state.workspace.document->is_previewing()) return state.workspace.document->undo();
    state.tools.cancel(tool_host_context(state.workspace));
}

// Sends the key to the sheet's tools, wherever the cursor is.
void press_on_sheet(AppState& state, const Chord& chord) {
    state.tools.key(tool_host_context(state.workspace), chord.key, chord.modifiers);
}

void add_selection_actions(std::vector<Action>& actions) {
    const Chord all = ctrl('A'), remove{Key::Delete, {}};
    actions.push_back(
        {.id = "edit.select_all",
         .menu = "Edit",
         .title = "Select all panels",
         .chords = {all},
         .begins_group = true,
         .run = [all](AppState& state) { press_on_sheet(state, all); },
         .can = [](const AppState& state) { return !state.workspace.document->pattern().panels.empty(); }});
    actions.push_back(
        {.id = "edit.fit_photo",
         .menu = "Edit",
         .title = "Fit photo",
         .tip = "Click two points of the photo under the sheet and type how far apart they are",
         .run = [](AppState& state) { state.tools.choose(tool_host_context(state.workspace), underlay_tool()); },
         .can = [](const AppState& state) { return !state.workspace.document->pattern().underlays.empty(); }});
    actions.push_back({.id = "edit.delete",
                       .menu = "Edit",
                       .title = "Delete what is selected",
                       .chords = {remove},
                       .run = [remove](AppState& state) { press_on_sheet(state, remove); },
                       .can = [](const AppState& state) { return !state.workspace.document->selection().is_empty(); }});
}

void add_edit_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "edit.undo",
                       .menu = "Edit",
                       .title = "Undo",
                       .chords = {ctrl('Z')},
                       .run = undo,
                       .can = [](const AppState& state) {
                           return state.workspace.document->can_undo() || state.workspace.document->is_previewing();
                       }});
    actions.push_back({.id = "edit.redo",
                       .menu = "Edit",
                       .title = "Redo",
                       .chords = {ctrl('Y'), ctrl_shift('Z')},
                       .run = [](AppState& state) { state.workspace.document->redo(); },
                       .can = [](const AppState& state) { return state.workspace.document->can_redo(); }});
}

void add_simulate_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "simulate.run",
                       .menu = "Simulate",
                       .title = "Start or pause",
                       .tip = "Sews the panels and lets the garment fall; editing goes on meanwhile",
                       .chords = {{Key::Space, {}}},
                       .run =
                           [](AppState& state) {
                               sim::Session& session = state.workspace.drape.session();
                               if (session.frame()->is_running) return session.pause();
                               session.start();
                           },
                       .can = [](const AppState& state) { return !state.workspace.document->pattern().panels.empty(); },
                       .is_on = [](const AppState& state) { return state.workspace.drape.frame()->is_running; }});
    actions.push_back({.id = "simulate.reset",
                       .menu = "Simulate",
                       .title = "Reset",
                       .tip = "Panels go back to where they are placed, unsewn",
                       .chords = {ctrl('R')},
                       .run = [](AppState& state) { state.workspace.drape.reset(); }});
    actions.push_back({.id = "simulate.unpin",
                       .menu = "Simulate",
                       .title = "Unpin all",
                       .tip = "Takes out the pins that were set in the 3D view",
                       .run = [](AppState& state) { state.workspace.drape.session().unpin_all(); },
                       .can = [](const AppState& state) { return !state.workspace.drape.frame()->pins.empty(); }});
}

bool can_move(const AppState& state) {
    return state.workspace.drape.frame()->motion.can_move;
}

void play_or_pause(AppState& state) {
    state.layout.has_timeline = true;
    Drape& drape = state.workspace.drape;
    drape.frame()->motion.is_playing ? drape.pause_motion() : drape.play();
}

void repeat_or_not(AppState& state) {
    sim::Playback playback = state.workspace.drape.activity().playback;
    playback.is_loop = !playback.is_loop;
    state.workspace.drape.set_playback(playback);
}

void add_motion_actions(std::vector<Action>& actions) {
    actions.push_back(
        {.id = "motion.play",
         .menu = "Simulate",
         .title = "Play or pause the motion",
         .tip = "The body moves once the garment hangs, and carries it along",
         .chords = {{Key::Space, {.shift = true}}},
         .begins_group = true,
         .run = play_or_pause,
         .can = [](const AppState& state) { return can_move(state) && state.workspace.drape.can_play(); },
         .is_on = [](const AppState& state) { return state.workspace.drape.frame()->motion.is_playing; }});
    actions.push_back({.id = "motion.start",
                       .menu = "Simulate",
                       .title = "Back to the start of the motion",
                       .tip = "The body and the garment are as they were dressed",
                       .run = [](AppState& state) { state.workspace.drape.back_to_start(); },
                       .can = [](const AppState& state) { return !state.workspace.drape.frame()->motion.is_at_rest; }});
    actions.push_back(
        {.id = "motion.loop",
         .menu = "Simulate",
         .title = "Repeat the motion",
         .run = repeat_or_not,
         .is_on = [](const AppState& state) { return state.workspace.drape.activity().playback.is_loop; }});
    actions.push_back({.id = "motion.open",
                       .menu = "Simulate",
                       .title = "Motion from file...",
                       .tip = "A BVH, FBX, GLB or glTF file, or one in the shipped format (.json)",
                       .run = browse_for_motion,
                       .can = can_move});
    actions.push_back({.id = "motion.open_pose",
                       .menu = "Simulate",
                       .title = "Pose from file...",
                       .tip = "One that was saved, or the end of a motion",
                       .run = browse_for_pose,
                       .can = can_move});
    actions.push_back({.id = "motion.save_pose",
                       .menu = "Simulate",
                       .title = "Save pose...",
                       .tip = "As a file for this list of poses and for selvedge animate --motion",
                       .run = browse_to_save_pose,
                       .can = can_move});
}

void add_help_actions(std::vector<Action>& actions) {
    actions.push_back({.id = "help.find",
                       .menu = "Help",
                       .title = "Find an action...",
                       .tip = "Type some of its letters",
                       .chords = {ctrl('K')},
                       .run = [](AppState& state) { state.finder.open(); }});
    actions.push_back({.id = "help.tour",
                       .menu = "Help",
                       .title = "First steps",
                       .tip = "A garment in five steps: open, look, drape, change, keep",
                       .begins_group = true,
                       .run = [](AppState& state) { state.help.tour_step = 0; },
                       .is_on = [](const AppState& state) { return state.help.tour_step.has_value(); }});
    actions.push_back({.id = "help.keys",
                       .menu = "Help",
                       .title = "Keys",
                       .tip = "All keys, also those of the sheet and the 3D view",
                       .chords = {{Key::F1, {.shift = true}}},
                       .run = [](AppState& state) { state.help.has_keys = !state.help.has_keys; },
                       .is_on = [](const AppState& state) { return state.help.has_keys; }});
    actions.push_back({.id = "help.manual",
                       .menu = "Help",
                       .title = "Manual",
                       .tip = "What each part of the editor does",
                       .chords = {{Key::F1, {.ctrl = true}}},
                       .run = [](AppState& state) { state.help.has_manual = !state.help.has_manual; },
                       .can = [](const AppState& state) { return !state.services.manual.empty(); },
                       .is_on = [](const AppState& state) { return state.help.has_manual; }});
    actions.push_back({.id = "help.start",
                       .menu = "Help",
                       .title = "Start page",
                       .tip = "Examples, recent files and the most useful keys",
                       .chords = {{Key::F1, {}}},
                       .run = [](AppState& state) { state.shows_start_page = !state.shows_start_page; },
                       .is_on = [](const AppState& state) { return state.shows_start_page; }});
}

// One action per tool of the sheet, with the tool's keys.
void add_tool_actions(std::vector<Action>& actions, KeyMap map) {
    ToolGroup group = all_tools().front().group;
    for (const ToolInfo& tool : all_tools()) {
        const bool begins_group = tool.group != group;
        group = tool.group;
        Action action{.id = "tool." + std::string(tool.id),
                      .menu = "Tools",
                      .title = std::string(tool.title),
                      .tip = std::string(tool.what),
                      .begins_group = begins_group,
                      .run =
                          [&tool](AppState& state) {
                              state.tools.choose(tool_host_context(state.workspace), tool);
                              state.inspectors.boxes.gives_keys_back = true;  // what is typed next is the tool's
                          },
                      .is_on = [&tool](const AppState& state) { return &state.tools.info() == &tool; }};
        for (const Key key : keys_of(tool, map)) {
            if (key != Key::None) action.chords.push_back({key, {}});
        }
        actions.push_back(std::move(action));
    }
}

}  // namespace

namespace {

// What has other keys in Marvelous Designer's map than in the editor's own. Tools: keys_of().
void use_other_keys(std::vector<Action>& actions) {
    const std::array<std::pair<std::string_view, std::vector<Chord>>, 3> other{
        {{"edit.duplicate", {}}, {"panel.symmetric_copy", {ctrl('D')}}, {"seam.edit", {{key_of('B'), {}}}}}};
    for (const auto& [id, chords] : other) {
        const auto found = std::ranges::find(actions, id, &Action::id);
        SELVEDGE_ASSERT(found != actions.end());
        found->chords = chords;
    }
}

}  // namespace

std::vector<Action> make_actions(KeyMap map) {
    std::vector<Action> actions;
    add_file_actions(actions);
    add_edit_actions(actions);
    add_panel_actions(actions);
    add_object_actions(actions);
    add_selection_actions(actions);
    add_tool_actions(actions, map);
    add_simulate_actions(actions);
    add_motion_actions(actions);
    add_view_actions(actions);
    add_help_actions(actions);
    if (map == KeyMap::MarvelousDesigner) use_other_keys(actions);
    return actions;
}

void save_settings(AppState& state) {
    if (state.services.save_settings)
        state.services.save_settings({.keys = state.tools.key_map, .is_dark = state.is_dark});
}

void choose_key_map(AppState& state, KeyMap map) {
    state.tools.key_map = map;
    save_settings(state);
}

std::vector<std::string> menu_names() {
    return {"File", "Edit", "Panel", "Seam", "Tools", "Simulate", "View", "Help"};
}

bool run_action(AppState& state, const Action& action) {
    if (action.can && !action.can(state)) return false;
    state.workspace.messages.dismiss();  // an error refers to the action before
    action.run(state);
    return true;
}

namespace {

const Selection& selected(const AppState& state) {
    return state.workspace.document->selection();
}
bool has_panels(const AppState& state) {
    return !selected(state).panels.empty();
}
// The selected seams, or those of the selected edges.
std::set<int> chosen_seams(const AppState& state) {
    if (!selected(state).seams.empty()) return selected(state).seams;
    const sim::Pattern& pattern = state.workspace.document->pattern();
    std::set<int> seams;
    for (const PartRef& edge : selected(state).edges) {
        const std::optional<int> panel = panel_index(pattern, edge.panel);
        const std::optional<int> seam = panel ? seam_at(pattern, {*panel, edge.index}) : std::nullopt;
        if (seam) seams.insert(*seam);
    }
    return seams;
}
bool has_seams(const AppState& state) {
    return !selected(state).seams.empty();
}
bool has_one_seam(const AppState& state) {
    return one_of_each_sewing(state.workspace.document->pattern(), chosen_seams(state)).size() == 1;
}

// The selected panels, with their positions on the sheet, and their indices.
struct SelectedPanels {
    std::vector<sim::Panel> panels;
    std::vector<int> indices;
};

SelectedPanels selected_panels(const AppState& state) {
    SelectedPanels found;
    const sim::Pattern& pattern = state.workspace.document->pattern();
    const std::vector<Vec2d> positions = sheet_positions(pattern);
    for (std::size_t p = 0; p < positions.size(); ++p) {
        if (!selected(state).panels.contains(pattern.panels[p].name)) continue;
        found.indices.push_back(static_cast<int>(p));
        found.panels.push_back(pattern.panels[p]);
        found.panels.back().sheet_position = positions[p];
    }
    return found;
}

// The common shift on the sheet of all copies, so that they lie beside all that is there.
Vec2d beside_selected(const AppState& state) {
    return free_shift(state.workspace.document->pattern(), selected_panels(state).panels);
}

// Deleting a seam renumbers the others, so each command uses the first selected seam when it runs.
void with_seam(AppState& state, const std::function<Command(int)>& make) {
    state.workspace.run(make(*chosen_seams(state).begin()));
}

void copy_panels(AppState& state) {
    SelectedPanels copied = selected_panels(state);
    state.clipboard = {.panels = std::move(copied.panels),
                       .seams = seams_among(state.workspace.document->pattern(), copied.indices)};
    state.workspace.messages.note(sim::count_text(copied.indices.size(), "panel") + " copied");
}

void paste_panels(AppState& state) {
    const Document& document = *state.workspace.document;
    AddPanels command = state.clipboard;
    const Vec2d shift = free_shift(document.pattern(), command.panels);
    const Vec3d move = free_move(document, &state.workspace.drape, command.panels);
    for (sim::Panel& panel : command.panels) {
        panel.mirror_of = panel.copy_of = "";
        *panel.sheet_position += shift;
        panel.translation += move;
    }
    state.workspace.run(command);
}

void duplicate_selected(AppState& state, bool is_linked) {
    const Document& document = *state.workspace.document;
    const std::vector<sim::Panel> panels = selected_panels(state).panels;
    DuplicatePanels command{.shift = free_shift(document.pattern(), panels),
                            .move = free_move(document, &state.workspace.drape, panels),
                            .is_linked = is_linked};
    for (const sim::Panel& panel : panels) command.panels.push_back(panel.name);
    state.workspace.run(command);
}

void for_each_panel(AppState& state, const std::function<Command(const std::string&)>& make) {
    std::vector<Command> commands;
    for (const std::string& name : selected(state).panels) commands.push_back(make(name));
    state.workspace.run_together(commands);
}

void mirror_panels(AppState& state, const Vec2d& axis) {
    const Selection selection = state.workspace.document->changeable();
    const SheetBox box = state.tools.geometry().box_of(selection);
    if (box.isEmpty()) return;
    const auto command =
        transform_selected(state.tools.geometry(), selection, mirror_over(box.center(), axis), "Mirror");
    if (command) state.workspace.run(*command);
}

bool is_linked(const AppState& state) {
    for (const sim::Panel& panel : state.workspace.document->pattern().panels) {
        const auto link = sim::link_of(panel);
        const std::set<std::string>& chosen = selected(state).panels;
        if (link && (chosen.contains(panel.name) || chosen.contains(link->source))) return true;
        if (sim::has_linked_halves(panel) && chosen.contains(panel.name)) return true;
    }
    return false;
}

void add_clipboard(std::vector<Action>& actions) {
    actions.push_back({.id = "edit.copy",
                       .menu = "Edit",
                       .title = "Copy panels",
                       .needs = "a selected panel",
                       .chords = {{key_of('C'), {.ctrl = true}}},
                       .begins_group = true,
                       .run = copy_panels,
                       .can = has_panels});
    actions.push_back({.id = "edit.paste",
                       .menu = "Edit",
                       .title = "Paste panels",
                       .needs = "panels that were copied",
                       .chords = {{key_of('V'), {.ctrl = true}}},
                       .run = paste_panels,
                       .can = [](const AppState& state) { return !state.clipboard.panels.empty(); }});
    actions.push_back({.id = "edit.duplicate",
                       .menu = "Edit",
                       .title = "Duplicate panels",
                       .needs = "a selected panel",
                       .chords = {{key_of('D'), {.ctrl = true}}},
                       .run = [](AppState& state) { duplicate_selected(state, false); },
                       .can = has_panels});
}

bool has_one_edge(const AppState& state) {
    return state.workspace.document->changeable().edges.size() == 1;
}

void unfold_selected(AppState& state, bool has_linked_halves) {
    const PartRef edge = *state.workspace.document->changeable().edges.begin();
    state.workspace.run(UnfoldPanel{.panel = edge.panel, .edge = edge.index, .is_linked = has_linked_halves});
}

void add_panels(std::vector<Action>& actions) {
    const auto add = [&](const char* id, const char* title, const char* tip, std::function<void(AppState&)> run) {
        actions.push_back({.id = id,
                           .menu = "Panel",
                           .title = title,
                           .tip = tip,
                           .needs = "a selected panel",
                           .run = run,
                           .can = has_panels});
    };
    add("panel.symmetric_copy", "Symmetric copy, linked",
        "For the body's other side, with seams: what is changed on one is changed on both", [](AppState& state) {
            const std::set<std::string>& panels = selected(state).panels;
            const std::vector<std::string> names(panels.begin(), panels.end());
            state.workspace.run(SymmetricCopy{names, true, beside_selected(state)});
        });
    add("panel.linked_copy", "Linked copy", "Placed on its own: what is changed on one is changed on both",
        [](AppState& state) { duplicate_selected(state, true); });
    actions.push_back({.id = "panel.unlink",
                       .menu = "Panel",
                       .title = "Unlink from its mirror image or copy, and its halves",
                       .needs = "a selected panel that is linked",
                       .run =
                           [](AppState& state) {
                               for_each_panel(state,
                                              [](const std::string& name) -> Command { return UnlinkPanel{name}; });
                           },
                       .can = is_linked});
    add("panel.mirror_across", "Mirror left to right", "", [](AppState& state) { mirror_panels(state, Vec2d(0, 1)); });
    actions.back().begins_group = true;
    add("panel.mirror_upright", "Mirror top to bottom", "", [](AppState& state) { mirror_panels(state, Vec2d(1, 0)); });
    add("panel.unfold", "Unfold over the selected edge", "What was drawn as a half on the fold is opened",
        [](AppState& state) { unfold_selected(state, false); });
    actions.back().can = has_one_edge;
    actions.back().needs = "one selected edge";
    add("panel.unfold_linked", "Unfold over the selected edge, linked",
        "It stays symmetric: what is changed in one half is changed in both",
        [](AppState& state) { unfold_selected(state, true); });
    actions.back().can = has_one_edge;
    actions.back().needs = "one selected edge";
}

void edit_seams(AppState& state) {
    state.tools.choose(tool_host_context(state.workspace), default_tool());
    state.layout.has_inspectors = true;
    state.layout.wanted_tab = InspectorTab::Seams;
}

void add_seams(std::vector<Action>& actions) {
    const auto add = [&](const char* id, const char* title, const char* tip, std::function<Command(int)> make) {
        actions.push_back({.id = id,
                           .menu = "Seam",
                           .title = title,
                           .tip = tip,
                           .needs = "a selected seam, or edge of one",
                           .run = [make](AppState& state) { with_seam(state, make); },
                           .can = has_one_seam});
    };
    add("seam.reverse", "Reverse", "Sews it the other way round",
        [](int seam) -> Command { return ReverseSeam{seam}; });
    add("seam.even", "Even", "Makes the second side as long as the first",
        [](int seam) -> Command { return EvenSeam{seam}; });
    add("seam.accept", "Accept as ease", "The longer side is gathered: it is meant to be so", [](int seam) -> Command {
        return AcceptEase{seam, true};
    });
    add("seam.merge", "Merge panels", "Joins both panels to one along the seam; the larger one stays where it lies",
        [](int seam) -> Command { return MergePanels{.seam = seam}; });
    actions.push_back({.id = "seam.delete",
                       .menu = "Seam",
                       .title = "Delete",
                       .needs = "a selected seam",
                       .run =
                           [](AppState& state) {
                               const std::set<int>& seams = selected(state).seams;
                               state.workspace.run(RemoveParts{.seams = {seams.begin(), seams.end()}});
                           },
                       .can = has_seams});
    actions.push_back({.id = "seam.edit",
                       .menu = "Seam",
                       .title = "Edit seams",
                       .tip = "The list of seams, and the tool that selects them on the sheet",
                       .begins_group = true,
                       .run = edit_seams});
    actions.push_back({.id = "seam.propose",
                       .menu = "Seam",
                       .title = "Propose seams",
                       .tip = "Goes through the seams that the pattern probably has: Enter sews, Delete refuses",
                       .chords = {{key_of('L'), {}}},
                       .run = [](AppState& state) {
                           state.tools.choose(tool_host_context(state.workspace), proposal_tool());
                           state.inspectors.boxes.gives_keys_back =
                               true;  // Enter is the sheet's, wherever the cursor is
                       }});
    actions.push_back(
        {.id = "seam.match",
         .menu = "Seam",
         .title = "Match tartan at seams",
         .tip = "Moves the tartan under the panels so that stripes go on; selected seams come first",
         .begins_group = true,
         .run =
             [](AppState& state) {
                 const std::set<int>& seams = selected(state).seams;
                 state.workspace.run(MatchSetts{.first_seams = {seams.begin(), seams.end()}});
             },
         .can = [](const AppState& state) { return !state.workspace.document->pattern().seams.empty(); }});
}

}  // namespace

void add_panel_actions(std::vector<Action>& actions) {
    add_clipboard(actions);
    add_panels(actions);
    add_seams(actions);
}

}  // namespace selvedge::editor
