#pragma once
// What is drawn over the picture of the 3D view: the gizmo with its readout, outlines of where panels would stand,
// names of arrangement points, the stage that the garment is in, and which way the axes run.
#include "editor/viewport3d/viewport_controller.h"
#include "editor/viewport3d/viewport_marks.h"

struct ImDrawList;

namespace selvedge::editor {

struct OverlayPlace {
    Vec2f low_px{0, 0};  // the view's upper left in the window
    float scale = 1;     // of the interface
};

void draw_overlay(ImDrawList& list, const OverlayPlace& place, const Workspace& workspace,
                  const ViewportController& hand, const ViewportColours& colours);

// What the garment is doing, in a word or two: "Sewing 3 seams".
std::string stage_text(const sim::SessionFrame& frame);

}  // namespace selvedge::editor
