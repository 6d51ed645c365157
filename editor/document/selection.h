#pragma once
// What is selected: the same in all views. Panels by name, so that a selection outlives changes of the pattern.
#include <set>
#include <string>
#include <utility>

namespace selvedge {

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

}  // namespace selvedge
