#include "editor/inspectors/vector_row.h"

#include <imgui.h>

#include <cmath>
#include <span>

#include "editor/inspectors/controls.h"

namespace selvedge {
namespace {

constexpr float kRoomBeside = 23;  // of the font's size: below it boxes stand under their label

// "Place, cm": boxes that stand side by side have no room for units of their own.
std::string with_unit(const char* label, Unit unit) {
    switch (unit) {
        case Unit::Centimetres:
            return std::string(label) + ", cm";
        case Unit::Millimetres:
            return std::string(label) + ", mm";
        case Unit::Degrees:
            return std::string(label) + ", \u00B0";
        default:
            return label;
    }
}

float begin_row(InspectorContext& context, const VectorRow& row) {
    const float all = ImGui::GetContentRegionAvail().x;
    const std::string label = with_unit(row.label, row.unit);
    if (all >= kRoomBeside * ImGui::GetFontSize()) {
        row_label(context, label.c_str(), row.tip);
        return ImGui::GetContentRegionAvail().x;
    }
    elided_text(label, all, to_colour(context.theme.faint));
    show_tip(row.tip);
    return all;
}

VectorEdit draw_row(InspectorContext& context, const VectorRow& row, std::span<const double> values) {
    constexpr std::array<const char*, 3> kEndings{".x", ".y", ".z"};
    const float all = begin_row(context, row), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto count = static_cast<float>(values.size());
    const float width = std::floor((all - gap * (count - 1)) / count);
    float axis_width = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        axis_width = std::max(axis_width, ImGui::CalcTextSize(row.axes[i]).x);
    VectorEdit edit;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string name = std::string(row.name) + kEndings[i];
        if (i > 0) ImGui::SameLine(0, gap);
        const NumberEdit number = number_box(context, {.name = name.c_str(),
                                                       .label = row.axes[i],
                                                       .value = values[i],
                                                       .unit = row.unit,
                                                       .tip = row.tip,
                                                       .width_px = width,
                                                       .label_px = axis_width,
                                                       .least = row.least,
                                                       .has_unit = false});
        if (number) edit = {.phase = number.phase, .axis = static_cast<int>(i), .number = number};
    }
    return edit;
}

}  // namespace

VectorEdit vector_row(InspectorContext& context, const VectorRow& row, const Vec3d& value) {
    return draw_row(context, row, std::span(value.data(), 3));
}

VectorEdit vector_row(InspectorContext& context, const VectorRow& row, const Vec2d& value) {
    return draw_row(context, row, std::span(value.data(), 2));
}

Vec3d edited(Vec3d value, const VectorEdit& edit) {
    if (edit.number.value) value[edit.axis] = *edit.number.value;
    return value;
}

Vec2d edited(Vec2d value, const VectorEdit& edit) {
    if (edit.number.value) value[edit.axis] = *edit.number.value;
    return value;
}

NumberEdit number_row(InspectorContext& context, NumberBox box, const char* label) {
    box.label = label;
    box.label_px = label_width();
    box.width_px = label_width() + ImGui::GetStyle().ItemInnerSpacing.x + field_width();
    return number_box(context, box);
}

}  // namespace selvedge
