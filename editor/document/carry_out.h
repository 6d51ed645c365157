#pragma once
// What each command does to a pattern. The same pattern and command give the same bits, so that a journal can be played
// again.
#include <optional>
#include <string>

#include "editor/document/command.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

struct PanelRename {
    std::string from;
    std::string to;
};

struct Outcome {
    std::optional<Selection> selection = {};  // what was made, to be selected; none: it stays as it was
    std::optional<PanelRename> rename = {};
};

// Throws DraftError; the pattern may then be half changed. Panels that mirror each other are not yet alike after it.
Outcome carry_out(Pattern& pattern, const Command& command);

}  // namespace selvedge
