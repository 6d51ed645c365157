#include "editor/ui/widgets.h"

#include <imgui.h>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "editor/frame/item.h"
#include "editor/tools/tool_table.h"
#include "editor/ui/actions.h"
#include "editor/ui/app_state.h"

namespace selvedge::editor {

std::uint32_t colour_of(const sim::Rgb8& rgb, int alpha) {
    return IM_COL32(rgb[0], rgb[1], rgb[2], alpha);
}

bool button(AppState& state, const std::string& name, const std::string& label) {
    const bool is_pressed = ImGui::Button((label + "##" + name).c_str());
    note_widget(state.widgets, name);
    return is_pressed;
}

void icon_button(AppState& state, const Action& action, const std::string& icon, float side_px) {
    const bool is_on = action.is_on && action.is_on(state);
    const bool can = !action.can || action.can(state);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushID(action.id.c_str());
    const bool is_pressed = ImGui::InvisibleButton("##icon", {side_px, side_px});
    ImGui::PopID();
    note_widget(state.widgets, action.id);
    const ImVec2 high{low.x + side_px, low.y + side_px};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = side_px * 0.16F;
    if (is_on) list.AddRectFilled(low, high, colour_of(state.theme.accent), rounding);
    if (!is_on && can && ImGui::IsItemHovered())
        list.AddRectFilled(low, high, colour_of(state.theme.accent, 36), rounding);
    if (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)
        list.AddRect(low, high, colour_of(state.theme.accent), rounding);
    const float inset = side_px * 0.2F;
    const sim::Rgb8 ink = is_on ? state.theme.field : can ? state.theme.ink : state.theme.line;
    draw_icon(list, icon, {low.x + inset, low.y + inset}, side_px - 2 * inset, ink);
    const std::string keys = chord_text(action);
    show_tip(action.title + (keys.empty() ? "" : "  (" + keys + ")") + (action.tip.empty() ? "" : "\n" + action.tip),
             kTipWidth);
    if (is_pressed) run_action(state, action);
}

bool action_row(AppState& state, const Action& action, bool is_chosen) {
    const bool can = !action.can || action.can(state);
    ImGui::PushID(action.id.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(can ? ImGuiCol_Text : ImGuiCol_TextDisabled));
    const bool is_pressed = ImGui::Selectable(action.title.c_str(), is_chosen);
    ImGui::PopStyleColor();
    note_widget(state.widgets, "find." + action.id);
    const std::string keys = chord_text(action);
    const std::string aside = action.menu + (keys.empty() ? "" : "   " + keys);
    const float width = ImGui::CalcTextSize(aside.c_str()).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::TextDisabled("%s", aside.c_str());
    ImGui::PopID();
    return is_pressed;
}

void coloured_text(const sim::Rgb8& colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(colour));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void tip_of_whole(const std::string& text, const std::string& shown) {
    if (text != shown) show_tip(text, kTipWidth);
}

namespace {

// Of actions that are no tools (those: ToolInfo::icon). An unknown command of a path ends the icon.
constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kIcons{{
    {"play", "M4 2.5 L13 8 L4 13.5 Z"},
    {"pause", "M5 3 L5 13 M11 3 L11 13"},
    {"reset", "M3 6 L3 2 M3 6 L7 6 M3 6 L6 3.4 L10 3.2 L13 6 L13 10 L10 13 L6 13 L3.5 10.5"},
    {"frame", "M2 5 L2 2 L5 2 M11 2 L14 2 L14 5 M14 11 L14 14 L11 14 M5 14 L2 14 L2 11"},
    {"body", "C8 3.5 2 M4 15 L5 8 L8 6.5 L11 8 L12 15"},
    {"to_start", "M3.5 3 L3.5 13 M13 3 L6 8 L13 13 Z"},
    {"loop", "M3 9 L3 6 L5 4 L13 4 M11 2 L13 4 L11 6 M13 7 L13 10 L11 12 L3 12 M5 10 L3 12 L5 14"},
    {"motion", "C9 2.6 1.6 M9 5.5 L7.5 9.5 L10.5 11.5 L10 15 M7.5 9.5 L6 12 L3 14 M8.6 6.5 L5 8.5 M9 6 L12.5 8.5"},
    {"threads", "M3 2 L6 8 L3 14 M13 2 L10 8 L13 14 M6 8 L10 8 M4.5 5 L11.5 5 M4.5 11 L11.5 11"},
    {"points", "D4 4 1.6 D12 4 1.6 D4 12 1.6 D12 12 1.6 D8 8 1.6"},
    {"edges", "M2 13 L8 3 L14 13 Z M5 8 L11 8 M8 13 L5 8 M8 13 L11 8"},
    {"undo", "M6 3 L3 6 L6 9 M3 6 L10 6 L13 9 L10 12 L6 12"},
    {"redo", "M10 3 L13 6 L10 9 M13 6 L6 6 L3 9 L6 12 L10 12"},
    {"save", "M3 3 L11 3 L13 5 L13 13 L3 13 Z M6 3 L6 6 L10 6 L10 3 M5 13 L5 9 L11 9 L11 13"},
    {"search", "C7 7 4 M10 10 L14 14"},
}};

class Pen {
 public:
    Pen(ImDrawList& list, const Vec2f& low, float side_px, ImU32 colour)
        : list_(list), low_(low), unit_(side_px / 16), colour_(colour) {}

