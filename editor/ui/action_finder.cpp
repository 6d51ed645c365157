#include "editor/ui/action_finder.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/ui/actions.h"
#include "editor/ui/desk.h"
#include "editor/ui/widgets.h"

namespace selvedge {
namespace {

constexpr std::size_t kMostShown = 12;

bool is_pressed(Key key) {
    return ImGui::IsKeyPressed(static_cast<int>(key));
}

}  // namespace

void ActionFinder::open() {
    is_open_ = true;
    takes_focus_ = true;
    wanted_.clear();
    chosen_ = 0;
}

void ActionFinder::show(Desk& desk) {
    if (!is_open_) return;
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(34 * unit, display.x - 2 * unit);
    ImGui::SetNextWindowPos({(display.x - width) / 2, 5 * unit});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::SetNextWindowFocus();
    constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                            ImGuiWindowFlags_NoSavedSettings;
    ImGui::Begin("##find", nullptr, kFlags);
    if (takes_focus_) ImGui::SetKeyboardFocusHere();
    takes_focus_ = false;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##wanted", "What do you want to do?", &wanted_)) chosen_ = 0;
    std::vector<const Action*> found = search(desk.actions, wanted_);
    if (found.size() > kMostShown) found.resize(kMostShown);
    const int count = static_cast<int>(found.size());
    if (is_pressed(Key::Down)) ++chosen_;
    if (is_pressed(Key::Up)) --chosen_;
    chosen_ = count == 0 ? 0 : (chosen_ + count) % count;
    const Action* wants = nullptr;
    for (int i = 0; i < count; ++i) {
        const Action& action = *found[static_cast<std::size_t>(i)];
        if (action_row(desk, action, i == chosen_)) wants = &action;
    }
    if (count == 0) ImGui::TextDisabled("Nothing is called so.");
    const bool is_confirmed = is_pressed(Key::Enter) || is_pressed(Key::KeypadEnter);
    if (is_confirmed && count > 0) wants = found[static_cast<std::size_t>(chosen_)];
    if (is_pressed(Key::Escape) || wants != nullptr) is_open_ = false;
    ImGui::End();
    if (wants != nullptr && !run_action(desk, *wants)) {
        desk.workspace.messages.warn("'" + wants->title + "' cannot be done now");
    }
}

}  // namespace selvedge
