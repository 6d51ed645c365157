#pragma once
// The outline of one panel of a GarmentCode specification: vertices, edges and their curves.  (patterns/FORMAT.md)
#include "sim/pattern/fault_reader.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// Fills vertices and edges as the file draws them, and notes what is wrong.
// `is_relative`: control points are given along and across their edge.
void read_outline(FaultReader& reader, const JsonNode& panel_node, bool is_relative, Panel& panel);

// Holds a sound outline as seen from the fabric's right side, counter-clockwise.
void hold_counter_clockwise(FaultReader& reader, const JsonNode& panel_node, Panel& panel);

}  // namespace selvedge
