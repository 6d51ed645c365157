#pragma once
// From the GarmentCode specification to a Pattern, and every fault on the way. Loading and checking share it: what
// `check` calls an error is what loading refuses.  (patterns/FORMAT.md)
#include <string>
#include <vector>

#include "sim/core/json.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct PatternReading {
    Pattern pattern;                  // whole only when no fault is an error
    std::vector<Fault> faults;        // in the order of the file
    std::vector<bool> is_sound;       // per panel: its outline could be read
    std::vector<std::string> places;  // per panel: its JSON path
    std::vector<int> seam_indices;    // per seam of the pattern: its index in the file
};

// Reads what the file says; what the shapes are like is check_shapes' part.
PatternReading read_pattern(const Json& root, const std::string& file);

// Adds what is wrong with outlines and seams as shapes: zero lengths, crossings, unequal seams.
// `units` per metre, for the places that it names.
void check_shapes(PatternReading& reading, const std::string& file, double units);

// How many file units make a metre: properties.units_in_meter, 100 unless given. Non-positive or absurd: nothing.
double units_in_meter(const Json& root);

// Rz Ry Rx of angles in degrees about x, y, z, as GarmentCode's readers compose them.
Eigen::Matrix3d rotation_from_degrees(const Vec3d& angles_deg);

// The outline of one panel of a GarmentCode specification: vertices, edges and their curves.  (patterns/FORMAT.md)

// Fills vertices and edges as the file draws them, and notes what is wrong.
// `is_relative`: control points are given along and across their edge.
void read_outline(FaultReader& reader, const JsonNode& panel_node, bool is_relative, Panel& panel);

// Holds a sound outline as seen from the fabric's right side, counter-clockwise.
void hold_counter_clockwise(FaultReader& reader, const JsonNode& panel_node, Panel& panel);

}  // namespace selvedge::sim
