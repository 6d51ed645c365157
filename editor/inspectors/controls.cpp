#include "editor/inspectors/controls.h"

#include <imgui.h>
#include <algorithm>

namespace selvedge::editor {
namespace {

float text_width(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str(), text.c_str() + text.size()).x;
}

}  // namespace

ImVec4 to_colour(const sim::Rgb8& rgb, float alpha) {
    return {static_cast<float>(rgb[0]) / 255, static_cast<float>(rgb[1]) / 255, static_cast<float>(rgb[2]) / 255,
            alpha};
}

ImVec4 tinted(const sim::Rgb8& ground, const sim::Rgb8& with) {
    constexpr float kShare = 0.14F;
    const ImVec4 a = to_colour(ground), b = to_colour(with);
    return {a.x + (b.x - a.x) * kShare, a.y + (b.y - a.y) * kShare, a.z + (b.z - a.z) * kShare, 1};
}

ImTextureID texture_id(UiTexture texture) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

std::string with_key(const InspectorContext& context, const std::string& text, std::string_view action) {
    const std::string key = context.key_of ? context.key_of(action) : "";
    return key.empty() ? text : text + " (" + key + ")";
}

void note_widget(InspectorContext& context, const std::string& name) {
    if (context.widgets != nullptr) note_widget(*context.widgets, name);
}

void back_to(float left) {
    ImGui::SameLine();
    ImGui::SetCursorPosX(left);
}

void elided_text(const std::string& text, float width_px, const ImVec4& colour) {
    const std::string shown = elided(text, width_px);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(shown.c_str());
    ImGui::PopStyleColor();
    if (shown != text) show_tip(text);
}

void heading(const InspectorContext& context, const char* title) {
    ImGui::Spacing();
    ImFont* bold = context.fonts != nullptr ? context.fonts->bold : nullptr;
    if (bold != nullptr) ImGui::PushFont(bold);
    ImGui::TextUnformatted(elided(title, ImGui::GetContentRegionAvail().x).c_str());
    if (bold != nullptr) ImGui::PopFont();
}

void paragraph(const InspectorContext& context, const std::string& text) {
    message_text(context.theme.faint, text);
}

void message_text(const sim::Rgb8& colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_colour(colour));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

bool folding(const char* title, Fold at_first) {
    ImGui::Spacing();
    return ImGui::CollapsingHeader(title, at_first == Fold::Open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

float label_width() {
    const float all = ImGui::GetContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    return std::min(0.38F * all, 8.5F * ImGui::GetFontSize());
}

float field_width() {
    return ImGui::GetContentRegionMax().x - ImGui::GetWindowContentRegionMin().x - label_width() -
           ImGui::GetStyle().ItemInnerSpacing.x;
}

void row_label(const InspectorContext& context, const char* label, const std::string& tip) {
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    elided_text(label, label_width(), to_colour(context.theme.faint));
    show_tip(tip);
    ImGui::SameLine(left + label_width() + ImGui::GetStyle().ItemInnerSpacing.x);
}

void fact(const InspectorContext& context, const char* label, const std::string& value, const std::string& tip) {
    row_label(context, label, tip);
    ImGui::AlignTextToFramePadding();
    elided_text(value, field_width(), to_colour(context.theme.ink));
    show_tip(tip);
}

bool ButtonRow::button(const Button& button) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = ImGui::GetContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    const std::string title = elided(button.title, room - 2 * style.FramePadding.x);
    const float width = text_width(title) + 2 * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    if (!is_first_ && ImGui::GetItemRectMax().x + style.ItemInnerSpacing.x + width <= right) {
        ImGui::SameLine(0, style.ItemInnerSpacing.x);
    }
    is_first_ = false;
    ImGui::BeginDisabled(!button.is_enabled);
    if (button.is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    const bool is_pressed = ImGui::Button((title + "##" + button.name).c_str());
    if (button.is_on) ImGui::PopStyleColor();
    ImGui::EndDisabled();
    show_tip(button.tip);
    note_widget(context_, button.name);
    return is_pressed;
}

bool check_box(InspectorContext& context, const char* name, const char* title, bool value, const std::string& tip) {
    const float room =
        ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - ImGui::GetStyle().ItemInnerSpacing.x;
    const std::string label = elided(title, room) + "##" + name;
    const bool is_changed = ImGui::Checkbox(label.c_str(), &value);
    show_tip(tip);
    note_widget(context, name);
    return is_changed;
}

int choice_box(InspectorContext& context, const Choice& choice) {
    int chosen = -1;
    ImGui::SetNextItemWidth(choice.width_px);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = choice.width_px - ImGui::GetFrameHeight() - 2 * style.FramePadding.x;
    const bool is_open = ImGui::BeginCombo((std::string("##") + choice.name).c_str(),
                                           elided(choice.shown, room).c_str(), ImGuiComboFlags_HeightLarge);
    if (!is_open) {
        show_tip(choice.tip);
        note_widget(context, choice.name);
        return -1;
    }
    for (std::size_t i = 0; i < choice.items.size(); ++i) {
        const bool is_chosen = static_cast<int>(i) == choice.chosen;
        if (ImGui::Selectable(choice.items[i].c_str(), is_chosen)) chosen = static_cast<int>(i);
        note_widget(context, std::string(choice.name) + "." + std::to_string(i));
        if (is_chosen) ImGui::SetItemDefaultFocus();
    }
    ImGui::EndCombo();
    return chosen;
}

namespace {

constexpr float kBarHeight = 3.2F;    // font heights
constexpr float kSparkHeight = 2.0F;  // font heights

}  // namespace

void bar_chart(const InspectorContext& context, const BarChart& chart) {
    if (chart.values.empty()) return;
    const float em = ImGui::GetFontSize(), height = kBarHeight * em;
    const float gap = 0.25F * em, room = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<float>(chart.values.size());
    const float width = std::min(3.2F * em, (room - gap * (count - 1)) / count);
    const int most = std::max(1, *std::max_element(chart.values.begin(), chart.values.end()));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 line = ImGui::GetColorU32(to_colour(context.theme.line));
    list.AddLine({low.x, low.y + height}, {low.x + room, low.y + height}, line);
    for (std::size_t i = 0; i < chart.values.size(); ++i) {
        const float left = low.x + static_cast<float>(i) * (width + gap);
        const float share = static_cast<float>(chart.values[i]) / static_cast<float>(most);
        const float top = low.y + height * (1 - share);
        if (chart.values[i] > 0) {
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
    for (std::size_t i = 0; i < line.count; ++i) most = std::max(most, line.value(i));
    if (line.count < 2 || !(most > 0)) return;
    constexpr float kHeadroom = 1.15F;
    const float step = width / static_cast<float>(std::max<std::size_t>(1, line.full - 1));
    std::vector<ImVec2> points;
    for (std::size_t i = 0; i < line.count; ++i) {
        const float x = low.x + width - step * static_cast<float>(line.count - 1 - i);
        points.emplace_back(x, low.y + height * (1 - line.value(i) / (most * kHeadroom)));
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()),
                     ImGui::GetColorU32(to_colour(context.theme.accent)), 0, 0.1F * ImGui::GetFontSize());
}

}  // namespace selvedge::editor
