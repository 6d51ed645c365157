#pragma once
// How an edit is carried out: on a copy, which takes the pattern's place only when it is sound. For the sources of this
// room.
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// What cannot be done to a draft, in words a tailor understands, and where: views light the places up.

struct GeometryPlace {
    std::string panel;
    int edge = -1;    // none: -1
    int vertex = -1;  // none: -1

    bool operator==(const GeometryPlace&) const = default;
};

class GeometryError : public std::runtime_error {
 public:
    explicit GeometryError(const std::string& words, std::vector<GeometryPlace> places = {})
        : std::runtime_error(words), places_(std::move(places)) {}

    const std::vector<GeometryPlace>& places() const { return places_; }

 private:
    std::vector<GeometryPlace> places_;
};

inline std::size_t as_size(int index) {
    return static_cast<std::size_t>(index);
}

inline int edge_count(const sim::Panel& panel) {
    return static_cast<int>(panel.edges.size());
}

// Indices that come from outside. Throw GeometryError.
sim::Panel& panel_of(sim::Pattern& pattern, int panel);
const sim::Panel& panel_of(const sim::Pattern& pattern, int panel);
sim::OutlineEdge& edge_of(sim::Pattern& pattern, const sim::SeamSide& side);
const sim::OutlineEdge& edge_of(const sim::Pattern& pattern, const sim::SeamSide& side);
const sim::Seam& seam_of(const sim::Pattern& pattern, int seam);
void expect_vertices(const sim::Panel& panel, const std::vector<int>& vertices);

GeometryPlace place_of(const sim::Pattern& pattern, const sim::SeamSide& side);

// The seam at an edge, as index into Pattern::seams.
std::optional<int> seam_at(const sim::Pattern& pattern, const sim::SeamSide& side);

// Throws GeometryError unless what differs from `before` can be saved and loaded again.
void check_draft(const sim::Pattern& draft, const sim::Pattern& before);
void check_panel(const sim::Panel& panel);

// Carries out `edit(Pattern&)` wholly or not at all; gives what it gives.
template <class Edit>
auto edit_pattern(sim::Pattern& pattern, Edit edit) {
    sim::Pattern draft = pattern;
    if constexpr (std::is_void_v<decltype(edit(draft))>) {
        edit(draft);
        check_draft(draft, pattern);
        std::swap(pattern, draft);
    } else {
        auto result = edit(draft);
        check_draft(draft, pattern);
        std::swap(pattern, draft);
        return result;
    }
}

}  // namespace selvedge::editor
