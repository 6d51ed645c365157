#include "editor/ui/tool_bar.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "editor/frame/item.h"
#include "editor/tools/tool_table.h"
#include "editor/ui/app_state.h"
#include "editor/ui/widgets.h"

namespace selvedge::editor {
namespace {

constexpr float kCaption = 0.7F;  // font size of captions, relative to the normal one
constexpr float kGap = 1;         // px between two buttons

struct ToolGrid {
    float side = 0;     // px, side of a tool button
    float edge = 0;     // px, horizontal padding
    float between = 0;  // px, height of the line between two groups, with its caption
    int columns = 1;
    bool has_captions = true;
    bool scrolls = false;
};

int rows_of(int columns) {
    std::map<ToolGroup, int> sizes;
    for (const ToolInfo& tool : all_tools()) ++sizes[tool.group];
    int rows = 0;
    for (const auto& [group, size] : sizes) rows += (size + columns - 1) / columns;
    return rows;
}

int group_count() {
    int count = 1;
    for (std::size_t i = 1; i < all_tools().size(); ++i) {
        if (all_tools()[i].group != all_tools()[i - 1].group) ++count;
    }
    return count;
}

// Buttons shrink first, then the captions are left out; then there are two columns.
ToolGrid tool_grid(float height) {
    const float unit = ImGui::GetFontSize(), smallest = 1.8F * unit, largest = 2.2F * unit;
    ToolGrid grid{.edge = std::round(0.2F * unit)};
    for (const int columns : {1, 2}) {
        for (const bool has_captions : {true, false}) {
            grid.columns = columns;
            grid.has_captions = has_captions;
            grid.between = std::round((has_captions ? 1.1F : 0.5F) * unit);
            const auto lines = static_cast<float>(has_captions ? group_count() : group_count() - 1);
            const float room = height - unit - lines * (grid.between + kGap);
            const float side = room / static_cast<float>(rows_of(columns)) - kGap;
            grid.side = std::floor(std::clamp(side, smallest, largest));
            if (side >= smallest) return grid;
        }
    }
    grid.scrolls = true;
    return grid;
}

// The line above a group, except above the first one, and its caption.
void show_beginning(AppState& state, const ToolGrid& grid, ToolGroup group, bool is_first) {
    if (is_first && !grid.has_captions) return;
    const float width = static_cast<float>(grid.columns) * grid.side, unit = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, grid.between});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = std::floor(low.y + (grid.has_captions ? 0.15F : 0.25F) * unit) + 0.5F;
    const float inset = 0.1F * grid.side;
    if (!is_first) {
        list.AddLine({low.x + inset, line}, {low.x + width - inset, line}, ImGui::GetColorU32(ImGuiCol_Separator));
    }
    if (!grid.has_captions) return;
    const std::string title(title_of(group));
    note_widget(state.widgets, "tools." + title);
    const float size = std::round(kCaption * unit);
    const ImVec2 room = ImGui::GetFont()->CalcTextSizeA(size, 1e6F, 0, title.c_str());
    list.AddText(ImGui::GetFont(), size,
                 {std::round(low.x + (width - room.x) / 2), std::round(low.y + grid.between - room.y - 0.05F * unit)},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), title.c_str());
}

void show_tools(AppState& state, const ToolGrid& grid) {
    const ToolInfo* before = nullptr;
    int column = 0;
    for (const ToolInfo& tool : all_tools()) {
        if (before == nullptr || before->group != tool.group) {
            show_beginning(state, grid, tool.group, before == nullptr);
            column = 0;
        }
        if (column > 0) ImGui::SameLine();
        const std::string id(tool.id);
        const Action* action = find_action(state.actions, "tool." + id);
        if (action != nullptr) icon_button(state, *action, id, grid.side);
        column = (column + 1) % grid.columns;
        before = &tool;
    }
}

}  // namespace

float tool_bar_width(float height) {
    const ToolGrid grid = tool_grid(height);
    return 2 * grid.edge + static_cast<float>(grid.columns) * grid.side +
           (grid.scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
}

void show_tool_bar(AppState& state) {
    const ToolGrid grid = tool_grid(ImGui::GetWindowHeight());
    ImGui::BeginChild("##all", {0, 0}, false, grid.scrolls ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoScrollbar);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, kGap});
    show_tools(state, grid);
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace selvedge::editor
