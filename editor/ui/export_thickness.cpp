#include "editor/ui/export_thickness.h"

#include <imgui.h>
#include <algorithm>
#include <array>

#include "editor/frame/item.h"
#include "editor/inspectors/number_box.h"
#include "editor/ui/app_state.h"
#include "editor/ui/widgets.h"
#include "sim/core/error.h"

namespace selvedge::editor {
namespace {

constexpr double kThinnest = 1e-5, kThickest = 0.05;  // m

}  // namespace

ExportThickness parse_export_thickness(const std::string& text) {
    if (text == "fabric") return {.kind = ExportThickness::Kind::Fabric};
    const std::optional<double> metres = parse_quantity(text, Unit::Millimetres);
    if (!metres || !(*metres >= kThinnest && *metres <= kThickest))
        throw sim::InputError("", "thickness", "'" + text + "' is neither from 0.01 to 50 mm nor 'fabric'");
    return {.kind = ExportThickness::Kind::Given, .metres = *metres};
}

void show_export_thickness(AppState& state) {
    constexpr std::array kKinds{"Cloth without thickness", "Cloth as thick as its fabric", "Cloth as thick as"};
    ExportThickness& thickness = state.export_thickness;
    const float width = 18 * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(width);
    int kind = static_cast<int>(thickness.kind);
    if (ImGui::Combo("##thickness", &kind, kKinds.data(), static_cast<int>(kKinds.size())))
        thickness.kind = static_cast<ExportThickness::Kind>(kind);
    note_widget(state.widgets, "browser.thickness");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("With a thickness, the cloth is a closed solid with two sides, for 3D printers.");
    if (thickness.kind != ExportThickness::Kind::Given) return;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
    double mm = 1000 * thickness.metres;
    if (ImGui::InputDouble("##thickness_mm", &mm, 0, 0, "%.2f mm"))
        thickness.metres = std::clamp(mm / 1000, kThinnest, kThickest);
    note_widget(state.widgets, "browser.thickness_mm");
}

}  // namespace selvedge::editor
