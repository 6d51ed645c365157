#pragma once
// What the mouse is over: one view sets it, all light it up.
#include <optional>
#include <string>

#include "editor/document/selection.h"

namespace selvedge {

struct Hover {
    std::string panel{};  // empty: none
    std::optional<PartRef> vertex{};
    std::optional<PartRef> edge{};
    std::optional<int> seam{};

    bool operator==(const Hover&) const = default;
};

}  // namespace selvedge
