#pragma once
// Sewing. An edge is sewn at most once; what is only a part of an edge is split off first.
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// The part of an edge between two fractions of its length, `from` < `to`.
struct EdgeSpan {
    int panel = 0;
    int edge = 0;
    double from = 0;
    double to = 1;

    bool operator==(const EdgeSpan&) const = default;
};

// Sews two whole edges. Throws GeometryError when one is sewn already, both are the same, or one is over four times as
// long.
int sew_edges(sim::Pattern& pattern, const sim::Seam& seam);

// Sews a run of spans to another, from its start on: spans of a run follow each other. Edges are split where a run
// begins or ends and where it meets a joint of the other run, by share of their lengths: 1:N. `is_reversed`: the start
// of the first run meets the end of the second. Joints within 0.1 mm of each other are one. Returns the new seams,
// along the first run.
std::vector<int> sew_runs(sim::Pattern& pattern, const std::vector<EdgeSpan>& first,
                          const std::vector<EdgeSpan>& second, bool is_reversed);

void remove_seams(sim::Pattern& pattern, std::vector<int> seams);

// m: of first and second.
std::array<double, 2> seam_lengths(const sim::Pattern& pattern, const sim::Seam& seam);
inline constexpr double kUnevenSeam = 0.001;  // m, sides that differ by more are uneven

// Makes the second side as long as the first: it is scaled with its chord, about the end where the next edge is sewn if
// the other's is not, else about its middle; an end that both sides share, as a dart's apex, stays. It is no longer
// eased.
void even_seam(sim::Pattern& pattern, int seam);

// Whether straight lines between the ends as they are paired would cross, seen in the plane as they lie on the sheet,
// or, where both panels are placed, in the room: the seam is likely meant the other way round.
bool is_crossed(const sim::Pattern& pattern, const sim::Seam& seam);

}  // namespace selvedge::editor
