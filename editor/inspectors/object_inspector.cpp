// The tab Objects: the tree of garments or fabrics, panels, their parts, and seams, with an eye and a lock per panel.
#include <imgui.h>

#include <algorithm>

#include "editor/geometry/sewing.h"
#include "editor/inspectors/controls.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_measures.h"

namespace selvedge::editor {
namespace {

// Icons in a square of `side` px.

void draw_eye(const ImVec2& low, float side, ImU32 colour, bool is_open) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 middle(low.x + side / 2, low.y + side / 2), left(low.x + 0.14F * side, middle.y),
        right(low.x + 0.86F * side, middle.y);
    const float width = std::max(1.0F, 0.08F * side), bow = 0.5F * side;
    list.AddBezierQuadratic(left, {middle.x, middle.y + bow}, right, colour, width);
    if (!is_open) return;
    list.AddBezierQuadratic(left, {middle.x, middle.y - bow}, right, colour, width);
    list.AddCircleFilled(middle, 0.13F * side, colour);
}

void draw_lock(const ImVec2& low, float side, ImU32 colour, bool is_closed) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](float x, float y) { return ImVec2(low.x + x * side, low.y + y * side); };
    const float width = std::max(1.0F, 0.08F * side), raised = is_closed ? 0 : 0.1F;
    list.AddBezierCubic(at(0.34F, 0.48F - raised), at(0.34F, 0.1F - raised), at(0.66F, 0.1F - raised),
                        at(0.66F, is_closed ? 0.48F : 0.3F), colour, width);
    if (is_closed) {
        list.AddRectFilled(at(0.24F, 0.46F), at(0.76F, 0.86F), colour, 0.06F * side);
    } else {
        list.AddRect(at(0.24F, 0.46F), at(0.76F, 0.86F), colour, 0.06F * side, 0, width);
    }
}

// Rows.

struct Row {
    std::string name{};  // of its widget
    std::string title{};
    std::string tip{};
    bool is_selected = false;
    bool is_leaf = true;
    bool is_faint = false;
    bool is_opened = false;  // in this frame, whatever the user did
    float right_px = 0;      // for the switches
};

struct RowUse {
    bool is_open = false;
    bool is_clicked = false;
    bool is_hovered = false;
    bool names = false;   // a double click on the title
    bool frames = false;  // a double click beside it
};

float side_px() {
    return ImGui::GetTextLineHeight();
}

RowUse draw_row(InspectorContext& context, const Row& row) {
    constexpr float kLeastRoom = 4;  // font heights, of a title
    const float arrow = ImGui::GetTreeNodeToLabelSpacing(), gap = ImGui::GetStyle().ItemSpacing.x;
    const float all = ImGui::GetContentRegionAvail().x - row.right_px;
    const float room = std::max(kLeastRoom * ImGui::GetFontSize(), all - arrow - 2 * gap);
    const std::string shown = elided(row.title, room);
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow;
    if (row.is_leaf) flags |= ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_NoTreePushOnOpen;
    if (row.is_selected) flags |= ImGuiTreeNodeFlags_Selected;
    if (row.is_opened) ImGui::SetNextItemOpen(true);
    ImGui::PushStyleColor(ImGuiCol_Text, to_colour(row.is_faint ? context.theme.faint : context.theme.ink));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    RowUse use{.is_open = ImGui::TreeNodeEx((shown + "##" + row.name).c_str(), flags)};
    ImGui::PopStyleColor();
    const bool is_double = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    use.is_hovered = ImGui::IsItemHovered();
    use.is_clicked = ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen();
    use.names = use.is_clicked && is_double;
    note_widget(context, row.name + ".title");
    if (context.widgets != nullptr) {  // the title, without the arrow
        WidgetBox& box = context.widgets->at(row.name + ".title");
        box.low.x() = std::min(box.high.x(), low.x + arrow);
    }
    show_tip(shown == row.title ? row.tip : row.title + (row.tip.empty() ? "" : "\n" + row.tip));
    const float used = ImGui::GetItemRectMax().x - low.x;
    ImGui::SameLine(0, 2 * gap);  // where the item ends
    ImGui::PushID((row.name + " beside").c_str());
    ImGui::InvisibleButton("##beside", {std::max(1.0F, all - used), side_px()});
    ImGui::PopID();
    note_widget(context, row.name);
    const bool is_beside = ImGui::IsItemClicked();
    use.is_hovered = use.is_hovered || ImGui::IsItemHovered();
    use.is_clicked = use.is_clicked || is_beside;
    use.frames = is_beside && is_double;
    return use;
}

