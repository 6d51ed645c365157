// Fabrics with their figures, the tartan, and how it meets at seams.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/fabric_text.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_figures.h"
#include "editor/inspectors/tartan_list.h"
#include "editor/inspectors/threadcount_text.h"
#include "editor/inspectors/vector_row.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

constexpr double kSmallestSett = 0.001, kLargestSett = 5;  // m, as commands have it

std::string garment_fabric(const Pattern& pattern) {
    return pattern.fabric.empty() ? Fabric{}.name : pattern.fabric;
}

std::string fabric_of(const Pattern& pattern, const Panel& panel) {
    return panel.fabric.empty() ? garment_fabric(pattern) : panel.fabric;
}

std::string users_of(const Pattern& pattern, const std::string& fabric) {
    std::string names;
    std::size_t count = 0;
    for (const Panel& panel : pattern.panels) {
        if (fabric_of(pattern, panel) != fabric) continue;
        names += (names.empty() ? "" : ", ") + panel.name;
        ++count;
    }
    if (count == 0) return "no panel";
    return count == pattern.panels.size() ? "all panels" : names;
}

void draw_fabric_rows(InspectorContext& context, const std::string& name) {
    try {
        for (const FabricRow& row : fabric_rows(find_fabric(name))) fact(context, row.label, row.value, row.tip);
    } catch (const InputError& error) {
        complaint(context.theme.error, error.problem());
    }
}

void draw_fabric_choice(InspectorContext& context, const std::string& shown) {
    std::vector<std::string> names = fabric_names(), words;
    if (std::find(names.begin(), names.end(), shown) == names.end()) names.push_back(shown);
    int chosen = -1;
    for (const std::string& name : names) {
        if (name == shown) chosen = static_cast<int>(words.size());
        words.push_back(readable_name(name));
    }
    const int now = choice_box(context, {.name = "material.fabric",
                                         .shown = readable_name(shown),
                                         .items = words,
                                         .chosen = chosen,
                                         .tip = "Whose figures are shown. The buttons below put it to use.",
                                         .width_px = ImGui::GetContentRegionAvail().x});
    if (now >= 0) context.state.material.fabric = names[static_cast<std::size_t>(now)];
}

void draw_fabric(InspectorContext& context) {
    const Pattern& pattern = context.pattern();
    std::string& viewed = context.state.material.fabric;
    const std::set<std::string> selected = context.selection().panels;
    const std::string shown = viewed.empty() ? garment_fabric(pattern) : viewed;
    draw_fabric_choice(context, shown);
    draw_fabric_rows(context, shown);
    const std::string users = users_of(pattern, shown);
    fact(context, "Used by", users, "The panels that are made of it: " + users + ".");
    ButtonRow row(context);
    if (row.button({.name = "material.fabric.garment",
                    .title = "Use for the garment",
                    .tip = "All panels that have no fabric of their own are made of it.",
                    .is_enabled = shown != garment_fabric(pattern)})) {
        context.workspace.run(SetFabric{.fabric = shown});
    }
    const std::string title = selected.size() == 1 ? "Use for " + *selected.begin() : "Use for selected panels";
    if (row.button({.name = "material.fabric.panels",
                    .title = title.c_str(),
                    .tip = selected.empty() ? "Select panels first." : "The selected panels are made of it.",
                    .is_enabled = !selected.empty()})) {
        for (const std::string& name : selected) context.workspace.run(SetFabric{.panel = name, .fabric = shown});
    }
}

void draw_sett_place(InspectorContext& context) {
    const Pattern& pattern = context.pattern();
    SetTartan command{.tartan = pattern.tartan, .size = pattern.sett_size, .position = pattern.sett_position};
    Pattern plain;
    plain.tartan = pattern.tartan;
    const std::optional<Sett> sett = sett_of(plain);
    const NumberEdit size = number_row(context,
                                       {.name = "tartan.size",
                                        .value = pattern.sett_size,
                                        .tip = "Of one repeat of the warp. Empty: the tartan's own.",
                                        .least = kSmallestSett,
                                        .most = kLargestSett,
                                        .may_be_empty = true,
                                        .standing_for = sett ? std::optional(repeat_size(*sett)) : std::nullopt},
                                       "s: size");
    const VectorEdit moved = vector_row(context,
                                        {.name = "tartan.position",
                                         .label = "p: position",
                                         .tip = "Where the sett begins under all panels: along the weft (X) and along "
                                                "the warp (Y)."},
                                        pattern.sett_position);
    if (size) {
        command.size = size.value;
        carry(context, size, command);
    } else if (moved) {
        command.position = edited(pattern.sett_position, moved);
        carry(context, moved.number, command);
    }
}

