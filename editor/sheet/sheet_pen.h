#pragma once
// Drawing on the sheet: positions in m on the sheet, line widths in px of the interface, anti-aliased. Also holds the
// sheet's colours and the data that its drawing functions share.
#include <imgui.h>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/frame/frame.h"
#include "editor/sheet/cloth_textures.h"
#include "editor/sheet/cut_lines.h"
#include "editor/sheet/panel_faces.h"
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/tool.h"
#include "render/image/image.h"

namespace selvedge::editor {

// The colours of the sheet.

struct SheetColours {
    render::Rgba8 paper{0xFC, 0xFB, 0xF8, 0xFF};
    render::Rgba8 fine_grid{0x9F, 0xB4, 0xBE, 0x3C};    // fades in as the spacing grows
    render::Rgba8 coarse_grid{0x8A, 0xA4, 0xB0, 0x6E};  // every fifth or tenth line
    render::Rgba8 axis{0x6F, 0x8E, 0x9C, 0xA0};         // x = 0 and y = 0
    render::Rgba8 ruler{0xF3, 0xF1, 0xEC, 0xFF};
    render::Rgba8 ruler_line{0xD5, 0xD2, 0xCB, 0xFF};
    render::Rgba8 ruler_tick{0x9A, 0x9A, 0x98, 0xFF};
    render::Rgba8 ruler_text{0x6A, 0x6C, 0x6E, 0xFF};

    render::Rgba8 ink{0x26, 0x29, 0x2E, 0xFF};          // outlines, names
    render::Rgba8 faint_ink{0x26, 0x29, 0x2E, 0x80};    // grainlines, internal lines
    render::Rgba8 locked{0x26, 0x29, 0x2E, 0x60};       // outlines of locked panels
    render::Rgba8 cut{0x26, 0x29, 0x2E, 0xD8};          // cut lines
    render::Rgba8 plain_cloth{0xEF, 0xEA, 0xDF, 0xE8};  // panels without a tartan
    render::Rgba8 under_cloth{0xFF, 0xFF, 0xFF, 0xFF};  // below a tartan
    float cloth_strength = 0.40F;                       // opacity of the tartan: ink and seams stay legible
    render::Rgba8 plate{0xFF, 0xFE, 0xFB, 0xDC};        // behind text on the sheet
    render::Rgba8 mirrored{0x7A, 0x5C, 0x9E, 0xFF};     // names of mirrored panels

    render::Rgba8 accent{0x1F, 0x6F, 0x8B, 0xFF};  // selected, or being drawn
    render::Rgba8 accent_fill{0x1F, 0x6F, 0x8B, 0x20};
    render::Rgba8 hover{0x1F, 0x6F, 0x8B, 0x78};
    render::Rgba8 handle{0xFF, 0xFF, 0xFF, 0xFF};  // inside of handles
    render::Rgba8 guide{0xC2, 0x4D, 0x8A, 0xD0};   // the snap target
    render::Rgba8 measure{0x4A, 0x4E, 0x55, 0xFF};
    render::Rgba8 warning{0xB8, 0x74, 0x10, 0xFF};  // probably not intended
    render::Rgba8 error{0xC2, 0x30, 0x28, 0xFF};    // uneven seams, errors
    render::Rgba8 pin{0xC2, 0x30, 0x28, 0xFF};
    render::Rgba8 bubble{0x26, 0x29, 0x2E, 0xEB};       // background of readouts at the cursor
    render::Rgba8 bubble_text{0xFA, 0xF9, 0xF6, 0xFF};  // text of the readouts
    render::Rgba8 bubble_problem{0xF6, 0xC4, 0x6A, 0xFF};
};

SheetColours dark_sheet_colours();

// The box of a text with its plate, px.
struct LabelBox {
    ImVec2 low{0, 0};
    ImVec2 high{0, 0};
};

struct SheetPen {
    ImDrawList& list;
    const SheetCamera& camera;
    const SheetColours& colours;
    float ui = 1;  // framebuffer px per px of the interface

    ImVec2 px(const Vec2d& sheet) const;
    float px(double interface_px) const { return static_cast<float>(interface_px) * ui; }

    // Points are in m on the sheet.
    void line(std::span<const Vec2d> points, const render::Rgba8& colour, double width) const;
    void dashed(std::span<const Vec2d> points, const render::Rgba8& colour, double width, double dash = 6) const;
    void square(const Vec2d& at, double side, const render::Rgba8& inside, const render::Rgba8& rim) const;
    void round(const Vec2d& at, double radius, const render::Rgba8& inside, const render::Rgba8& rim) const;

    // Text on a plate around the point. px_offset: offset of the plate's centre, px. `size`: relative to the normal
    // font size.
    void text(const Vec2d& at, const std::string& text, const render::Rgba8& colour, const ImVec2& px_offset = {0, 0},
              float size = 1) const;
    LabelBox text_box(const Vec2d& at, const std::string& text, const ImVec2& px_offset = {0, 0}, float size = 1) const;
};

ImU32 packed(const render::Rgba8& colour);
render::Rgba8 faded(render::Rgba8 colour, double share);  // multiplies alpha by `share`
render::Rgba8 mixed(const render::Rgba8& from, const render::Rgba8& to, double share);

// A position on a polyline in px and the unit tangent there.
struct LinePoint {
    ImVec2 at{0, 0};
    ImVec2 along{1, 0};  // unit tangent
};
double px_length(std::span<const ImVec2> line);
LinePoint place_on(std::span<const ImVec2> line, double length);  // Pre: at least two points

// Draws a few small ticks across the line, and a triangle near its start that points along it. `inward`: the side of
// the ticks, 1 for left of the line.
void draw_direction(const SheetPen& pen, std::span<const ImVec2> line, const render::Rgba8& colour, double inward);

// Data that the drawing functions of the sheet share in one frame.

// Parts that the user can hide.
struct SheetVisibility {
    bool cloth = true;  // tartans; otherwise plain
    bool names = true;  // names and grainlines
    bool seams = true;
    bool allowances = true;
    bool grid = true;
    bool lengths = false;  // of all edges; those of selected edges are always shown
};

class LabelPlaces;  // sheet_labels.h

struct SheetLook {
    const SheetPen& pen;
    const sim::Pattern& pattern;
    const SheetGeometry& geometry;
    PanelFaces& faces;
    const Selection& selection;
    const Hover& hover;
    const ToolOverlay& overlay;
    const std::set<std::string>& touched;  // panels with any selected part
    SheetVisibility shows;
    LabelPlaces& labels;
    double cloth_opacity = 1;                                         // less over photos that are traced
    std::function<ClothTexture(const sim::Panel& panel)> cloth_of{};  // unset: plain cloth
    CutLines* cut_lines = nullptr;                                    // null: none are drawn
};

// Whether any of the panel is drawn: it is not hidden, and its box meets the view.
bool is_in_view(const SheetLook& look, const PanelShape& shape);

}  // namespace selvedge::editor
