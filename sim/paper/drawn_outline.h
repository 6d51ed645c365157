#pragma once
// From the lines of a drawing to the outline of a panel.
#include <optional>
#include <vector>

#include "sim/paper/drawing.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The outline of a closed path, m, counter-clockwise, without edges that are too short; what is drawn as many lines is
// made curves again. Fewer than two edges: it encloses nothing.
Panel outline_of(const DrawnPath& drawn);

// Leaves out edges below kShortestEdge; the next edge starts where the removed one did.
void drop_short_edges(Panel& panel);

void drop_unused_vertices(Panel& panel);

// The closed outline that open lines of a part make together, each beginning or ending where another ends; as large as
// the part. gap: what their ends may lie apart, file units. None: they make none.
struct JoinedOutline {
    DrawnPath outline;
    std::vector<std::size_t> used;  // indices of the lines
};
std::optional<JoinedOutline> joined_outline(const std::vector<DrawnPath>& paths, double gap);

}  // namespace selvedge::sim