// Of all panels that are selected; it shows the first one's.
void draw_grain(InspectorContext& context) {
    const std::set<std::string> selected = context.selection().panels;
    if (selected.empty()) return;
    const std::optional<int> first = panel_index(context.pattern(), *selected.begin());
    if (!first) return;
    const NumberEdit grain =
        number_row(context,
                   {.name = "material.grain",
                    .value = context.pattern().panels[static_cast<std::size_t>(*first)].grain_angle,
                    .unit = Unit::Degrees,
                    .tip = "Of the selected panels, from upward to the warp, counter-clockwise. "
                           "45: cut on the bias."},
                   "Grain");
    if (selected.size() == 1 || grain.phase != EditPhase::Kept) {
        return carry(context, grain, SetGrain{.panel = *selected.begin(), .angle = grain.value.value_or(0)});
    }
    for (const std::string& name : selected) {
        context.workspace.run(SetGrain{.panel = name, .angle = grain.value.value_or(0)});
    }
}

void match(InspectorContext& context) {
    MaterialState& state = context.state.material;
    const std::set<int>& seams = context.selection().seams;
    const std::vector<int> first(seams.begin(), seams.end());
    const std::optional<Sett> sett = sett_of(context.pattern());
    if (!sett) return;
    std::vector<SeamMatch> matched = match_sett(context.pattern(), *sett, {.first_seams = first}).seams;
    if (!context.workspace.run(MatchSetts{.first_seams = first})) return;
    state.matched = std::move(matched);
    state.matched_revision = context.workspace.document->revision();
}

void draw_match_table(const InspectorContext& context, const std::vector<SeamMatch>& seams) {
    const ImGuiTableFlags flags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("matched", 3, flags)) return;
    const float em = ImGui::GetFontSize();
    ImGui::TableSetupColumn("Seam", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("before", ImGuiTableColumnFlags_WidthFixed, 3.6F * em);
    ImGui::TableSetupColumn("after, mm", ImGuiTableColumnFlags_WidthFixed, 4.6F * em);
    ImGui::TableHeadersRow();
    constexpr double kMet = 0.002;  // m
    for (const SeamMatch& seam : seams) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(elided(seam.name, ImGui::GetContentRegionAvail().x).c_str());
        show_tip(seam.name + (seam.why.empty() ? "\nIt meets all along." : "\n" + seam.why));
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(quantity_figure(seam.before, Unit::Millimetres).c_str());
        ImGui::TableNextColumn();
        complaint(seam.after > kMet ? context.theme.warning : context.theme.ink,
                  quantity_figure(seam.after, Unit::Millimetres));
    }
    ImGui::EndTable();
}

void draw_match(InspectorContext& context) {
    const Pattern& pattern = context.pattern();
    const std::optional<Sett> sett = sett_of(pattern);
    if (pattern.seams.empty() || !sett) return paragraph(context, "With seams between panels, stripes can be matched.");
    if (!pattern.matched_sett) {
        paragraph(context, "Nobody has matched the stripes at the seams yet.");
    } else if (!is_sett_of(*pattern.matched_sett, *sett)) {
        complaint(context.theme.warning, "The stripes were matched for another tartan or size. Match them again.");
    }
    ButtonRow row(context);
    if (row.button({.name = "material.match",
                    .title = "Match at seams",
                    .tip = with_key(context,
                                    "Moves the tartan under the panels so that its stripes go on across seams. "
                                    "Selected seams come first",
                                    "seam.match")})) {
        match(context);
    }
    const MaterialState& state = context.state.material;
    if (state.matched.empty()) return;
    if (state.matched_revision != context.workspace.document->revision()) {
        paragraph(context, "When it was matched last:");
    }
    draw_match_table(context, state.matched);
}

}  // namespace

void draw_materials(InspectorContext& context) {
    ImGui::PushID("materials");
    if (folding("Fabric", Fold::Open)) draw_fabric(context);
    if (folding("Tartan", Fold::Open)) {
        draw_tartan_list(context);
        draw_threadcount(context);
        draw_sett_place(context);
        draw_grain(context);
    }
    if (folding("Stripes at seams", Fold::Open)) draw_match(context);
    ImGui::PopID();
}

}  // namespace selvedge
