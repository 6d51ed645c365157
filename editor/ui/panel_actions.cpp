#include "editor/ui/panel_actions.h"

#include "editor/tools/selected_parts.h"
#include "editor/ui/desk.h"

namespace selvedge {
namespace {

constexpr double kBeside = 0.05;  // m between a panel and its copy

const Selection& selected(const Desk& desk) {
    return desk.workspace.document->selection();
}
bool has_panels(const Desk& desk) {
    return !selected(desk).panels.empty();
}
bool has_seams(const Desk& desk) {
    return !selected(desk).seams.empty();
}
bool has_one_seam(const Desk& desk) {
    return selected(desk).seams.size() == 1;
}

// How far copies of the selected panels are moved: all of them alike, to lie beside all of these.
Vec2d beside_selected(const Desk& desk) {
    const SheetBox box = desk.tools.geometry().box_of(selected(desk));
    return {box.isEmpty() ? 0.3 : box.sizes().x() + kBeside, 0};
}

// Seams shift when one goes, so each command looks its seam up when it is run: the first that is selected.
void with_seam(Desk& desk, const std::function<Command(int)>& make) {
    desk.workspace.run(make(*selected(desk).seams.begin()));
}

void copy_panels(Desk& desk) {
    desk.clipboard.clear();
    for (const Panel& panel : desk.workspace.document->pattern().panels) {
        if (selected(desk).panels.contains(panel.name)) desk.clipboard.push_back(panel);
    }
    desk.workspace.messages.note(std::to_string(desk.clipboard.size()) + " panels copied");
}

void paste_panels(Desk& desk) {
    AddPanels command{.panels = desk.clipboard};
    for (Panel& panel : command.panels) {
        panel.mirror_of.clear();
        if (panel.sheet_position) *panel.sheet_position += Vec2d(kBeside, -kBeside);
    }
    desk.workspace.run(command);
}

void for_each_panel(Desk& desk, const std::function<Command(const std::string&)>& make) {
    for (const std::string& name : std::set<std::string>(selected(desk).panels)) {
        if (!desk.workspace.run(make(name))) return;
    }
}

void mirror_panels(Desk& desk, const Vec2d& axis) {
    const SheetBox box = desk.tools.geometry().box_of(selected(desk));
    if (box.isEmpty()) return;
    const Selection& selection = selected(desk);
    const auto command =
        transform_selected(desk.tools.geometry(), selection, mirror_over(box.center(), axis), "Mirror");
    if (command) desk.workspace.run(*command);
}

bool is_linked(const Desk& desk) {
    for (const Panel& panel : desk.workspace.document->pattern().panels) {
        if (selected(desk).panels.contains(panel.name) && !panel.mirror_of.empty()) return true;
        if (!panel.mirror_of.empty() && selected(desk).panels.contains(panel.mirror_of)) return true;
    }
    return false;
}

void add_clipboard(std::vector<Action>& actions) {
    actions.push_back({.id = "edit.copy",
                       .menu = "Edit",
                       .title = "Copy panels",
                       .chords = {{key_of('C'), {.ctrl = true}}},
                       .begins_group = true,
                       .run = copy_panels,
                       .can = has_panels});
    actions.push_back({.id = "edit.paste",
                       .menu = "Edit",
                       .title = "Paste panels",
                       .chords = {{key_of('V'), {.ctrl = true}}},
                       .run = paste_panels,
                       .can = [](const Desk& desk) { return !desk.clipboard.empty(); }});
    actions.push_back(
        {.id = "edit.duplicate",
         .menu = "Edit",
         .title = "Duplicate panels",
         .chords = {{key_of('D'), {.ctrl = true}}},
         .run =
             [](Desk& desk) {
                 const Vec2d shift = beside_selected(desk);
                 for_each_panel(desk, [&](const std::string& name) -> Command { return DuplicatePanel{name, shift}; });
             },
         .can = has_panels});
}

void add_panels(std::vector<Action>& actions) {
    actions.push_back({.id = "panel.symmetric_copy",
                       .menu = "Panel",
                       .title = "Symmetric copy, linked",
                       .tip = "For the body's other side: what is changed on one is changed on both",
                       .run =
                           [](Desk& desk) {
                               const Vec2d shift = beside_selected(desk);
                               for_each_panel(desk, [&](const std::string& name) -> Command {
                                   return SymmetricCopy{name, true, shift};
                               });
                           },
                       .can = has_panels});
    actions.push_back({.id = "panel.unlink",
                       .menu = "Panel",
                       .title = "Unlink from its mirror image",
                       .run =
                           [](Desk& desk) {
                               for_each_panel(desk,
                                              [](const std::string& name) -> Command { return UnlinkPanel{name}; });
                           },
                       .can = is_linked});
    actions.push_back({.id = "panel.mirror_across",
                       .menu = "Panel",
                       .title = "Mirror left to right",
                       .begins_group = true,
                       .run = [](Desk& desk) { mirror_panels(desk, Vec2d(0, 1)); },
                       .can = has_panels});
    actions.push_back({.id = "panel.mirror_upright",
                       .menu = "Panel",
                       .title = "Mirror top to bottom",
                       .run = [](Desk& desk) { mirror_panels(desk, Vec2d(1, 0)); },
                       .can = has_panels});
    actions.push_back({.id = "panel.unfold",
                       .menu = "Panel",
                       .title = "Unfold over the selected edge",
                       .tip = "What was drawn as a half on the fold is opened",
                       .run =
                           [](Desk& desk) {
                               const PartRef edge = *selected(desk).edges.begin();
                               desk.workspace.run(UnfoldPanel{edge.panel, edge.index});
                           },
                       .can = [](const Desk& desk) { return selected(desk).edges.size() == 1; }});
}

void add_seams(std::vector<Action>& actions) {
    const auto add = [&](const char* id, const char* title, const char* tip, std::function<Command(int)> make) {
        actions.push_back({.id = id,
                           .menu = "Seam",
                           .title = title,
                           .tip = tip,
                           .run = [make](Desk& desk) { with_seam(desk, make); },
                           .can = has_one_seam});
    };
    add("seam.reverse", "Reverse", "Sews it the other way round",
        [](int seam) -> Command { return ReverseSeam{seam}; });
    add("seam.even", "Even", "Makes the second side as long as the first",
        [](int seam) -> Command { return EvenSeam{seam}; });
    add("seam.accept", "Accept as ease", "The longer side is gathered: it is meant to be so", [](int seam) -> Command {
        return AcceptEase{seam, true};
    });
    add("seam.merge", "Merge panels", "Joins both panels to one along the seam",
        [](int seam) -> Command { return MergePanels{seam}; });
    actions.push_back({.id = "seam.delete",
                       .menu = "Seam",
                       .title = "Delete",
                       .run =
                           [](Desk& desk) {
                               const std::set<int>& seams = selected(desk).seams;
                               desk.workspace.run(RemoveParts{.seams = {seams.begin(), seams.end()}});
                           },
                       .can = has_seams});
    actions.push_back({.id = "seam.match",
                       .menu = "Seam",
                       .title = "Match tartan at seams",
                       .tip = "Moves the tartan under the panels so that stripes go on; selected seams come first",
                       .begins_group = true,
                       .run =
                           [](Desk& desk) {
                               const std::set<int>& seams = selected(desk).seams;
                               desk.workspace.run(MatchSetts{.first_seams = {seams.begin(), seams.end()}});
                           },
                       .can = [](const Desk& desk) { return !desk.workspace.document->pattern().seams.empty(); }});
}

}  // namespace

void add_panel_actions(std::vector<Action>& actions) {
    add_clipboard(actions);
    add_panels(actions);
    add_seams(actions);
}

}  // namespace selvedge
