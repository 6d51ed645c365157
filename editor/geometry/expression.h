#pragma once
// Numbers as people type them: 92/4+1, (3 - 0.5) * 2, 12 1/2, 2,5.
#include <optional>
#include <string_view>

namespace selvedge::editor {

// + - * / and parentheses, decimal point or comma, blanks; a whole number and a fraction add up. None for anything
// else, for a division by zero, and for what is not finite.
std::optional<double> evaluate(std::string_view text);

}  // namespace selvedge::editor
