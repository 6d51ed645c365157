#pragma once
// Reads a GarmentCode specification into a Pattern and collects all faults. Loading and `check` share this code, so
// that loading rejects exactly the files for which `check` reports an error.  (patterns/FORMAT.md)
#include <string>
#include <vector>

#include "sim/core/json.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct PatternReading {
    Pattern pattern;                  // complete only if no fault is an error
    std::vector<Fault> faults;        // in the order in which they were found
    std::vector<bool> is_sound;       // per panel: it was read without an error
    std::vector<std::string> places;  // per panel: its JSON path
    std::vector<int> seam_indices;    // per seam of the pattern: its index in the file
};

// Reads the pattern and records faults in the JSON. Does not check shapes: see check_shapes().
PatternReading read_pattern(const Json& root, const std::string& file);

// Adds faults of the shapes of outlines and seams: edges of zero length, crossings, seams with sides of unequal length.
// units: file units per metre, for coordinates in messages.
void check_shapes(PatternReading& reading, const std::string& file, double units);

// File units per metre: properties.units_in_meter; 100 if it is missing or not between 0.001 and 1e6.
double units_in_meter(const Json& root);

// The rotation Rz Ry Rx of angles in degrees about x, y and z, composed as in GarmentCode.
Eigen::Matrix3d rotation_from_degrees(const Vec3d& angles_deg);

// Reads the vertices and edges of one panel, in the file's orientation, and records faults.
// is_relative: control points are given relative to their edge (fractions of its length along and across it).
void read_outline(FaultReader& reader, const JsonNode& panel_node, bool is_relative, Panel& panel);

// Converts the panel to the panel frame (sim/pattern/pattern.h): mirrors x if the outline is clockwise. Records an
// error if the outline encloses no area. Pre: the outline was read without an error.
void convert_to_panel_frame(FaultReader& reader, const JsonNode& panel_node, Panel& panel);

}  // namespace selvedge::sim
