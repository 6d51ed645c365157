#pragma once
// How an edit is applied: to a copy of the pattern, which replaces the original only if it passes check_edit. Also
// GeometryError, checked access by index, and validation of panels. Mostly for the sources of this module.
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// An edit that is not possible: a message in the tailor's terms and the parts involved, which the views highlight; and
// the panels as the edit would have made them, if it is their shape that is not possible.

struct PartLocation {
    std::string panel;
    int edge = -1;    // -1: none
    int vertex = -1;  // -1: none

    bool operator==(const PartLocation&) const = default;
};

class GeometryError : public std::runtime_error {
 public:
    explicit GeometryError(const std::string& text, std::vector<PartLocation> places = {})
        : std::runtime_error(text), places_(std::move(places)) {}

    const std::vector<PartLocation>& places() const { return places_; }

    // Their outlines are closed, but may cross themselves, and may reach far or have curves that are not possible.
    const std::vector<sim::Panel>& refused_panels() const { return refused_panels_; }
    void add_refused_panel(const sim::Panel& panel) { refused_panels_.push_back(panel); }

 private:
    std::vector<PartLocation> places_;
    std::vector<sim::Panel> refused_panels_;
};

inline int edge_count(const sim::Panel& panel) {
    return static_cast<int>(panel.edges.size());
}

// The edge before this one in the outline.
inline int edge_before(const sim::Panel& panel, int edge) {
    return (edge + edge_count(panel) - 1) % edge_count(panel);
}

// Checked access. Each throws GeometryError if the index is out of range.
sim::Panel& panel_of(sim::Pattern& pattern, int panel);
const sim::Panel& panel_of(const sim::Pattern& pattern, int panel);
sim::OutlineEdge& edge_of(sim::Pattern& pattern, const sim::SeamSide& side);
const sim::OutlineEdge& edge_of(const sim::Pattern& pattern, const sim::SeamSide& side);
const sim::Seam& seam_of(const sim::Pattern& pattern, int seam);
void expect_vertices(const sim::Panel& panel, const std::vector<int>& vertices);

PartLocation place_of(const sim::Pattern& pattern, const sim::SeamSide& side);

// The seam of an edge, as an index into Pattern::seams. None: the edge is not sewn.
std::optional<int> seam_at(const sim::Pattern& pattern, const sim::SeamSide& side);

// Throws GeometryError unless every panel and seam that differs from `before` can be saved and loaded again.
void check_edit(const sim::Pattern& draft, const sim::Pattern& before);
void check_panel(const sim::Panel& panel);

// Applies `edit(Pattern&)` to a copy, checks the copy and commits it. On an exception `pattern` stays unchanged.
// Returns what `edit` returns.
template <class Edit>
auto edit_pattern(sim::Pattern& pattern, Edit edit) {
    sim::Pattern draft = pattern;
    if constexpr (std::is_void_v<decltype(edit(draft))>) {
        edit(draft);
        check_edit(draft, pattern);
        std::swap(pattern, draft);
    } else {
        auto result = edit(draft);
        check_edit(draft, pattern);
        std::swap(pattern, draft);
        return result;
    }
}

}  // namespace selvedge::editor
