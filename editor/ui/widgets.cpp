#include "editor/ui/widgets.h"

#include <imgui.h>

#include "editor/ui/actions.h"
#include "editor/ui/desk.h"
#include "editor/ui/icons.h"

namespace selvedge {
namespace {

ImU32 colour_of(const Rgb8& rgb, int alpha = 255) {
    return IM_COL32(rgb[0], rgb[1], rgb[2], alpha);
}

}  // namespace

void note_widget(WidgetMap& widgets, const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    widgets[name] = {{low.x, low.y}, {high.x, high.y}};
}

void tip(const std::string& words) {
    if (words.empty() || ImGui::GetIO().MouseDown[0]) return;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool button(Desk& desk, const std::string& name, const std::string& label) {
    const bool is_pressed = ImGui::Button((label + "##" + name).c_str());
    note_widget(desk.widgets, name);
    return is_pressed;
}

void icon_button(Desk& desk, const Action& action, const std::string& icon, float side_px) {
    const bool is_on = action.is_on && action.is_on(desk);
    const bool can = !action.can || action.can(desk);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushID(action.id.c_str());
    const bool is_pressed = ImGui::InvisibleButton("##icon", {side_px, side_px});
    ImGui::PopID();
    note_widget(desk.widgets, action.id);
    const ImVec2 high{low.x + side_px, low.y + side_px};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = side_px * 0.16F;
    if (is_on) list.AddRectFilled(low, high, colour_of(desk.theme.accent), rounding);
    if (!is_on && can && ImGui::IsItemHovered())
        list.AddRectFilled(low, high, colour_of(desk.theme.accent, 36), rounding);
    if (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)
        list.AddRect(low, high, colour_of(desk.theme.accent), rounding);
    const float inset = side_px * 0.2F;
    const Rgb8 ink = is_on ? desk.theme.field : can ? desk.theme.ink : desk.theme.line;
    draw_icon(list, icon, {low.x + inset, low.y + inset}, side_px - 2 * inset, ink);
    const std::string keys = chord_words(action);
    tip(action.title + (keys.empty() ? "" : "  (" + keys + ")") + (action.tip.empty() ? "" : "\n" + action.tip));
    if (is_pressed) run_action(desk, action);
}

bool action_row(Desk& desk, const Action& action, bool is_chosen) {
    const bool can = !action.can || action.can(desk);
    ImGui::PushID(action.id.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(can ? ImGuiCol_Text : ImGuiCol_TextDisabled));
    const bool is_pressed = ImGui::Selectable(action.title.c_str(), is_chosen);
    ImGui::PopStyleColor();
    note_widget(desk.widgets, "find." + action.id);
    const std::string keys = chord_words(action);
    const std::string aside = action.menu + (keys.empty() ? "" : "   " + keys);
    const float width = ImGui::CalcTextSize(aside.c_str()).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::TextDisabled("%s", aside.c_str());
    ImGui::PopID();
    return is_pressed;
}

void coloured_text(const Rgb8& colour, const std::string& words) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(colour));
    ImGui::TextWrapped("%s", words.c_str());
    ImGui::PopStyleColor();
}

}  // namespace selvedge
