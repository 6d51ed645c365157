// The rows of a surface design, and the section of what the selected panels show, or the garment if none is selected.
#include <imgui.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/material_inspector.h"
#include "editor/inspectors/number_box.h"
#include "sim/pattern/surface_design.h"

namespace selvedge::editor {
namespace {

using sim::DesignKind;
using sim::SurfaceDesign;

// The panel whose design is shown, the first of those that are selected; null: none is.
const sim::Panel* shown_panel(const InspectorContext& context) {
    const std::vector<sim::Panel>& panels = context.pattern().panels;
    const auto found = std::ranges::find_if(
        panels, [&](const sim::Panel& panel) { return context.selection().panels.contains(panel.name); });
    return found == panels.end() ? nullptr : &*found;
}

constexpr std::array<std::pair<const char*, std::optional<DesignKind>>, 5> kKinds{{{"As above", std::nullopt},
                                                                                   {"Tartan", DesignKind::Tartan},
                                                                                   {"Colour", DesignKind::Colour},
                                                                                   {"Picture", DesignKind::Picture},
                                                                                   {"Test pattern", DesignKind::Test}}};

DesignEdit choose_kind(InspectorContext& context, const DesignRows& rows) {
    const std::optional<SurfaceDesign>& now = rows.now;
    std::vector<std::string> items;
    int chosen = 0;
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        items.emplace_back(kKinds[i].first);
        if (now && kKinds[i].second == now->kind) chosen = static_cast<int>(i);
    }
    items[0] = rows.none;
    row_label(context, "Shows", rows.tip);
    const std::string name = rows.names + "kind";
    const int now_chosen = choice_box(context, {.name = name.c_str(),
                                                .shown = items[static_cast<std::size_t>(chosen)],
                                                .items = items,
                                                .chosen = chosen,
                                                .width_px = field_width()});
    if (now_chosen < 0) return {};
    const std::optional<DesignKind> kind = kKinds[static_cast<std::size_t>(now_chosen)].second;
    if (!kind) return {.phase = EditPhase::Commit};
    SurfaceDesign design{.kind = *kind};
    if (now) design.position = now->position;
    if (kind == DesignKind::Tartan) design.source = context.pattern().tartan;
    if (kind == DesignKind::Colour) design.source = "#7A1F2B";
    if (kind != DesignKind::Picture) return {.phase = EditPhase::Commit, .surface = design};
    if (rows.open_picture) rows.open_picture();
    return {};
}

std::array<float, 3> parts_of(const std::string& colour) {
    unsigned red = 0, green = 0, blue = 0;
    if (sim::is_colour_text(colour)) std::sscanf(colour.c_str(), "#%2x%2x%2x", &red, &green, &blue);
    return {float(red) / 255, float(green) / 255, float(blue) / 255};
}

std::string colour_text(const std::array<float, 3>& parts) {
    std::array<char, 8> text{};
    const auto byte = [](float part) { return static_cast<unsigned>(std::clamp(part * 255 + 0.5F, 0.0F, 255.0F)); };
    std::snprintf(text.data(), text.size(), "#%02X%02X%02X", byte(parts[0]), byte(parts[1]), byte(parts[2]));
    return text.data();
}

// A preview while the picker is dragged, so that a drag ends with one entry of the history.
DesignEdit draw_colour(InspectorContext& context, const std::string& name, const std::string& shown,
                       SurfaceDesign design, std::string SurfaceDesign::*place) {
    std::array<float, 3> parts = parts_of(shown);
    ImGui::SetNextItemWidth(field_width());
    const bool has_changed =
        ImGui::ColorEdit3(name.c_str(), parts.data(),
                          ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions);
    note_widget(context, name);
    if (!has_changed && !ImGui::IsItemDeactivatedAfterEdit()) return {};
    design.*place = colour_text(parts);
    return {.phase = has_changed ? EditPhase::Preview : EditPhase::Commit, .surface = design};
}

DesignEdit draw_picture_rows(InspectorContext& context, const DesignRows& rows, const SurfaceDesign& design) {
    DesignEdit edit{.surface = design};
    const std::string rotation = rows.names + "rotation", repeats = rows.names + "repeats";
    const NumberEdit turned = number_row(context,
                                         {.name = rotation.c_str(),
                                          .value = design.rotation,
                                          .unit = Unit::Degrees,
                                          .tip = "Counter-clockwise about its position."},
                                         "Turned by");
    if (turned) edit.phase = turned.phase;
    if (turned) edit.surface->rotation = turned.value.value_or(0);
    if (check_box(context, repeats.c_str(), "Repeats", design.is_repeated, "Otherwise it is placed once.")) {
        edit.phase = EditPhase::Commit;
        edit.surface->is_repeated = !design.is_repeated;
    }
    if (design.kind != DesignKind::Picture) return edit;
    row_label(context, "Ground", "The colour around the picture, and behind what is transparent in it.");
    const DesignEdit ground =
        draw_colour(context, "##" + rows.names + "ground", design.ground.empty() ? sim::kUsualGround : design.ground,
                    *edit.surface, &SurfaceDesign::ground);
    return ground ? ground : edit;
}

DesignEdit draw_source(InspectorContext& context, const DesignRows& rows, const SurfaceDesign& design) {
    DesignEdit edit{.surface = design};
    if (design.kind == DesignKind::Colour) {
        row_label(context, "Colour", "Of all yarns.");
        return draw_colour(context, "##" + rows.names + "colour", design.source, design, &SurfaceDesign::source);
    }
    if (design.kind == DesignKind::Tartan) {
        row_label(context, "Tartan", "A name or a threadcount.");
        const std::string name = rows.names + "tartan";
        const auto text = text_box(context, {.name = name.c_str(),
                                             .text = design.source,
                                             .hint = "royal_stewart",
                                             .width_px = field_width(),
                                             .wrong = tartan_error});
        if (text) edit = {.phase = EditPhase::Commit, .surface = design};
        if (text) edit.surface->source = *text;
    }
    if (design.kind == DesignKind::Picture) {
        fact(context, "Picture", std::filesystem::path(design.source).filename().string(), design.source);
        ButtonRow row(context);
        const std::string name = rows.names + "choose";
        if (row.button({.name = name.c_str(), .title = "Choose another...", .is_enabled = bool(rows.open_picture)}))
            rows.open_picture();
    }
    return edit;
}

DesignEdit draw_place(InspectorContext& context, const DesignRows& rows, const SurfaceDesign& design) {
    const bool is_tartan = design.kind == DesignKind::Tartan;
    const std::string size_name = rows.names + "size", position_name = rows.names + "position";
    const NumberEdit size =
        number_row(context,
                   {.name = size_name.c_str(),
                    .value = design.size,
                    .tip = "Width of one repeat. Empty: the tartan's own, or 20 cm.",
                    .least = sim::kSmallestDesign,
                    .most = sim::kLargestDesign,
                    .may_be_empty = true,
                    .standing_for = is_tartan ? std::nullopt : std::optional(sim::kUsualDesignSize)},
                   "s: size");
    const VectorEdit moved = vector_row(context,
                                        {.name = position_name.c_str(),
                                         .label = "p: position",
                                         .tip = "Of its lower left corner: along the weft (X) and along the warp (Y)."},
                                        design.position);
    DesignEdit edit{.surface = design};
    if (size) edit.phase = size.phase;
    if (size) edit.surface->size = size.value;
    if (moved) edit.phase = moved.phase;
    if (moved) edit.surface->position = edited(design.position, moved);
    return edit;
}

}  // namespace