// Shows what the row stands for as hovered in all views.
void light_up(InspectorContext& context, const Hover& hover, bool is_hovered) {
    std::optional<Hover>& lit = context.state.objects.lit;
    if (is_hovered) {
        context.workspace.hover = hover;
        lit = hover;
    } else if (lit == hover) {
        if (context.workspace.hover == hover) context.workspace.hover = {};
        lit.reset();
    }
}

// A click selects this alone; with Ctrl or Shift it is added, or taken away. `change` does that to a selection.
template <class Change>
void use_row(InspectorContext& context, const RowUse& use, const Hover& hover, Change&& change) {
    light_up(context, hover, use.is_hovered);
    if (!use.is_clicked) return;
    const bool is_adding = ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift;
    Selection selection = is_adding ? context.selection() : Selection{};
    change(selection);
    context.workspace.document->select(std::move(selection));
    if (use.frames && context.frame_selection) context.frame_selection();
}

template <class T>
void toggle(std::set<T>& chosen, const T& what) {
    if (chosen.erase(what) == 0) chosen.insert(what);
}

// Focuses the box just drawn in the next frame. Dear ImGui 1.90 does not find the one that is drawn next in a child
// window that was not focused before.
void focus_last_item() {
    ImGui::SetKeyboardFocusHere(-1);
}

// The box in which a name is typed, instead of the row. Returns the name when it is to be applied.
std::optional<std::string> draw_naming(InspectorContext& context, const std::string& row, const std::string& text) {
    RowNaming& naming = context.state.objects.naming;
    if (!naming.has_begun) ImGui::SetScrollHereY();
    const std::string box = row + ".name";
    const std::optional<std::string> typed =
        text_box(context, {.name = box.c_str(),
                           .text = text,
                           .tip = "Enter gives it this name, Escape keeps the one it has.",
                           .width_px = ImGui::GetContentRegionAvail().x});
    if (!naming.has_begun) focus_last_item();
    const bool is_active = ImGui::IsItemActive();
    if (typed || (naming.has_begun && !is_active)) {
        naming = {};
    } else if (is_active) {
        naming.has_begun = true;
    }
    return typed;
}

bool is_naming(const InspectorContext& context, const std::string& row) {
    return context.state.objects.naming.row == row;
}

// Eye and lock of one or several panels: on where all of them are hidden or locked.

bool draw_switch(InspectorContext& context, const std::string& name, const std::string& tip, bool is_on,
                 void (*icon)(const ImVec2& low, float side, ImU32 colour, bool is_shut)) {
    ImGui::SameLine(0, 0);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool is_pressed = ImGui::InvisibleButton(("##" + name).c_str(), {side_px(), side_px()});
    const bool is_lit = is_on || ImGui::IsItemHovered();
    note_widget(context, name);
    show_tip(tip);
    icon(low, side_px(), ImGui::GetColorU32(to_colour(is_lit ? context.theme.accent : context.theme.faint)), is_on);
    return is_pressed;
}

void set_all(std::set<std::string>& in, const std::vector<std::string>& panels, bool is_member) {
    for (const std::string& panel : panels) {
        if (is_member) {
            in.insert(panel);
        } else {
            in.erase(panel);
        }
    }
}

bool has_all(const std::set<std::string>& in, const std::vector<std::string>& panels) {
    return std::ranges::all_of(panels, [&](const std::string& panel) { return in.contains(panel); });
}

void draw_switches(InspectorContext& context, const std::string& row, const std::vector<std::string>& panels) {
    Document& document = *context.workspace.document;
    PanelStates states = document.panel_states();
    const bool is_hidden = has_all(states.hidden, panels), is_locked = has_all(states.locked, panels);
    const std::string eye_tip =
        is_hidden ? "Shows it again" : with_key(context, "Hides it; its cloth still drapes", "panel.hide");
    const std::string lock_tip =
        is_locked ? "Unlocks it" : with_key(context, "Locks it: the views neither pick nor change it", "panel.lock");
    const auto eye = [](const ImVec2& low, float side, ImU32 colour, bool is_shut) {
        draw_eye(low, side, colour, !is_shut);
    };
    const bool eye_used = draw_switch(context, row + ".eye", eye_tip, is_hidden, eye);
    const bool lock_used = draw_switch(context, row + ".lock", lock_tip, is_locked, draw_lock);
    if (eye_used) set_all(states.hidden, panels, !is_hidden);
    if (lock_used) set_all(states.locked, panels, !is_locked);
    if (eye_used || lock_used) document.set_panel_states(states);
}

// The tree.

void draw_line(InspectorContext& context, const std::string& panel, const ListedPart& part) {
    const std::string row = "objects.line." + panel + "." + std::to_string(part.index);
    const PartRef ref{panel, part.index};
    const RowUse use = draw_row(context, {.name = row,
                                          .title = part.title,
                                          .tip = "An internal line.",
                                          .is_selected = context.selection().internal_lines.contains(ref)});
    use_row(context, use, {.internal_line = ref, .panel = panel},
            [&](Selection& selection) { toggle(selection.internal_lines, ref); });
}

