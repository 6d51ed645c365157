#pragma once
// What several tools show alike.
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/snap.h"
#include "editor/tools/tool_overlay.h"

namespace selvedge {

void add_guides(ToolOverlay& overlay, const Snap& snapped);

// The part of an edge between two fractions of its length, in that direction, on the sheet.
std::vector<Vec2d> part_of_edge(const PanelShape& shape, int edge, double from, double to);

// A line over an edge.
void add_edge(ToolOverlay& overlay, const SheetGeometry& geometry, const PartRef& edge, OverlayTone tone);

void add_box(ToolOverlay& overlay, const SheetBox& box, OverlayTone tone);

// Edges of a panel whose handles are shown: of those that have any part selected.
std::set<PartRef> curved_edges_of(const SheetGeometry& geometry, const std::set<std::string>& panels);

}  // namespace selvedge
