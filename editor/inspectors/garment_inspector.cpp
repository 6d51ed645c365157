// The section of the garments that are worn over each other, the outermost first.
#include <imgui.h>
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/property_inspector.h"
#include "sim/pattern/garments.h"

namespace selvedge::editor {
namespace {

std::string layers_text(const sim::Garment& garment) {
    if (garment.lowest_layer == garment.highest_layer) return "layer " + std::to_string(garment.lowest_layer);
    return "layers " + std::to_string(garment.lowest_layer) + " to " + std::to_string(garment.highest_layer);
}

// The names of the garment's panels, for the selection.
Selection panels_of(const sim::Pattern& pattern, const sim::Garment& garment) {
    Selection selection;
    for (const int p : garment.panels) selection.panels.insert(pattern.panels[static_cast<std::size_t>(p)].name);
    return selection;
}

void draw_garment(InspectorContext& context, const sim::Garment& garment) {
    std::set<std::string>& hidden = context.workspace.look.hidden_garments;
    const bool is_shown = !hidden.contains(garment.name);
    const std::string title = garment.name + ", " + layers_text(garment);
    if (check_box(context, ("garment.show." + garment.name).c_str(), title.c_str(), is_shown,
                  "Whether the 3D view shows it. Those further down are worn under it.")) {
        if (is_shown) {
            hidden.insert(garment.name);
        } else {
            hidden.erase(garment.name);
        }
    }
    const std::string select = "garment.select." + garment.name, remove = "garment.remove." + garment.name;
    ButtonRow row(context);
    if (row.button({.name = select.c_str(), .title = "Select", .tip = "Selects its panels."})) {
        context.workspace.document->select(panels_of(context.pattern(), garment));
    } else if (row.button({.name = remove.c_str(), .title = "Remove", .tip = "Its panels and all seams to them."})) {
        if (context.workspace.run(TakeOff{garment.name})) hidden.erase(garment.name);
    }
}

}  // namespace

bool has_garments_section(const InspectorContext& context) {
    const std::vector<sim::Garment> garments = garments_of(context.pattern());
    const std::set<std::string>& hidden = context.workspace.look.hidden_garments;
    return garments.size() > 1 ||
           std::ranges::any_of(garments, [&](const auto& one) { return hidden.contains(one.name); });
}

void draw_garments_section(InspectorContext& context) {
    std::vector<sim::Garment> garments = garments_of(context.pattern());
    std::ranges::reverse(garments);
    for (const sim::Garment& garment : garments) {
        ImGui::PushID(garment.name.c_str());
        draw_garment(context, garment);
        ImGui::PopID();
    }
}

}  // namespace selvedge::editor
