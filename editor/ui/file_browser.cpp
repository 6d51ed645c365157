// Implements FileBrowser of files.h.
#include <imgui.h>
#include <imgui_stdlib.h>
#include <algorithm>
#include <utility>

#include "editor/frame/item.h"
#include "editor/frame/keyboard.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"
#include "editor/ui/widgets.h"
#include "sim/core/error.h"

namespace selvedge::editor {
namespace {

std::string joined(const std::string& folder, const std::string& name) {
    if (name.starts_with('/')) return name;
    return folder.ends_with('/') ? folder + name : folder + "/" + name;
}

bool is_listed(const FolderEntry& entry, const std::vector<std::string>& endings) {
    return entry.is_folder || std::any_of(endings.begin(), endings.end(),
                                          [&](const std::string& ending) { return entry.name.ends_with(ending); });
}

}  // namespace

void FileBrowser::open(BrowseRequest request, const Services& services) {
    request_ = std::move(request);
    name_ = request_.name;
    is_open_ = takes_focus_ = true;
    enter(folder_, services);
}

void FileBrowser::visit_text(const std::function<void(std::string_view)>& visit) const {
    if (!is_open_) return;
    visit(listing_.folder);
    for (const FolderEntry& entry : listing_.entries) visit(entry.name);
}

// Stays in the current folder if the new one cannot be read.
void FileBrowser::enter(const std::string& folder, const Services& services) {
    try {
        listing_ = services.list_folder(folder);
        folder_ = listing_.folder;
    } catch (const sim::InputError&) {
    }
}

void FileBrowser::choose(AppState& state) {
    if (name_.empty()) return;
    is_open_ = false;
    const BrowseRequest request = request_;  // a copy: choose() may open another request
    request.choose(state, joined(folder_, name_));
}

void FileBrowser::show_entries(AppState& state) {
    if (!listing_.parent.empty() && ImGui::Selectable("..")) return enter(listing_.parent, state.services);
    for (const FolderEntry& entry : listing_.entries) {
        if (!is_listed(entry, request_.endings)) continue;
        const bool is_chosen = !entry.is_folder && entry.name == name_;
        const std::string label = entry.name + (entry.is_folder ? "/" : "");
        const bool is_pressed = ImGui::Selectable(label.c_str(), is_chosen, ImGuiSelectableFlags_AllowDoubleClick);
        note_widget(state.widgets, "browser." + entry.name);
        if (!is_pressed) continue;
        if (entry.is_folder) return enter(joined(folder_, entry.name), state.services);
        name_ = entry.name;
        if (ImGui::IsMouseDoubleClicked(0)) return choose(state);
    }
}

void FileBrowser::show(AppState& state) {
    if (!is_open_) return;
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 size{std::min(40 * unit, display.x - 2 * unit), std::min(30 * unit, display.y - 4 * unit)};
    ImGui::SetNextWindowPos({(display.x - size.x) / 2, (display.y - size.y) / 2}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    constexpr auto kFlags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;
    if (ImGui::Begin((request_.title + "###browser").c_str(), &is_open_, kFlags)) {
        const std::string shown = elided(folder_, ImGui::GetContentRegionAvail().x, Elide::Middle);
        ImGui::TextDisabled("%s", shown.c_str());
        tip_of_whole(folder_, shown);
        const int rows = request_.show_options ? 2 + request_.option_rows : 2;  // below the list
        ImGui::BeginChild("##entries", {0, -static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing()}, true);
        show_entries(state);
        ImGui::EndChild();
        if (request_.show_options) request_.show_options(state);
        if (takes_focus_) ImGui::SetKeyboardFocusHere();
        takes_focus_ = false;
        ImGui::SetNextItemWidth(-1);
        const bool is_entered =
            ImGui::InputTextWithHint("##name", "Name of the file", &name_,
                                     ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        note_widget(state.widgets, "browser.name");
        if (button(state, "browser.choose", request_.verb) || is_entered) choose(state);
        ImGui::SameLine();
        if (button(state, "browser.cancel", "Cancel")) is_open_ = false;
        const bool has_focus = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
        if (has_focus && is_key_repeated(Key::Escape)) is_open_ = false;
    }
    ImGui::End();
}

}  // namespace selvedge::editor
