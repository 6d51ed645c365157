// The section of the photos under the sheet.
#include <imgui.h>
#include <filesystem>
#include <string>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/property_inspector.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {
namespace {

void draw_underlay(InspectorContext& context, std::size_t index) {
    const sim::Underlay underlay = context.pattern().underlays[index];  // a copy: fields may change it
    elided_text(std::filesystem::path(underlay.file).filename().string(), ImGui::GetContentRegionAvail().x,
                to_colour(context.theme.ink));
    const std::string place = "underlay." + std::to_string(index) + ".";
    sim::Underlay changed = underlay;
    const NumberEdit opacity = number_row(context,
                                          {.name = (place + "opacity").c_str(),
                                           .value = underlay.opacity,
                                           .unit = Unit::Factor,
                                           .tip = "How strongly the photo is drawn, 0 to 1.",
                                           .least = 0,
                                           .most = 1},
                                          "Opacity");
    changed.opacity = opacity.value.value_or(underlay.opacity);
    apply_edit(context, opacity, set_underlay(context.pattern(), index, changed, "Change photo"));
    changed = underlay;
    const NumberEdit rotation = number_row(context,
                                           {.name = (place + "rotation").c_str(),
                                            .value = underlay.rotation,
                                            .unit = Unit::Degrees,
                                            .tip = "Counter-clockwise about the middle of the photo."},
                                           "Turned by");
    changed.rotation = rotation.value.value_or(underlay.rotation);
    apply_edit(context, rotation, set_underlay(context.pattern(), index, changed, "Turn photo"));
    ButtonRow row(context);
    if (row.button({.name = (place + "fit").c_str(),
                    .title = "Fit...",
                    .tip = "Click two points of the photo and type how far apart they are.",
                    .is_enabled = bool(context.fit_photo)})) {
        context.fit_photo();
    } else if (row.button({.name = (place + "remove").c_str(), .title = "Remove", .tip = "The file itself stays."})) {
        SetUnderlays command{.underlays = context.pattern().underlays, .what = "Remove photo"};
        command.underlays.erase(command.underlays.begin() + static_cast<std::ptrdiff_t>(index));
        context.workspace.run(command);
    }
}

}  // namespace

void draw_underlays_section(InspectorContext& context) {
    for (std::size_t i = 0; i < context.pattern().underlays.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        draw_underlay(context, i);
        ImGui::PopID();
    }
}

}  // namespace selvedge::editor