    void draw(std::string_view path) {
        while (!path.empty()) {
            const char letter = path.front();
            path.remove_prefix(1);
            if (letter == ' ') continue;
            if (letter == 'Z') {
                stroke(true);
            } else if (!step(letter, path)) {
                break;
            }
        }
        stroke(false);
    }

 private:
    bool step(char letter, std::string_view& path) {
        const float x = number(path), y = number(path);
        if (letter == 'C' || letter == 'D') {
            stroke(false);
            circle({x, y}, number(path), letter == 'D');
            return true;
        }
        if (letter == 'M') stroke(false);
        if (letter != 'M' && letter != 'L') return false;
        points_.push_back(at({x, y}));
        return true;
    }

    static float number(std::string_view& path) {
        while (path.starts_with(' ')) path.remove_prefix(1);
        float value = 0;
        const auto [end, error] = std::from_chars(path.data(), path.data() + path.size(), value);
        path.remove_prefix(static_cast<std::size_t>(end - path.data()));
        return value;
    }

    ImVec2 at(const Vec2f& p) const { return {low_.x() + p.x() * unit_, low_.y() + p.y() * unit_}; }

    void circle(const Vec2f& centre, float radius, bool is_filled) {
        if (is_filled) {
            list_.AddCircleFilled(at(centre), radius * unit_, colour_);
        } else {
            list_.AddCircle(at(centre), radius * unit_, colour_, 0, 1.2F * unit_);
        }
    }

    void stroke(bool is_closed) {
        const int flags = is_closed ? ImDrawFlags_Closed : ImDrawFlags_None;
        if (points_.size() > 1) {
            list_.AddPolyline(points_.data(), static_cast<int>(points_.size()), colour_, flags, 1.2F * unit_);
        }
        points_.clear();
    }

    ImDrawList& list_;
    Vec2f low_;
    float unit_;
    ImU32 colour_;
    std::vector<ImVec2> points_;
};

std::string_view path_of(std::string_view name) {
    for (const auto& [known, path] : kIcons) {
        if (known == name) return path;
    }
    for (const ToolInfo& tool : all_tools()) {
        if (tool.id == name) return tool.icon;
    }
    return {};
}

}  // namespace

void draw_icon(ImDrawList& list, std::string_view name, const Vec2f& low, float side_px, const sim::Rgb8& colour) {
    Pen(list, low, side_px, IM_COL32(colour[0], colour[1], colour[2], 255)).draw(path_of(name));
}

void MessageClock::update(Messages& messages, double seconds) {
    constexpr double kNoteStays = 6, kWarningStays = 12;  // s
    if (messages.count() != count_) {
        count_ = messages.count();
        shown_for_ = 0;
        return;
    }
    const Message* shown = messages.shown();
    if (shown == nullptr || shown->kind == MessageKind::Error) return;
    shown_for_ += seconds;
    if (shown_for_ >= (shown->kind == MessageKind::Note ? kNoteStays : kWarningStays)) messages.dismiss();
}

}  // namespace selvedge::editor
