#pragma once
// The 2D overlay of the 3D view: the gizmo with its readout, outlines of where panels would be placed, names of
// arrangement points, the joints of the body, the simulation stage, and the axis cross.
#include "editor/viewport3d/viewport_controller.h"
#include "editor/viewport3d/viewport_marks.h"

struct ImDrawList;

namespace selvedge::editor {

struct OverlayFrame {
    Vec2f low_px{0, 0};  // upper left corner of the view in the window
    float scale = 1;     // interface scale factor
};

void draw_overlay(ImDrawList& list, const OverlayFrame& place, const Workspace& workspace,
                  const ViewportController& controller, const ViewportColours& colours);

// The current simulation stage in a few words, for example "Sewing 3 seams"; of a garment at rest also what is wrong
// with it: "Settled, too small at the bust by 2.2 cm".
std::string stage_badge(const sim::SessionFrame& frame);

// Where the overlay draws the stage, px of the view. Size 0: it does not.
struct BadgeBox {
    Vec2f low{0, 0};
    Vec2f size{0, 0};
};
BadgeBox stage_badge_box(const Workspace& workspace, const ViewportController& controller, float scale);

}  // namespace selvedge::editor
