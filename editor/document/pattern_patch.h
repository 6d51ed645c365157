#pragma once
// The difference between two states of a pattern, small where the change is small: what a history keeps.
#include <optional>
#include <utility>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge {

struct PatternPatch {
    // Panels by index: in `before` and `after` they have in common the first and the last ones; these lie between.
    std::size_t first_panel = 0;
    std::vector<Panel> panels_before;
    std::vector<Panel> panels_after;
    std::optional<std::pair<std::vector<Seam>, std::vector<Seam>>> seams;  // before, after
    std::optional<std::pair<Pattern, Pattern>> rest;                       // the same, without panels and seams

    bool is_empty() const { return panels_before.empty() && panels_after.empty() && !seams && !rest; }
};

PatternPatch difference(const Pattern& before, const Pattern& after);

// Pre: the pattern is what the patch was made from: `before` to apply it, `after` to undo it.
void apply(Pattern& pattern, const PatternPatch& patch);
void undo(Pattern& pattern, const PatternPatch& patch);

}  // namespace selvedge
