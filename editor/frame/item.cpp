#include "editor/frame/item.h"

#include <imgui.h>

namespace selvedge::editor {
namespace {

constexpr std::string_view kDots = "...";

bool begins_letter(std::string_view text, std::size_t at) {
    return at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U;
}

// Keeps at most `kept` bytes of the text.
std::string with_dots(std::string_view text, std::size_t kept, Elide what) {
    std::size_t head = what == Elide::End ? kept : (kept + 1) / 2;
    std::size_t tail = text.size() - (kept - head);
    while (!begins_letter(text, head)) --head;
    while (!begins_letter(text, tail)) ++tail;
    return std::string(text.substr(0, head)).append(kDots).append(text.substr(tail));
}

}  // namespace

void note_widget(WidgetMap& widgets, const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    widgets[name] = {{low.x, low.y}, {high.x, high.y}};
}

void show_tip(const std::string& text, float width) {
    if (text.empty() || ImGui::GetIO().MouseDown[0]) return;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(width * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void press_area(const char* id, const Vec2f& size_px, Cover cover) {
    constexpr ImGuiButtonFlags kAll =
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;
#if IMGUI_VERSION_NUM >= 18970
    if (cover == Cover::ByLaterItems) ImGui::SetNextItemAllowOverlap();
#endif
    ImGui::InvisibleButton(id, {size_px.x(), size_px.y()}, kAll);
#if IMGUI_VERSION_NUM < 18970
    if (cover == Cover::ByLaterItems) ImGui::SetItemAllowOverlap();
#endif
}

void drag_area(const char* id, const Vec2f& size_px) {
#if IMGUI_VERSION_NUM >= 18940
    ImGui::PushTabStop(false);
    ImGui::InvisibleButton(id, {size_px.x(), size_px.y()});
    ImGui::PopTabStop();
#else
    ImGui::InvisibleButton(id, {size_px.x(), size_px.y()});  // only boxes are stops of Tab
#endif
}

std::string elided(std::string_view text, float width, Elide what,
                   const std::function<float(std::string_view)>& width_of) {
    if (width_of(text) <= width) return std::string(text);
    std::size_t fits = 0, too_many = text.size();
    while (too_many - fits > 1) {
        const std::size_t kept = (fits + too_many) / 2;
        (width_of(with_dots(text, kept, what)) <= width ? fits : too_many) = kept;
    }
    return with_dots(text, fits, what);
}

std::string elided(std::string_view text, float width, Elide what) {
    return elided(text, width, what,
                  [](std::string_view part) { return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x; });
}

}  // namespace selvedge::editor
