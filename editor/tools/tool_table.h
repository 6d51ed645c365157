#pragma once
// The table of the sheet's tools. A row is all that the rest of the editor knows of a tool: the toolbar, menus, keys,
// scripts and both views read it from here.
#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "editor/tools/tool.h"

namespace selvedge::editor {

// What a tool is for: the groups of the toolbar and of the menu, in their order.
enum class ToolGroup { Select, Draw, Mark, Shape, Sew };

// In the interface: "Select".
std::string_view title_of(ToolGroup group);

struct ToolInfo {
    std::string_view id;                        // in scripts: edit_point
    std::string_view title;                     // in the interface: Edit point
    std::string_view what;                      // description, one sentence
    std::unique_ptr<Tool> (*make)() = nullptr;  // the tool in its initial state
    // Drawn in a square of 16 x 16: M x y starts a line, L x y continues it, Z closes it; C x y r draws a circle,
    // D x y r a filled one. Empty: none.
    std::string_view icon;
    ToolGroup group = ToolGroup::Draw;
    Key key = Key::None;        // in the editor's own key map; None: only in menus
    Key other_key = Key::None;  // a common shortcut in other programs
    bool is_drawing = true;     // the cursor over the sheet is a cross
    bool picks_parts = false;   // a click in the 3D view also selects points and edges
    bool takes_numbers = true;  // typed ones: lengths, angles or factors
};

// For ToolInfo::make. arguments: those of T's constructor.
template <class T, auto... arguments>
std::unique_ptr<Tool> make() {
    return std::make_unique<T>(arguments...);
}

// All tools, in toolbar order: those of a group one after the other.
const std::vector<ToolInfo>& all_tools();

// The first one: Select and move.
const ToolInfo& default_tool();

// Pre: there is a tool with this id.
const ToolInfo& info_of(std::string_view id);

// The tool's keys in a key map, the one that menus show first; Key::None: fewer.
std::array<Key, 2> keys_of(const ToolInfo& tool, KeyMap map);

// Returns nullptr if no tool has this key.
const ToolInfo* tool_of_key(Key key, KeyMap map = KeyMap::Selvedge);

}  // namespace selvedge::editor