DesignEdit design_rows(InspectorContext& context, const DesignRows& rows) {
    DesignEdit edit = choose_kind(context, rows);
    if (!rows.now) return edit;
    const SurfaceDesign& design = *rows.now;
    if (const DesignEdit source = draw_source(context, rows, design)) edit = source;
    if (design.kind == DesignKind::Colour) return edit;
    if (const DesignEdit place = draw_place(context, rows, design)) edit = place;
    if (design.kind == DesignKind::Tartan) return edit;
    const DesignEdit picture = draw_picture_rows(context, rows, design);
    return picture ? picture : edit;
}

void draw_surface(InspectorContext& context) {
    const sim::Panel* panel = shown_panel(context);
    const std::set<std::string> selected = context.selection().panels;  // a copy: commands may change it
    const DesignEdit edit = design_rows(
        context, {.now = panel == nullptr ? context.pattern().surface : panel->surface,
                  .names = "surface.",
                  .none = selected.empty() ? "The tartan below, or plain" : "As the garment",
                  .tip = "What the cloth shows: of the selected panels, or of the garment if none is selected.",
                  .open_picture = context.open_picture});
    if (edit.phase == EditPhase::Rollback) context.workspace.document->rollback();
    // A drag previews the first panel only; the others follow when it ends.
    if (edit.phase == EditPhase::Preview)
        context.workspace.preview(
            SetSurface{.panel = selected.empty() ? "" : *selected.begin(), .surface = edit.surface});
    if (edit.phase != EditPhase::Commit) return;
    if (selected.empty()) context.workspace.run(SetSurface{.surface = edit.surface});
    std::vector<Command> commands;
    for (const std::string& name : selected) commands.push_back(SetSurface{.panel = name, .surface = edit.surface});
    context.workspace.run_together(commands);
}

}  // namespace selvedge::editor