void draw_edge(InspectorContext& context, const std::string& panel, const ListedPart& part) {
    const std::string row = "objects.edge." + panel + "." + std::to_string(part.index);
    const PartRef ref{panel, part.index};
    const RowUse use =
        draw_row(context, {.name = row, .title = part.title, .is_selected = context.selection().edges.contains(ref)});
    use_row(context, use, {.edge = ref, .panel = panel}, [&](Selection& selection) { toggle(selection.edges, ref); });
}

// A seam, or a dart under its panel.
void draw_seam(InspectorContext& context, int seam, const std::string& title, const std::string& tip) {
    const std::string row = "objects.seam." + std::to_string(seam);
    const sim::Seam& held = context.pattern().seams[static_cast<std::size_t>(seam)];
    if (is_naming(context, row)) {
        if (const auto name = draw_naming(context, row, held.sewing.empty() ? held.name : held.sewing))
            context.workspace.run(NameSeam{.seam = seam, .to = *name});
        return;
    }
    const RowUse use = draw_row(
        context, {.name = row, .title = title, .tip = tip, .is_selected = context.selection().seams.contains(seam)});
    use_row(context, use, {.seam = seam},
            [&](Selection& selection) { toggle_sewing(context.pattern(), seam, selection.seams); });
    if (use.names) context.state.objects.naming = {.row = row};
}

void draw_parts(InspectorContext& context, const std::string& panel, const std::vector<ListedPart>& parts) {
    for (const ListedPart& part : parts) {
        if (part.kind == PartKind::InternalLine) draw_line(context, panel, part);
        if (part.kind == PartKind::Dart) draw_seam(context, part.index, part.title, "A dart of this panel.");
        if (part.kind == PartKind::Edge) draw_edge(context, panel, part);
    }
}

// Whether a dart of the panel is being named.
bool is_dart_named_in(const InspectorContext& context, const ListedPanel& listed) {
    return std::ranges::any_of(listed.parts, [&](const ListedPart& part) {
        return part.kind == PartKind::Dart && is_naming(context, "objects.seam." + std::to_string(part.index));
    });
}

void draw_panel(InspectorContext& context, const ListedPanel& listed) {
    const std::string panel = context.pattern().panels[static_cast<std::size_t>(listed.index)].name;
    const std::string row = "objects.panel." + panel;
    if (is_naming(context, row)) {
        if (const auto name = draw_naming(context, row, panel))
            context.workspace.run(RenamePanel{.panel = panel, .to = *name});
        return;
    }
    const PanelStates& states = context.workspace.document->panel_states();
    const RowUse use = draw_row(context, {.name = row,
                                          .title = panel,
                                          .tip = "Double click: another name; beside the name: shows it on the sheet.",
                                          .is_selected = context.selection().panels.contains(panel),
                                          .is_leaf = listed.parts.empty(),
                                          .is_faint = states.hidden.contains(panel),
                                          .is_opened = !listed.is_found || is_dart_named_in(context, listed),
                                          .right_px = 2 * side_px()});
    draw_switches(context, row, {panel});
    use_row(context, use, {.panel = panel}, [&](Selection& selection) { toggle(selection.panels, panel); });
    if (use.names) context.state.objects.naming = {.row = row};
    if (!use.is_open || listed.parts.empty()) return;
    draw_parts(context, panel, listed.parts);
    ImGui::TreePop();
}

bool is_named_in(const InspectorContext& context, const PanelGroup& group) {
    return std::ranges::any_of(group.panels, [&](const ListedPanel& listed) {
        const std::string& panel = context.pattern().panels[static_cast<std::size_t>(listed.index)].name;
        return is_naming(context, "objects.panel." + panel) || is_dart_named_in(context, listed);
    });
}

void draw_group(InspectorContext& context, const PanelGroup& group) {
    const ObjectsState& state = context.state.objects;
    const bool is_fabric = state.grouping == PanelGrouping::Fabrics;
    const std::string row = "objects.group." + group.name;
    std::vector<std::string> panels;
    for (const ListedPanel& listed : group.panels)
        panels.push_back(context.pattern().panels[static_cast<std::size_t>(listed.index)].name);
    ImGui::SetNextItemOpen(true, ImGuiCond_Once);
    const RowUse use = draw_row(
        context, {.name = row,
                  .title = is_fabric ? readable_name(group.name) : group.name,
                  .tip = is_fabric ? "A fabric. A click selects its panels." : "A garment. A click selects its panels.",
                  .is_leaf = false,
                  .is_opened = !state.wanted.empty() || is_named_in(context, group),
                  .right_px = 2 * side_px()});
    draw_switches(context, row, panels);
    use_row(context, use, {}, [&](Selection& selection) { selection.panels.insert(panels.begin(), panels.end()); });
    if (!use.is_open) return;
    for (const ListedPanel& listed : group.panels) draw_panel(context, listed);
    ImGui::TreePop();
}

