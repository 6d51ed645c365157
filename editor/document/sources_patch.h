#pragma once
// The difference between two states of a document's sources, for the undo history: what a person changed, never what
// follows from it. Its size grows with the size of the change.
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {

struct SourcesPatch {
    // The range of panels that differ, from index first_panel on. The panels before and after the range are equal in
    // both states.
    std::size_t first_panel = 0;
    std::vector<sim::Panel> panels_before;
    std::vector<sim::Panel> panels_after;
    // In the same way of seams.
    std::size_t first_seam = 0;
    std::vector<sim::SourceSeam> seams_before;
    std::vector<sim::SourceSeam> seams_after;
    std::optional<std::pair<sim::Pattern, sim::Pattern>> rest;  // before, after

    bool is_empty() const {
        return panels_before.empty() && panels_after.empty() && seams_before.empty() && seams_after.empty() && !rest;
    }
};

SourcesPatch difference(const sim::Sources& before, const sim::Sources& after);

// Pre: the sources equal the patch's `before` state for apply, its `after` state for undo.
void apply(sim::Sources& sources, const SourcesPatch& patch);
void undo(sim::Sources& sources, const SourcesPatch& patch);

}  // namespace selvedge::editor
