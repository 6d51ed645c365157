#pragma once
// What the painters of the sheet are told about one frame.
#include <set>
#include <string>

#include "editor/document/document.h"
#include "editor/document/hover.h"
#include "editor/frame/frame_output.h"
#include "editor/sheet/panel_faces.h"
#include "editor/sheet/sheet_pen.h"
#include "editor/tools/tool_overlay.h"

namespace selvedge {

// What a person may switch off.
struct SheetShows {
    bool cloth = true;  // tartans; else plain
    bool names = true;  // and grainlines
    bool seams = true;
    bool grid = true;
};

// A sett as a texture of one repeat.
struct SettTexture {
    UiTexture texture = 0;           // 0: none is shown
    Vec2d repeat = Vec2d(1, 1);      // m, of the warp's stripes and of the weft's
    Vec2d position = Vec2d::Zero();  // m, where it begins under all panels
};

struct SheetLook {
    const SheetPen& pen;
    const Pattern& pattern;
    const SheetGeometry& geometry;
    PanelFaces& faces;
    const Selection& selection;
    const Hover& hover;
    const ToolOverlay& overlay;
    const std::set<std::string>& touched;  // panels that have any part selected
    SettTexture sett;
    SheetShows shows;
};

bool is_in_view(const SheetLook& look, const PanelShape& shape);

}  // namespace selvedge
