#pragma once
// Reads DXF as pattern programs write it, one block per piece: AAMA (ANSI/AAMA-292) and ASTM D6673, from R10 to R2018.
// Their layers: 1 boundary and system text, 2 turn points, 3 curve points, 4 notches, 6 mirror line, 7 grain, 8
// internal lines, 11 internal cutout, 13 drill holes, 14 sewing line, 15 annotation, 80 to 83 T, castle, check and U
// notches, 84 to 87 quality check curves.
//
// Programs that have no layer 14 draw the sewing line on 8, as a closed line inside of the boundary or equal to it.
#include <string>
#include <string_view>

#include "sim/paper/drawing.h"
#include "sim/paper/grade_rules.h"

namespace selvedge::sim {

// Polylines become lines and cubic Bezier curves between their corners. Throws InputError that names the line of what
// is wrong, and for a file beyond the limits of parse_dxf() or with more than 2 million entities or 2 million vertices.
// rules: of the table beside the file, which makes the other sizes of its pieces; null: there is none.
Drawing read_dxf(std::string_view text, const std::string& file, const GradeRules* rules = nullptr);

}  // namespace selvedge::sim
