#pragma once
// Grade rule tables (.rul) of ANSI/AAMA-292 and ASTM D6673: how far each numbered point of a pattern moves from the
// sample size to another.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

struct GradeRules {
    std::string sample_size = {};
    std::vector<std::string> sizes = {};           // in the order of the table
    double metres_per_unit = 0.001;                // of the moves
    std::map<int, std::vector<Vec2d>> moves = {};  // by the number of the rule, one per size, units of the table
};

// Throws InputError that names the line: for a table without sizes, a sample size that is none of them, a rule with
// more or fewer moves than sizes, and more than 100,000 rules.
GradeRules parse_grade_rules(std::string_view text, const std::string& file);

// Moves points of a line: those of `moves` (by their index) by their own, the others in proportion to their distance
// along the line from the two beside them. Pre: `moves` is not empty.
void grade_line(std::vector<Vec2d>& points, const std::map<std::size_t, Vec2d>& moves, bool is_closed);

}  // namespace selvedge::sim
