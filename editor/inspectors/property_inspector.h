#pragma once
// The sections of the property inspector: one per kind of object that can be selected.
#include "editor/inspectors/inspectors.h"

namespace selvedge::editor {

void draw_pattern_section(InspectorContext& context);
void draw_garments_section(InspectorContext& context);       // those that are worn over each other
bool has_garments_section(const InspectorContext& context);  // several, or one that is hidden
void draw_underlays_section(InspectorContext& context);      // photos under the sheet
void draw_panel_section(InspectorContext& context, const std::string& name);
void draw_panels_section(InspectorContext& context);  // for several selected panels

void draw_vertices_section(InspectorContext& context);
void draw_edge_section(InspectorContext& context, const PartRef& edge);
void draw_notch_section(InspectorContext& context, const PartRef& notch);
void draw_internal_line_section(InspectorContext& context, const PartRef& line);
void draw_seam_section(InspectorContext& context, int seam);

// Row to choose the fabric of a panel; with an empty name, of the garment.
void fabric_row(InspectorContext& context, const std::string& panel);

// Buttons: even, accept ease, reverse, delete.
void seam_buttons(InspectorContext& context, int seam);

}  // namespace selvedge::editor