void draw_seam_group(InspectorContext& context, const std::vector<int>& seams) {
    if (seams.empty()) return;
    const ObjectsState& state = context.state.objects;
    ImGui::SetNextItemOpen(true, ImGuiCond_Once);
    const RowUse use =
        draw_row(context, {.name = "objects.seams",
                           .title = "Seams",
                           .is_leaf = false,
                           .is_opened = !state.wanted.empty() || state.naming.row.starts_with("objects.seam.")});
    use_row(context, use, {}, [&](Selection& selection) { selection.seams.insert(seams.begin(), seams.end()); });
    if (!use.is_open) return;
    for (const int seam : seams) {
        draw_seam(context, seam, seam_measures(context.pattern(), seam).name, "");
    }
    ImGui::TreePop();
}

// The words that are wanted, as they are typed.
std::string draw_find_box(InspectorContext& context) {
    ObjectsState& state = context.state.objects;
    const auto found = text_box(context, {.name = "objects.find",
                                          .text = state.wanted,
                                          .hint = "Find by name",
                                          .tip = with_key(context, "Words of a name. Empty: everything.", "panel.find"),
                                          .width_px = ImGui::GetContentRegionAvail().x});
    if (state.wants_find) focus_last_item();
    if (ImGui::IsItemActive()) state.wants_find = false;
    if (found) state.wanted = *found;
    const TypedText& typed = context.state.boxes.typed;
    const bool is_typing = typed.box != 0 && typed.box == ImGui::GetID("##objects.find");
    return is_typing ? typed.text : state.wanted;
}

void draw_grouping(InspectorContext& context) {
    PanelGrouping& grouping = context.state.objects.grouping;
    ButtonRow row(context);
    if (row.button({.name = "objects.garments",
                    .title = "By garment",
                    .tip = "The outermost garment first.",
                    .is_on = grouping == PanelGrouping::Garments})) {
        grouping = PanelGrouping::Garments;
    }
    if (row.button({.name = "objects.fabrics",
                    .title = "By fabric",
                    .tip = "The panels under what they are cut from.",
                    .is_on = grouping == PanelGrouping::Fabrics})) {
        grouping = PanelGrouping::Fabrics;
    }
}

bool has_row(const ObjectTree& tree, const sim::Pattern& pattern, const std::string& row) {
    const auto is_seam = [&](int seam) { return row == "objects.seam." + std::to_string(seam); };
    const auto is_dart = [&](const ListedPart& part) { return part.kind == PartKind::Dart && is_seam(part.index); };
    return std::ranges::any_of(tree.seams, is_seam) || std::ranges::any_of(tree.groups, [&](const PanelGroup& group) {
               return std::ranges::any_of(group.panels, [&](const ListedPanel& listed) {
                   return row == "objects.panel." + pattern.panels[static_cast<std::size_t>(listed.index)].name ||
                          std::ranges::any_of(listed.parts, is_dart);
               });
           });
}

// Begins to name the selected panel or seam. A search that does not find it is cleared.
void begin_naming(ObjectsState& state, const sim::Pattern& pattern, const Selection& selection) {
    if (selection.panels.size() == 1) state.naming = {.row = "objects.panel." + *selection.panels.begin()};
    if (selection.panels.empty() && one_of_each_sewing(pattern, selection.seams).size() == 1)
        state.naming = {.row = "objects.seam." + std::to_string(*selection.seams.begin())};
    if (!has_row(list_objects(pattern, state.grouping, state.wanted), pattern, state.naming.row)) state.wanted.clear();
}

}  // namespace

void draw_objects(InspectorContext& context) {
    ObjectsState& state = context.state.objects;
    if (context.pattern().panels.empty()) return paragraph(context, "No panels yet. Draw one, or open a garment.");
    if (std::exchange(state.wants_naming, false)) begin_naming(state, context.pattern(), context.selection());
    const std::string wanted = draw_find_box(context);
    draw_grouping(context);
    const ObjectListing listing{context.workspace.document->revision(), state.grouping, wanted};
    if (state.listing != listing) {
        state.tree = list_objects(context.pattern(), state.grouping, wanted);
        state.listing = listing;
    }
    const std::string count = count_text(state.tree, wanted);
    paragraph(context, count.empty() ? "Nothing has this name." : count + (wanted.empty() ? "." : " found."));
    for (const PanelGroup& group : state.tree.groups) draw_group(context, group);
    draw_seam_group(context, state.tree.seams);
}

}  // namespace selvedge::editor
