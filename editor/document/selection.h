#pragma once
// What is selected: the same in all views. Panels by name, so that a selection outlives changes of the pattern.
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// A part of a panel by its index: vertex, edge, internal line or notch.
struct PartRef {
    std::string panel;
    int index = 0;

    auto operator<=>(const PartRef&) const = default;
};

struct Selection {
    std::set<std::string> panels;
    std::set<PartRef> vertices;
    std::set<PartRef> edges;
    std::set<PartRef> internal_lines;
    std::set<PartRef> notches;
    std::set<int> seams;  // indices into Pattern::seams

    bool is_empty() const {
        return panels.empty() && vertices.empty() && edges.empty() && internal_lines.empty() && notches.empty() &&
               seams.empty();
    }
    bool operator==(const Selection&) const = default;
};

// What the cursor is over: one thing, shown by the sheet and by the 3D view alike.

struct Hover {
    std::optional<PartRef> vertex{};
    std::optional<PartRef> edge{};
    std::optional<PartRef> notch{};
    std::optional<PartRef> internal_line{};
    std::string panel{};        // of all of these, or alone; empty: nothing is under the cursor
    std::optional<int> seam{};  // index into Pattern::seams: that of the edge

    bool operator==(const Hover&) const = default;
};

// A selection without what is not there.

Selection clean_selection(Selection selection, const sim::Pattern& pattern);

}  // namespace selvedge::editor
