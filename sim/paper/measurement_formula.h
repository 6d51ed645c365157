#pragma once
// The values of measurements that are given as formulas of others, as Valentina and Seamly2D write them:
// "(waist_circ/2)+1".
#include <map>
#include <optional>
#include <string>

namespace selvedge::sim {

using Formulas = std::map<std::string, std::string>;  // by name

// "92,5" as "92.5": programs write decimals in the manner of the user's language. Text that is no such number stays.
std::string with_decimal_point(std::string text);

// Numbers, with a point or a comma before the decimals, names, + - * / and parentheses. None if the formula is wrong,
// names what is not there, or depends on itself.
std::optional<double> value_of_formula(const Formulas& formulas, const std::string& name);

}  // namespace selvedge::sim
