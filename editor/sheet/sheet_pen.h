#pragma once
// Draws on the sheet in its own metres: widths in px of the interface, anti-aliased.
#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "editor/sheet/sheet_colours.h"
#include "editor/tools/sheet_camera.h"

namespace selvedge {

struct SheetPen {
    ImDrawList& list;
    const SheetCamera& camera;
    const SheetColours& colours;
    float ui = 1;  // px per px of the interface

    ImVec2 px(const Vec2d& sheet) const;
    float px(double interface_px) const { return static_cast<float>(interface_px) * ui; }

    // Points on the sheet.
    void line(std::span<const Vec2d> points, const Rgba8& colour, double width) const;
    void dashed(std::span<const Vec2d> points, const Rgba8& colour, double width, double dash = 6) const;
    void square(const Vec2d& at, double side, const Rgba8& inside, const Rgba8& rim) const;
    void round(const Vec2d& at, double radius, const Rgba8& inside, const Rgba8& rim) const;

    // Words on a plate about the point; px_offset: of the plate's middle. `size`: of the usual.
    void words(const Vec2d& at, const std::string& text, const Rgba8& colour, const ImVec2& px_offset = {0, 0},
               float size = 1) const;
};

ImU32 packed(const Rgba8& colour);
Rgba8 faded(Rgba8 colour, double share);  // of its alpha
Rgba8 mixed(const Rgba8& from, const Rgba8& to, double share);

// Points along a line in px, evenly spaced: for ticks.
struct LinePlace {
    ImVec2 at{0, 0};
    ImVec2 along{1, 0};  // of length 1
};
double px_length(std::span<const ImVec2> line);
LinePlace place_on(std::span<const ImVec2> line, double length);  // Pre: two points at least

// A few small ticks across the line, and a triangle near its beginning that points along it. `inward`: the side of
// the line, 1 to its left, that ticks reach to.
void draw_direction(const SheetPen& pen, std::span<const ImVec2> line, const Rgba8& colour, double inward);

}  // namespace selvedge
