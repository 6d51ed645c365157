#pragma once
// Adds, removes and edits seams. An edge belongs to at most one seam; to sew a part of an edge, the edge is split
// first.
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

// Sews two whole edges. Returns the index of the new seam. Throws GeometryError if one is sewn already, if both are the
// same edge, or if one is over four times as long as the other.
int sew_edges(sim::Pattern& pattern, const sim::Seam& seam);

// Sews a run of consecutive spans to another run (1:N sewing). Points of the two runs match by the fraction of the
// run's length. Edges are split where a run begins or ends and where a joint of the other run falls. `is_reversed`: the
// start of the first run meets the end of the second. Joints closer than 0.1 mm are merged. Returns the indices of the
// new seams, in the order of the first run; several are one sewing (sewing.h).
std::vector<int> sew_runs(sim::Pattern& pattern, const std::vector<EdgeSpan>& first,
                          const std::vector<EdgeSpan>& second, bool is_reversed);

void remove_seams(sim::Pattern& pattern, std::vector<int> seams);

// m, lengths of the first and the second side.
std::array<double, 2> seam_lengths(const sim::Pattern& pattern, const sim::Seam& seam);
inline constexpr double kUnevenSeam = 0.001;  // m, sides are uneven if their lengths differ by more

// Makes the second side of the seam's sewing (sewing.h) as long as the first by scaling it. The fixed point is an end
// that both sides share (a dart's apex); else the end whose neighbour edge is sewn, if only one is; else the middle of
// the chord. Clears is_eased. Throws GeometryError if both ends are shared, or if the second side is not one row of
// edges.
void equalize_seam(sim::Pattern& pattern, int seam);

// Whether the straight lines between the paired ends of the seam cross; then is_reversed is probably wrong. Tested in
// 3D if both panels are placed, else on the sheet.
bool is_crossed(const sim::Pattern& pattern, const sim::Seam& seam);

}  // namespace selvedge::editor
