#include "editor/tools/tool_table.h"

#include <algorithm>
#include <array>

#include "editor/tools/draw_tools.h"
#include "editor/tools/outline_tools.h"
#include "editor/tools/panel_tools.h"
#include "editor/tools/select_tool.h"
#include "editor/tools/sewing_tools.h"
#include "sim/core/assert.h"

namespace selvedge::editor {
namespace {

const std::vector<ToolInfo> kTools{
    {.id = "select",
     .title = "Select and move",
     .what = "Select panels, edges and points; drag to move them",
     .make = make<SelectTool>,
     .icon = "M4 2 L4 13 L7 10 L9 14 L11 13 L9 9 L13 9 Z",
     .group = ToolGroup::Select,
     .key = key_of('V'),
     .other_key = key_of('A'),
     .is_drawing = false},
    {.id = "edit_point",
     .title = "Edit point",
     .what = "Move points and curve handles",
     .make = make<EditPointTool>,
     .icon = "M2 13 L8 4 L14 11 D8 4 2 C2 13 1.5 C14 11 1.5",
     .group = ToolGroup::Select,
     .key = key_of('Z'),
     .is_drawing = false,
     .picks_parts = true},
    {.id = "rotate",
     .title = "Rotate",
     .what = "Turn what is selected",
     .make = make<TransformTool, TransformMode::Rotate>,
     .icon = "M12.5 5 L13 8 L11.5 11 L8.5 13 L5 12 L3 9.5 L3 6.5 L5 4 L8 3 L10.5 3.5 M10.5 1 L10.8 3.8 L8 4.8",
     .group = ToolGroup::Select,
     .key = key_of('R'),
     .is_drawing = false},
    {.id = "scale",
     .title = "Scale",
     .what = "Scale what is selected",
     .make = make<TransformTool, TransformMode::Scale>,
     .icon = "M2 7 L9 7 L9 14 L2 14 Z M7 9 L14 2 M10 2 L14 2 L14 6",
     .group = ToolGroup::Select,
     .key = key_of('T'),
     .is_drawing = false},
    {.id = "polygon",
     .title = "Polygon",
     .what = "Draw a panel point by point",
     .make = make<PolygonTool>,
     .icon = "M3 12 L5 3 L13 5 L12 13 Z D3 12 1.3 D5 3 1.3 D13 5 1.3 D12 13 1.3",
     .group = ToolGroup::Draw,
     .key = key_of('H')},
    {.id = "rectangle",
     .title = "Rectangle",
     .what = "Draw a rectangular panel",
     .make = make<BoxTool, BoxShape::Rectangle>,
     .icon = "M2 4 L14 4 L14 12 L2 12 Z",
     .group = ToolGroup::Draw,
     .key = key_of('S')},
    {.id = "ellipse",
     .title = "Ellipse",
     .what = "Draw a round panel",
     .make = make<BoxTool, BoxShape::Ellipse>,
     .icon = "C8 8 5.5",
     .group = ToolGroup::Draw,
     .key = key_of('E')},
    {.id = "internal_line",
     .title = "Internal line",
     .what = "Draw a line inside a panel",
     .make = make<InternalLineTool>,
     .icon = "M3 2 L13 2 L13 14 L3 14 Z M6 4 L6 6 M6 7.5 L6 9.5 M6 11 L6 12.5",
     .group = ToolGroup::Mark,
     .key = key_of('G')},
    {.id = "notch",
     .title = "Notch",
     .what = "Click an edge to mark it",
     .make = make<NotchTool>,
     .icon = "M2 5 L14 5 M8 5 L8 11 M6 8.5 L8 11 L10 8.5",
     .group = ToolGroup::Mark,
     .key = key_of('K')},
    {.id = "measure",
     .title = "Measure",
     .what = "Measure distances, angles and lengths along edges",
     .make = make<MeasureTool>,
     .icon = "M2 11 L11 2 L14 5 L5 14 Z M5 8 L6.5 9.5 M7.5 5.5 L9 7",
     .group = ToolGroup::Mark,
     .key = key_of('Q'),
     .takes_numbers = false},
    {.id = "add_point",
     .title = "Add point",
     .what = "Click an edge to put a point there",
     .make = make<AddPointTool>,
     .icon = "M2 12 L14 12 D8 12 2 M8 2 L8 7 M5.5 4.5 L10.5 4.5",
     .group = ToolGroup::Shape,
     .key = key_of('X'),
     .picks_parts = true},
    {.id = "curve_point",
     .title = "Curve",
     .what = "Drag an edge to bend it",
     .make = make<CurveTool>,
     .icon = "M2 13 L3 9.5 L5 6.5 L8 5 L11 6.5 L13 9.5 L14 13 D8 5 2",
     .group = ToolGroup::Shape,
     .key = key_of('C'),
     .picks_parts = true,
     .takes_numbers = false},
    {.id = "dart",
     .title = "Dart",
     .what = "Drag from an edge into the panel to take in a dart",
     .make = make<DartTool>,
     .icon = "M2 3 L6 3 L8 13 L10 3 L14 3",
     .group = ToolGroup::Shape,
     .key = key_of('D')},
    {.id = "mirror",
     .title = "Mirror",
     .what = "Mirror the selected panels over a line",
     .make = make<MirrorTool>,
     .icon = "M8 1 L8 15 M6 4 L2 12 L6 12 Z M10 4 L14 12 L10 12 Z",
     .group = ToolGroup::Shape,
     .key = key_of('I')},
    {.id = "cut",
     .title = "Cut",
     .what = "Draw a line across a panel to cut it in two",
     .make = make<CutTool>,
     .icon = "M3 3 L11 12 M13 3 L5 12 C3.8 13.2 1.6 C12.2 13.2 1.6",
     .group = ToolGroup::Shape,
     .key = key_of('U')},
    {.id = "merge",
     .title = "Merge",
     .what = "Click a seam to make its two panels one",
     .make = make<MergeTool>,
     .icon = "M2 3 L7 3 L7 13 L2 13 M14 3 L9 3 L9 13 L14 13 M4 8 L12 8",
     .group = ToolGroup::Shape,
     .key = key_of('J'),
     .takes_numbers = false},
    {.id = "unfold",
     .title = "Unfold",
     .what = "Click a straight edge to open the panel over it",
     .make = make<UnfoldTool>,
     .icon = "M8 2 L8 14 M8 4 L3 5 L3 13 L8 12 M8 4 L13 5 L13 13 L8 12",
     .group = ToolGroup::Shape,
     .key = key_of('O'),
     .picks_parts = true,
     .takes_numbers = false},
    {.id = "segment_sewing",
     .title = "Sew edges",
     .what = "Click one edge, then the other",
     .make = make<SewingTool>,
     .icon = "M2 3 L14 3 M2 13 L14 13 M4 3 L4 13 M8 3 L8 13 M12 3 L12 13",
     .group = ToolGroup::Sew,
     .key = key_of('N'),
     .picks_parts = true,
     .takes_numbers = false},
    {.id = "free_sewing",
     .title = "Sew freely",
     .what = "Sew parts of edges, one to many",
     .make = make<FreeSewingTool>,
     .icon = "M2 3 L5 4 L10 2 L14 3 M2 13 L7 12 L14 13 M5 4 L4 12.6 M10 2 L11 12.5",
     .group = ToolGroup::Sew,
     .key = key_of('M'),
     .takes_numbers = false},
};

// Tools whose keys differ in Marvelous Designer's map.
struct OtherKeys {
    std::string_view id;
    std::array<Key, 2> keys;
};

constexpr std::array kMarvelousDesigner{
    OtherKeys{"select", {key_of('A'), key_of('Q')}},         // Transform Pattern; Select/Move of the 3D window
    OtherKeys{"edit_point", {key_of('Z'), key_of('V')}},     // Edit Pattern; Edit Curve Point
    OtherKeys{"internal_line", {key_of('G'), key_of('I')}},  // Internal Polygon/Line
    OtherKeys{"measure", {key_of('Y'), Key::None}},          // its own key selects there
    OtherKeys{"mirror", {Key::None, Key::None}}};            // its own key draws there

}  // namespace

std::string_view title_of(ToolGroup group) {
    switch (group) {
        case ToolGroup::Select:
            return "Select";
        case ToolGroup::Draw:
            return "Draw";
        case ToolGroup::Mark:
            return "Mark";
        case ToolGroup::Shape:
            return "Shape";
        case ToolGroup::Sew:
            return "Sew";
    }
    return {};
}

const std::vector<ToolInfo>& all_tools() {
    return kTools;
}

const ToolInfo& default_tool() {
    return kTools.front();
}

const ToolInfo& info_of(std::string_view id) {
    const auto found = std::ranges::find(kTools, id, &ToolInfo::id);
    SELVEDGE_ASSERT(found != kTools.end());
    return *found;
}

std::array<Key, 2> keys_of(const ToolInfo& tool, KeyMap map) {
    if (map == KeyMap::MarvelousDesigner) {
        const auto found = std::ranges::find(kMarvelousDesigner, tool.id, &OtherKeys::id);
        if (found != kMarvelousDesigner.end()) return found->keys;
    }
    return {tool.key, tool.other_key};
}

const ToolInfo* tool_of_key(Key key, KeyMap map) {
    if (key == Key::None) return nullptr;
    const auto has_key = [&](const ToolInfo& tool) { return std::ranges::count(keys_of(tool, map), key) > 0; };
    const auto found = std::ranges::find_if(kTools, has_key);
    return found == kTools.end() ? nullptr : &*found;
}

}  // namespace selvedge::editor
