#pragma once
// The keys of outline edges (EdgeKey), and what two states of a panel have in common by them. A panel that was just
// read or drawn has none; evaluate() (sim/pattern/sources.h) gives them. Where a panel has no keys, its edges count as
// numbered in their order, from 1.
#include <optional>
#include <utility>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

bool has_keys(const Panel& panel);

// Whether the keys are the edges' numbers, and no others were ever given.
bool has_plain_keys(const Panel& panel);

// The key of an edge. Pre: the panel has the edge.
EdgeKey edge_key(const Panel& panel, int edge);

// The keys of two edges that are sewn, the smaller first: by them a seam within a panel is known.
using EdgeKeyPair = std::pair<EdgeKey, EdgeKey>;
EdgeKeyPair sorted_keys(const EdgeKey& one, const EdgeKey& other);

// The same pair with both edges in this role.
EdgeKeyPair with_role(EdgeKeyPair keys, EdgeRole role);

// The edge with this key, as an index. None: there is no such edge.
std::optional<int> find_edge(const Panel& panel, const EdgeKey& key);

// A key that no edge of the panel ever had. Not given, if the panel has no keys.
EdgeKey new_key(Panel& panel);

// A key for a new part of the edge: as new_key(), but of a panel with linked halves in the half that the edge is of.
EdgeKey new_part_key(Panel& panel, const OutlineEdge& edge);

// Gives a key to each edge that has none. Of two edges with one key, the second gets another.
void give_keys(Panel& panel);

// Parts of the outlines of two states of a panel that correspond: runs of consecutive edges.
struct OutlineStretch {
    int first = 0;  // edge of the one outline
    int count = 0;
    int other_first = 0;  // edge of the other
    int other_count = 0;
};

// The outlines divided at the points that both have: where edges with the same key start. Ordered by `first`, from the
// first shared point on. Empty if no edge has the same key, or if the shared ones have another cyclic order.
std::vector<OutlineStretch> shared_stretches(const Panel& one, const Panel& other);

// Whether both have the same edges by their keys, and `other` runs round them the other way: it was mirrored. Of
// outlines with two edges it is told by the indices of their vertices.
bool is_turned_over(const Panel& one, const Panel& other);

}  // namespace selvedge::sim
