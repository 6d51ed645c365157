#pragma once
// The selection, the hovered part, and the panels that are hidden or locked: shared by all views. Panels are referred
// to by name, so that a selection stays valid when the pattern changes.
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// A part of a panel (vertex, edge, internal line or notch) by its index.
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

// The panels that the user has set aside while working on others. It is no part of the pattern and is not undone.
// Hidden panels are not drawn; their cloth still drapes. Locked ones are drawn. Neither can be picked or changed in the
// views.

struct PanelStates {
    std::set<std::string> hidden;
    std::set<std::string> locked;

    bool may_be_picked(const std::string& panel) const { return !hidden.contains(panel) && !locked.contains(panel); }
    bool is_empty() const { return hidden.empty() && locked.empty(); }
    bool operator==(const PanelStates&) const = default;
};

// The part under the cursor: at most one, highlighted in the sheet and in the 3D view.

struct Hover {
    std::optional<PartRef> vertex{};
    std::optional<PartRef> edge{};
    std::optional<PartRef> notch{};
    std::optional<PartRef> internal_line{};
    std::string panel{};        // panel of the part, or the hovered panel; empty: none
    std::optional<int> seam{};  // index into Pattern::seams: seam of the edge

    bool operator==(const Hover&) const = default;
};

// The selection without parts that the pattern does not have, and with all seams of the sewings in it.

Selection clean_selection(Selection selection, const sim::Pattern& pattern);

// The selection of one state of a pattern in the next one: what is still there, by the keys of edges and by places.
Selection carried(Selection selection, const sim::Pattern& before, const sim::Pattern& after);

// The selection without the panels, parts of panels and seams of panels that cannot be picked.
Selection pickable(Selection selection, const PanelStates& states, const sim::Pattern& pattern);

// The states without panels that the pattern does not have, and with a panel's new name instead of its old one.

PanelStates clean_states(PanelStates states, const sim::Pattern& pattern);
PanelStates renamed(PanelStates states, const std::string& from, const std::string& to);

}  // namespace selvedge::editor
