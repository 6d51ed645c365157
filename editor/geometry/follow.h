#pragma once
// What goes with an outline when its edges are split, joined or renumbered: seams, notches and pins. None of these
// checks the result: edit_pattern does. For the sources of this room.
#include <functional>
#include <optional>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// Where an edge went: is_turned when it runs the other way round there.
struct EdgeImage {
    sim::SeamSide side;
    bool is_turned = false;
};

// Seams at the panel go where their edges went; those of edges that went nowhere are removed.
void follow_edges(sim::Pattern& pattern, int panel, const std::function<std::optional<EdgeImage>(int)>& image_of);

// Splits an edge and nothing else: a seam there stays with its first part. The new vertex is the panel's last.
int split_alone(sim::Pattern& pattern, const sim::SeamSide& at, double t);

// Splits an edge and, if it is sewn, the other side of its seam where it meets t. The seam stays with the part at the
// start of the edge `at`; the other part's, unnamed, is the last of the pattern.
int split_sewn(sim::Pattern& pattern, const sim::SeamSide& at, double t);

// After the side `own` of a seam was split and kept its first part: splits the other side at the fraction t of the
// whole and sews what is left of it to the edge that starts at `rest`, a vertex of own's panel.
void share_seam(sim::Pattern& pattern, const sim::SeamSide& own, int rest, double t);

// The edge that starts at a vertex. Pre: one does.
int edge_from(const sim::Panel& panel, int vertex);

// Makes one edge of `count` that follow each other from edge `first` on. Their vertices between stay in the list. A
// seam stays at its first edge only; the caller removes those of the others before.
void join_alone(sim::Pattern& pattern, int panel, int first, int count);

// As join_alone. Where all of them are sewn to a run of edges that follow each other just so, and `may_join` allows it
// for the vertices of that run, the run is joined too, and one seam left; else their seams go.
void join_sewn(sim::Pattern& pattern, int panel, int first, int count,
               const std::function<bool(int panel, int vertex)>& may_join);

// Takes vertices that no edge uses any more out of the list.
void drop_vertices(sim::Panel& panel, const std::vector<int>& vertices);

void drop_unused(sim::Panel& panel, std::vector<int> candidates);

// Whether the outline goes on without a corner at a vertex that no pin holds.
bool is_smooth(const sim::Panel& panel, int vertex);

// Takes panels, and the seams at them, out of the pattern.
void drop_panels(sim::Pattern& pattern, const std::vector<int>& panels);

// Neither the panel nor those that mirror it are kept mirror images from then on.
void unlink(sim::Pattern& pattern, int panel);

}  // namespace selvedge::editor
