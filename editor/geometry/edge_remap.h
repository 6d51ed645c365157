#pragma once
// Keeps seams, notches and pins consistent when the edges of an outline are split, joined or renumbered. These
// functions do not check the result; edit_pattern (draft.h) does. For the sources of this module.
#include <functional>
#include <optional>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// The new index of an edge. is_turned: the edge is reversed there.
struct EdgeImage {
    sim::SeamSide side;
    bool is_turned = false;
};

// Updates the panel's seams to the new indices of their edges. Removes the seams of edges without an image.
void remap_edges(sim::Pattern& pattern, int panel, const std::function<std::optional<EdgeImage>(int)>& image_of);

// Splits an edge only; its seam stays with the first part. Returns the index of the new vertex, the panel's last.
int split_alone(sim::Pattern& pattern, const sim::SeamSide& at, double t);

// Splits an edge and, if it is sewn, the other side of its seam at the point that meets t. The seam stays with the
// first part of edge `at`; a new, unnamed seam joins the second part and is appended to the pattern. Returns the new
// vertex of panel at.panel.
int split_sewn(sim::Pattern& pattern, const sim::SeamSide& at, double t);

// Call after side `own` of a seam was split and the seam stayed with the first part. Splits the other side at the point
// that meets the fraction t of the whole and sews its rest to the edge that starts at `rest`, a vertex of own's panel.
void share_seam(sim::Pattern& pattern, const sim::SeamSide& own, int rest, double t);

// The edge that starts at a vertex; edge_count(panel) if there is none.
int edge_from(const sim::Panel& panel, int vertex);

// Joins `count` consecutive edges, from edge `first` on, to one edge. The vertices between them stay in the vertex
// list. Pre: none of the edges but the first is sewn (the caller removes those seams).
void join_alone(sim::Pattern& pattern, int panel, int first, int count);

// As join_alone, with seams. If all the edges are sewn to a run of consecutive edges in matching order, and `may_join`
// returns true for the inner vertices of that run, the run is joined too and one seam remains. Otherwise the seams of
// the edges are removed.
void join_sewn(sim::Pattern& pattern, int panel, int first, int count,
               const std::function<bool(int panel, int vertex)>& may_join);

// Removes vertices from the vertex list and renumbers the rest. Pre: no edge uses them.
void drop_vertices(sim::Panel& panel, const std::vector<int>& vertices);

// Removes those candidates that no edge uses.
void drop_unused(sim::Panel& panel, std::vector<int> candidates);

// Whether the outline has no corner at this vertex and the vertex is not pinned.
bool is_smooth(const sim::Panel& panel, int vertex);

// Removes panels and their seams from the pattern, and ends their mirror links.
void drop_panels(sim::Pattern& pattern, const std::vector<int>& panels);

// Ends the links of the panel: its own, those of the panels that are derived from it, and that of its halves.
void unlink(sim::Pattern& pattern, int panel);

}  // namespace selvedge::editor
