#pragma once
// Evaluates numbers as users type them: 92/4+1, (3 - 0.5) * 2, 12 1/2, 2,5.
#include <optional>
#include <string_view>

namespace selvedge::editor {

// Accepts + - * / and parentheses, decimal point or comma, blanks, and mixed numbers (12 1/2 is 12.5). Returns none for
// any other text, for a division by zero and for a result that is not finite.
std::optional<double> evaluate(std::string_view text);

}  // namespace selvedge::editor
