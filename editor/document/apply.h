#pragma once
// Applies each command to a pattern. Deterministic: the same pattern and command give a bit-identical result, so that a
// journal can be replayed.
#include <optional>
#include <string>
#include <vector>

#include "editor/document/command.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::editor {

struct PanelRename {
    std::string from;
    std::string to;
};

struct Outcome {
    std::optional<Selection> selection = {};  // new selection; none: unchanged
    std::optional<PanelRename> rename = {};
    std::vector<std::string> notes = {};  // what it did besides, for the user
};

// Throws GeometryError; the pattern may then be partly changed. Does not update linked panels (update_links does).
Outcome apply(sim::Pattern& pattern, const Command& command);

// Prepares a garment that was read for editing: ends its broken links (sim::end_broken_links()). What is to be told of
// it: the warnings of reading it, then the links that ended.
std::vector<std::string> take_up(sim::PatternDocument& document);

}  // namespace selvedge::editor
