#include "editor/ui/start_page.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "editor/ui/desk.h"
#include "editor/ui/elide.h"
#include "editor/ui/files.h"
#include "editor/ui/widgets.h"

namespace selvedge {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 8> kKeys{{{"Space", "start and pause the drape"},
                                                                    {"H, S, E", "draw a polygon, rectangle, ellipse"},
                                                                    {"Z, X, C", "move points, add points, bend edges"},
                                                                    {"N, M", "sew edges, sew freely"},
                                                                    {"V", "select and move"},
                                                                    {"F", "show what is selected, or all"},
                                                                    {"Ctrl+Z", "undo, also while it drapes"},
                                                                    {"Ctrl+K", "find any action by its name"}}};

void show_examples(Desk& desk) {
    const float unit = ImGui::GetFontSize();
    for (const Example& example : desk.services.examples) {
        if (button(desk, "example." + example.title, example.title)) open_example(desk, example);
        ImGui::SameLine(9 * unit);
        ImGui::TextWrapped("%s", example.what.c_str());
    }
}

void show_recent(Desk& desk) {
    const std::vector<std::string> files = desk.services.recent_files();
    if (files.empty()) return;
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    ImGui::PushFont(desk.fonts.bold);
    ImGui::TextUnformatted("Go on with");
    ImGui::PopFont();
    constexpr std::size_t kMost = 5;
    for (std::size_t i = 0; i < std::min(kMost, files.size()); ++i) {
        const std::string shown = elided(files[i], ImGui::GetContentRegionAvail().x, Elide::Middle);
        if (ImGui::Selectable((shown + "##" + std::to_string(i)).c_str())) open_file(desk, files[i]);
        tip_of_whole(files[i], shown);
    }
}

void show_keys(Desk& desk) {
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.5F});
    ImGui::PushFont(desk.fonts.bold);
    ImGui::TextUnformatted("Keys");
    ImGui::PopFont();
    for (const auto& [key, what] : kKeys) {
        ImGui::TextUnformatted(key);
        ImGui::SameLine(9 * ImGui::GetFontSize());
        ImGui::TextDisabled("%s", what);
    }
}

}  // namespace

void show_start_page(Desk& desk) {
    if (desk.tools.kind() != ToolKind::Select) desk.shows_start_page = false;  // someone has begun
    if (!desk.shows_start_page || desk.browser.is_open()) return;
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(38 * unit, display.x - 2 * unit);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({width, 0});
    constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                            ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.6F * unit, 1.4F * unit});
    if (ImGui::Begin("##start", nullptr, kFlags)) {
        ImGui::PushFont(desk.fonts.large);
        ImGui::TextUnformatted("Selvedge");
        ImGui::PopFont();
        ImGui::TextDisabled("Draw panels, sew them, put them on a body, let them fall.");
        ImGui::Dummy({0, unit * 0.5F});
        ImGui::PushFont(desk.fonts.bold);
        ImGui::TextUnformatted("Begin with");
        ImGui::PopFont();
        if (button(desk, "start.empty", "Empty sheet")) desk.shows_start_page = false;
        ImGui::SameLine();
        if (button(desk, "start.open", "Open a file...")) browse_to_open(desk);
        show_examples(desk);
        show_recent(desk);
        show_keys(desk);
        const bool is_over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        const bool is_left = !ImGui::IsWindowAppearing() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !is_over;
        if (is_left || ImGui::IsKeyPressed(static_cast<int>(Key::Escape), false)) desk.shows_start_page = false;
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace selvedge
