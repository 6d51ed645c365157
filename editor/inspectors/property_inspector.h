#pragma once
// The parts of the property inspector: one for each kind of thing that can be selected.
#include "editor/inspectors/inspectors.h"

namespace selvedge::editor {

void draw_pattern_section(InspectorContext& context);
void draw_panel_section(InspectorContext& context, const std::string& name);
void draw_panels_section(InspectorContext& context);  // several

void draw_vertices_section(InspectorContext& context);
void draw_edge_section(InspectorContext& context, const PartRef& edge);
void draw_notch_section(InspectorContext& context, const PartRef& notch);
void draw_internal_line_section(InspectorContext& context, const PartRef& line);
void draw_seam_section(InspectorContext& context, int seam);

// The fabric of a panel, or with an empty name the garment's.
void fabric_row(InspectorContext& context, const std::string& panel);

// Even, accept ease, reverse, delete.
void seam_buttons(InspectorContext& context, int seam);

}  // namespace selvedge::editor
