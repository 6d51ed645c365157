#pragma once
// What a person made of a pattern, from which the rest is derived. evaluate() is the only way from sources to panels;
// an edit of what it gives is carried back to the sources. The pair is a lens (Foster et al. 2007, "Combinators for
// bidirectional tree transformations"): evaluate() gets, and update_links() (editor/geometry/linked_panels.h) with
// sources_of() puts.
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/pattern/field.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

enum class Derivation {
    Mirror,  // the mirror image of a panel, placed on the other side of the body (Panel::mirror_of)
    Copy     // a copy of a panel, with a placement of its own (Panel::copy_of)
};

struct Link {
    Derivation kind = Derivation::Mirror;
    std::string source;  // name of the panel that it is derived from
};

// How a panel is derived. None: it is drawn.
std::optional<Link> link_of(const Panel& panel);

// Whether a panel is derived, or has linked halves (sim/pattern/halves.h).
bool has_links(const Pattern& pattern);

// The link of the panel to its source, or else to the first that is derived from it, by the name of the other panel.
std::optional<Link> link_with(const Pattern& pattern, const Panel& panel);

// The panels' indices by their names; of those of one name the first.
std::map<std::string, std::size_t> index_by_name(const std::vector<Panel>& panels);

// Whether a field of a derived panel is its own: names, the position on the sheet and where it lies on the cloth, of a
// copy also its placement on the body.
constexpr bool is_own_field(const auto& field, Derivation kind) {
    return field.descent == Descent::Own || field.placing == Placing::OnCloth ||
           (kind == Derivation::Copy && (field.placing == Placing::OnBody || field.placing == Placing::Layer));
}

struct SourceSide {
    std::string panel;
    EdgeKey edge;

    bool operator==(const SourceSide&) const = default;
};

// A seam, and what it has besides its sides: the sides of `properties` say nothing. Of a seam within a derived panel or
// within the image of a half, which is derived itself, it has only names.
struct SourceSeam {
    SourceSide first;
    SourceSide second;
    Seam properties;

    bool operator==(const SourceSeam&) const = default;
};

struct Sources {
    // In the order of the pattern's. Of a derived one its own fields (is_own_field), and its edges' ends and keys where
    // they are numbered otherwise than its source gives. Of one with linked halves the half that was drawn, with the
    // fold as an edge (sim/pattern/halves.h).
    std::vector<Panel> panels;
    std::vector<SourceSeam> seams;
    Pattern rest;  // without panels and seams

    bool operator==(const Sources&) const = default;
};

// Deterministic. All edges of the pattern have keys. Throws InputError if a panel is derived from one that is not there
// or, over others, from itself, or if a seam has an edge that is not there.
Pattern evaluate(const Sources& sources);

// Splits a pattern: evaluate(sources_of(p)) == p for a pattern that evaluate() gave and in which linked panels were
// kept alike. Otherwise derived panels become what their sources give, which end_broken_links() prevents. Throws
// InputError as evaluate().
Sources sources_of(const Pattern& pattern);

struct EndedLink {
    std::string panel;    // its name
    std::string problem;  // message for the user

    bool operator==(const EndedLink&) const = default;
};

// Ends the links of panels that are not what their sources give, to within the rounding of a file, for example because
// another program changed one of them: each keeps what it has. A mirror image may be placed otherwise. Likewise of the
// halves of a panel that are not mirror images.
std::vector<EndedLink> end_broken_links(Pattern& pattern);

// The panel's reflection in the plane x = 0 of the world, with all its fields. Vertices keep their indices, and edges
// change them as in mapped_panel().
Panel mirror_image(const Panel& panel);

// What a panel derived so looks like, with the own fields that `own` has, and its numbering of vertices and edges if it
// has the same edges by their keys.
Panel derived_panel(const Panel& source, Derivation kind, const Panel& own);

// The source that gives this panel, with the own fields that `own`, the source as it was, has.
Panel source_of_derived(const Panel& derived, Derivation kind, const Panel& own);

// Seams within a panel, with its index.
std::vector<int> darts_of(const Pattern& pattern, int panel);

}  // namespace selvedge::sim
