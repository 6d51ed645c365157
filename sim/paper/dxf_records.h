#pragma once
// What DXF files of Selvedge say beyond the standards, as comments (before, as texts on layer 15), lengths in mm. Of a
// piece, in order:
//   SELVEDGE EDGE x y LINE
//   SELVEDGE EDGE x y QUADRATIC x y
//   SELVEDGE EDGE x y CUBIC x y x y
//   SELVEDGE EDGE x y ARC radius large right      an edge of the sewing line from (x, y), and its curve
//   SELVEDGE NOTCH edge t kind count              on the sewing line
//   SELVEDGE LINE mark|fold NAME                  the next line of layer 8
//   SELVEDGE OF edge|line number phrase           a property of an edge or a line, from 0: see field_record.h
//   SELVEDGE PLACED phrase                        see placement_record.h
// Of the file:
//   SELVEDGE BODY height TEXT                     see placement_record.h; in several texts if it is long
//   SELVEDGE SEAM panel:edge panel:edge reversed|same eased|exact NAME    panels and edges from 0
//   SELVEDGE SEWING panel:edge number NAME        that the seam with this first side is a part of
//   SELVEDGE SEAMED panel:edge phrase             a property of that seam: see field_record.h
#include <optional>
#include <string>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

struct DxfRecords {
    DrawnPath outline = {};  // mm; closed if there are edges
    std::vector<Notch> notches = {};
    std::vector<InternalLine> lines = {};  // without points
    std::optional<DrawnPlacement> placement = {};
    bool is_placement_broken = false;  // a phrase of it is
};

// Takes a text of a piece that is such a record; false: it is none, or is broken.
bool read_dxf_record(const std::string& text, DxfRecords& records);

// A seam of the file; none: the text is broken. Pre: it begins with "SELVEDGE SEAM ".
std::optional<DrawnSeam> read_dxf_seam(const std::string& text);

// The sewing of the seam that has this first side; none: the text is broken. Pre: it begins with "SELVEDGE SEWING ".
struct DxfSewing {
    SeamSide side;
    std::string number;  // of the sewing in the file
    std::string name;    // may be cut short, or empty
};
std::optional<DxfSewing> read_dxf_sewing(const std::string& text);

// Gives the seam that has the text's first side the property that it tells; false: there is none, or the text is
// broken. Pre: it begins with "SELVEDGE SEAMED ".
bool read_dxf_seam_property(const std::string& text, std::vector<DrawnSeam>& seams);

// Whether the recorded outline still lies on the polyline that is drawn: another program may have changed that.
bool is_outline_on(const DrawnPath& outline, const std::vector<Vec2d>& polyline, double tolerance);

}  // namespace selvedge::sim
