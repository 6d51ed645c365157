#pragma once
// What the cursor is over: one thing, shown by the sheet and by the 3D view alike.
#include <optional>
#include <string>

#include "editor/document/selection.h"

namespace selvedge {

struct Hover {
    std::optional<PartRef> vertex{};
    std::optional<PartRef> edge{};
    std::optional<PartRef> notch{};
    std::optional<PartRef> internal_line{};
    std::string panel{};        // of all of these, or alone; empty: nothing is under the cursor
    std::optional<int> seam{};  // index into Pattern::seams: that of the edge

    bool operator==(const Hover&) const = default;
};

}  // namespace selvedge
