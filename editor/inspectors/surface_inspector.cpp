// The section of the surface design: what the selected panels show, or the garment if none is selected.
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

void apply_to_all(InspectorContext& context, const std::optional<SurfaceDesign>& surface) {
    const std::set<std::string> selected = context.selection().panels;  // a copy: commands may change it
    if (selected.empty()) context.workspace.run(SetSurface{.surface = surface});
    for (const std::string& panel : selected) context.workspace.run(SetSurface{.panel = panel, .surface = surface});
}

// A drag previews the first panel only; the others follow when it ends.
void apply_number(InspectorContext& context, const NumberEdit& edit, const SurfaceDesign& surface) {
    if (!edit) return;
    const std::set<std::string>& selected = context.selection().panels;
    if (edit.phase == EditPhase::Commit && selected.size() > 1) return apply_to_all(context, surface);
    apply_edit(context, edit, SetSurface{.panel = selected.empty() ? "" : *selected.begin(), .surface = surface});
}

constexpr std::array<std::pair<const char*, std::optional<DesignKind>>, 5> kKinds{{{"As above", std::nullopt},
                                                                                   {"Tartan", DesignKind::Tartan},
                                                                                   {"Colour", DesignKind::Colour},
                                                                                   {"Picture", DesignKind::Picture},
                                                                                   {"Test pattern", DesignKind::Test}}};

void choose_kind(InspectorContext& context, const std::optional<SurfaceDesign>& now) {
    std::vector<std::string> items;
    int chosen = 0;
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        items.emplace_back(kKinds[i].first);
        if (now && kKinds[i].second == now->kind) chosen = static_cast<int>(i);
    }
    items[0] = context.selection().panels.empty() ? "The tartan below" : "As the garment";
    row_label(context, "Shows", "What the cloth shows: of the selected panels, or of the garment if none is selected.");
    const int now_chosen = choice_box(context, {.name = "surface.kind",
                                                .shown = items[static_cast<std::size_t>(chosen)],
                                                .items = items,
                                                .chosen = chosen,
                                                .width_px = field_width()});
    if (now_chosen < 0) return;
    const std::optional<DesignKind> kind = kKinds[static_cast<std::size_t>(now_chosen)].second;
    if (!kind) return apply_to_all(context, std::nullopt);
    SurfaceDesign design{.kind = *kind};
    if (now) design.position = now->position;
    if (kind == DesignKind::Tartan) design.source = context.pattern().tartan;
    if (kind == DesignKind::Colour) design.source = "#7A1F2B";
    if (kind != DesignKind::Picture) return apply_to_all(context, design);
    if (context.open_picture) context.open_picture();
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

// Applies a colour as soon as it is whole: a drag in the picker ends with one entry of the history.
void draw_colour(InspectorContext& context, const char* name, const std::string& shown, SurfaceDesign design,
                 std::string SurfaceDesign::*place) {
    std::array<float, 3> parts = parts_of(shown);
    ImGui::SetNextItemWidth(field_width());
    const bool has_changed =
        ImGui::ColorEdit3(name, parts.data(),
                          ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions);
    note_widget(context, name);
    if (!has_changed && !ImGui::IsItemDeactivatedAfterEdit()) return;
    design.*place = colour_text(parts);
    const std::set<std::string>& selected = context.selection().panels;
    if (has_changed) {
        context.workspace.preview(SetSurface{.panel = selected.empty() ? "" : *selected.begin(), .surface = design});
    } else {
        context.workspace.document->commit();
        if (selected.size() > 1) apply_to_all(context, design);
    }
}

void draw_picture_rows(InspectorContext& context, const SurfaceDesign& design) {
    const NumberEdit turned = number_row(context,
                                         {.name = "surface.rotation",
                                          .value = design.rotation,
                                          .unit = Unit::Degrees,
                                          .tip = "Counter-clockwise about its position."},
                                         "Turned by");
    SurfaceDesign changed = design;
    changed.rotation = turned.value.value_or(0);
    apply_number(context, turned, changed);
    if (check_box(context, "surface.repeats", "Repeats", design.is_repeated, "Otherwise it is placed once.")) {
        changed = design;
        changed.is_repeated = !design.is_repeated;
        apply_to_all(context, changed);
    }
    if (design.kind != DesignKind::Picture) return;
    row_label(context, "Ground", "The colour around the picture, and behind what is transparent in it.");
    draw_colour(context, "##surface.ground", design.ground.empty() ? sim::kUsualGround : design.ground, design,
                &SurfaceDesign::ground);
}

void draw_design(InspectorContext& context, const SurfaceDesign& design) {
    SurfaceDesign changed = design;
    if (design.kind == DesignKind::Colour) {
        row_label(context, "Colour", "Of all yarns.");
        return draw_colour(context, "##surface.colour", design.source, design, &SurfaceDesign::source);
    }
    if (design.kind == DesignKind::Tartan) {
        row_label(context, "Tartan", "A name or a threadcount.");
        const auto text = text_box(context, {.name = "surface.tartan",
                                             .text = design.source,
                                             .hint = "royal_stewart",
                                             .width_px = field_width(),
                                             .wrong = tartan_error});
        changed.source = text.value_or(design.source);
        if (text) apply_to_all(context, changed);
    }
    if (design.kind == DesignKind::Picture) {
        fact(context, "Picture", std::filesystem::path(design.source).filename().string(), design.source);
        ButtonRow row(context);
        if (row.button(
                {.name = "surface.choose", .title = "Choose another...", .is_enabled = bool(context.open_picture)}))
            context.open_picture();
    }
    const bool is_tartan = design.kind == DesignKind::Tartan;
    const NumberEdit size =
        number_row(context,
                   {.name = "surface.size",
                    .value = design.size,
                    .tip = "Width of one repeat. Empty: the tartan's own, or 20 cm.",
                    .least = sim::kSmallestDesign,
                    .most = sim::kLargestDesign,
                    .may_be_empty = true,
                    .standing_for = is_tartan ? std::nullopt : std::optional(sim::kUsualDesignSize)},
                   "s: size");
    changed = design;
    changed.size = size.value;
    apply_number(context, size, changed);
    const VectorEdit moved = vector_row(context,
                                        {.name = "surface.position",
                                         .label = "p: position",
                                         .tip = "Of its lower left corner: along the weft (X) and along the warp (Y)."},
                                        design.position);
    if (moved) {
        changed = design;
        changed.position = edited(design.position, moved);
        apply_number(context, moved.number, changed);
    }
    if (!is_tartan) draw_picture_rows(context, design);
}

}  // namespace

void draw_surface(InspectorContext& context) {
    const sim::Panel* panel = shown_panel(context);
    const std::optional<SurfaceDesign> now = panel == nullptr ? context.pattern().surface : panel->surface;  // a copy
    choose_kind(context, now);
    if (now) draw_design(context, *now);
}

}  // namespace selvedge::editor
