#pragma once
// The sizes of a DXF piece by a grade rule table. Points that grade have texts "# 12" where they lie, with the number
// of their rule.
#include <string>
#include <vector>

#include "sim/paper/dxf_entities.h"
#include "sim/paper/grade_rules.h"

namespace selvedge::sim {

// The piece in each size of the table but the sample size, in order, with "Size: ..." as a text. Lines with numbered
// points move with them; all else moves as the place of the boundary that is nearest to it. Empty: none of its points
// has a number that the table knows. metres_per_unit: of the file. Pre: outlines are joined.
std::vector<DxfPiece> graded_pieces(const DxfPiece& piece, const GradeRules& rules, double metres_per_unit);

// Gives a piece a text "Size: ..." in place of those that it has.
void set_size(DxfPiece& piece, const std::string& size);

}  // namespace selvedge::sim
