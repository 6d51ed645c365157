// What is selected, and the garment as a whole.
#include <imgui.h>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/fabric_text.h"
#include "editor/inspectors/number_box.h"
#include "editor/inspectors/pattern_figures.h"
#include "editor/inspectors/property_sections.h"
#include "editor/inspectors/vector_row.h"
#include "sim/pattern/fabric.h"

namespace selvedge {
namespace {

constexpr double kUsualEdgeLength = 0.05;                    // m, of the mesher
constexpr double kShortestMesh = 0.005, kLongestMesh = 0.5;  // m, as files have it

std::string counted(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void draw_selected(InspectorContext& context, const Selection& selected) {
    if (selected.seams.size() == 1) draw_seam_section(context, *selected.seams.begin());
    if (selected.seams.size() > 1) {
        heading(context, (std::to_string(selected.seams.size()) + " seams").c_str());
        paragraph(context, "The list of seams shows each of them.");
    }
    for (const PartRef& notch : selected.notches) draw_notch_section(context, notch);
    for (const PartRef& line : selected.internal_lines) draw_internal_line_section(context, line);
    for (const PartRef& edge : selected.edges) draw_edge_section(context, edge);
    if (!selected.vertices.empty()) draw_vertices_section(context);
    if (selected.panels.size() == 1) draw_panel_section(context, *selected.panels.begin());
    if (selected.panels.size() > 1) draw_panels_section(context);
}

}  // namespace

void fabric_row(InspectorContext& context, const std::string& panel) {
    const Pattern& pattern = context.pattern();
    const std::optional<int> index = panel_index(pattern, panel);
    const std::string own = index ? pattern.panels[static_cast<std::size_t>(*index)].fabric : pattern.fabric;
    const std::string usual = index && !pattern.fabric.empty() ? pattern.fabric : Fabric{}.name;
    std::vector<std::string> names = fabric_names(),
                             shown{(index ? "As the garment: " : "Usual: ") + readable_name(usual)};
    int chosen = own.empty() ? 0 : -1;
    for (const std::string& name : names) {
        if (name == own) chosen = static_cast<int>(shown.size());
        shown.push_back(readable_name(name));
    }
    row_label(context, "Fabric", "What it is made of; its figures stand under Materials.");
    const int now = choice_box(context, {.name = panel.empty() ? "pattern.fabric" : "panel.fabric",
                                         .shown = own.empty() ? shown[0] : readable_name(own),
                                         .items = shown,
                                         .chosen = chosen,
                                         .tip = panel.empty() ? "The fabric of all panels that have none of their own."
                                                              : "The fabric of this panel.",
                                         .width_px = field_width()});
    if (now < 0) return;
    context.workspace.run(
        SetFabric{.panel = panel, .fabric = now == 0 ? "" : names[static_cast<std::size_t>(now) - 1]});
}

void draw_pattern_section(InspectorContext& context) {
    const Pattern& pattern = context.pattern();
    ImGui::PushID("pattern");
    row_label(context, "Name", "What the garment is called.");
    const auto name = text_box(context, {.name = "pattern.name",
                                         .text = pattern.name,
                                         .hint = "unnamed",
                                         .tip = "What the garment is called.",
                                         .width_px = field_width()});
    if (name) context.workspace.run(RenamePattern{*name});
    const VectorEdit moved = vector_row(context,
                                        {.name = "pattern.translation",
                                         .label = "GT: all panels",
                                         .tip = "Moves all panels in the room, with their middle to this place."},
                                        garment_centre(pattern));
    if (moved) {
        Vec3d by = Vec3d::Zero();
        by[moved.axis] = moved.number.by();
        carry(context, moved.number, TranslateAll{by});
    }
    fabric_row(context, "");
    const NumberEdit length = number_row(context,
                                         {.name = "pattern.edge_length",
                                          .value = pattern.edge_length,
                                          .tip = "How far points of the coarsest mesh lie apart. Empty: 5 cm.",
                                          .least = kShortestMesh,
                                          .most = kLongestMesh,
                                          .may_be_empty = true,
                                          .standing_for = kUsualEdgeLength},
                                         "Mesh edges");
    carry(context, length, SetEdgeLength{length.value});
    fact(context, "Parts", counted(pattern.panels.size(), "panel") + ", " + counted(pattern.seams.size(), "seam"),
         "What the garment consists of.");
    ImGui::PopID();
}

void draw_properties(InspectorContext& context) {
    const Selection selected = context.selection();  // a copy: boxes may change it
    if (context.pattern().panels.empty()) {
        paragraph(context, "No panels yet. Draw one on the sheet, or open a file.");
    } else if (selected.is_empty()) {
        paragraph(context, "Click a panel, point, edge or seam to see its figures here.");
    }
    draw_selected(context, selected);
    if (folding("Garment", Fold::Open)) draw_pattern_section(context);
}

}  // namespace selvedge
