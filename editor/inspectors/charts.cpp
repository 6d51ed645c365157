#include "editor/inspectors/charts.h"

#include <imgui.h>

#include <algorithm>

#include "editor/inspectors/controls.h"

namespace selvedge {
namespace {

constexpr float kBarHeight = 3.2F;    // of the font's size
constexpr float kSparkHeight = 2.0F;  // of the font's size

}  // namespace

void bar_chart(const InspectorContext& context, const BarChart& chart) {
    if (chart.figures.empty()) return;
    const float em = ImGui::GetFontSize(), height = kBarHeight * em;
    const float gap = 0.25F * em, room = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<float>(chart.figures.size());
    const float width = std::min(3.2F * em, (room - gap * (count - 1)) / count);
    const int most = std::max(1, *std::max_element(chart.figures.begin(), chart.figures.end()));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 line = ImGui::GetColorU32(to_colour(context.theme.line));
    list.AddLine({low.x, low.y + height}, {low.x + room, low.y + height}, line);
    for (std::size_t i = 0; i < chart.figures.size(); ++i) {
        const float left = low.x + static_cast<float>(i) * (width + gap);
        const float share = static_cast<float>(chart.figures[i]) / static_cast<float>(most);
        const float top = low.y + height * (1 - share);
        if (chart.figures[i] > 0) {
            list.AddRectFilled({left, std::min(top, low.y + height - 1)}, {left + width, low.y + height},
                               ImGui::GetColorU32(to_colour(chart.colour(i))));
        }
        const std::string number = std::to_string(i);
        const float middle = left + (width - ImGui::CalcTextSize(number.c_str()).x) / 2;
        list.AddText({middle, low.y + height + 0.1F * em}, ImGui::GetColorU32(to_colour(context.theme.faint)),
                     number.c_str());
        ImGui::SetCursorScreenPos({left, low.y});
        ImGui::PushID(static_cast<int>(i));
        ImGui::InvisibleButton("bar", {width, height + ImGui::GetTextLineHeight()});
        show_tip(chart.tip(i));
        ImGui::PopID();
    }
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy({room, height + 1.2F * em});
}

void spark_line(const InspectorContext& context, const SparkLine& line) {
    const float height = kSparkHeight * ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, ImGui::GetColorU32(to_colour(context.theme.field)),
                       ImGui::GetStyle().FrameRounding);
    ImGui::Dummy({width, height});
    show_tip(line.tip);
    float most = 0;
    for (std::size_t i = 0; i < line.count; ++i) most = std::max(most, line.figure(i));
    if (line.count < 2 || !(most > 0)) return;
    constexpr float kHeadroom = 1.15F;
    const float step = width / static_cast<float>(std::max<std::size_t>(1, line.full - 1));
    std::vector<ImVec2> points;
    for (std::size_t i = 0; i < line.count; ++i) {
        const float x = low.x + width - step * static_cast<float>(line.count - 1 - i);
        points.emplace_back(x, low.y + height * (1 - line.figure(i) / (most * kHeadroom)));
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()),
                     ImGui::GetColorU32(to_colour(context.theme.accent)), 0, 0.1F * ImGui::GetFontSize());
}

}  // namespace selvedge
