#pragma once
// How far each panel's stripes must be moved so that they meet at the seams: one family of stripes at a time, as a
// wrapped least-deviations problem on the graph of panels. The cost of a seam is the sum over its samples of weight x
// |o_a -+ o_b + value|, wrapped to half a repeat. Absolute deviations, not squares: where a cycle of seams cannot
// close, one seam takes the whole error, as a tailor hides it, and the others stay exact.
//
// Within a level seams are joined in the order given (a spanning tree, exact along it); then single panels and the
// parts that were joined are moved in turn, each to the exact minimum of the seams about it, until nothing gets better.
// What a level has joined moves as one piece in the next: an earlier level is never made worse by a later one.
#include <vector>

namespace selvedge {

struct OffsetSample {
    double value = 0;   // m
    double weight = 0;  // 0 or more
};

// One seam: a and b may be one node.
struct OffsetTerm {
    int a = 0;
    int b = 0;
    bool is_mirrored = false;  // o_a + o_b + value instead of o_a - o_b + value
    int level = 0;             // lower levels win, strictly
    std::vector<OffsetSample> samples;
};

struct OffsetProblem {
    int nodes = 0;
    double repeat = 0;              // m, positive
    std::vector<OffsetTerm> terms;  // within a level: in the order in which they are joined
    std::vector<int> rank;          // per node; where a joined piece may be moved freely, its node of lowest rank stays
};

// The offsets, m, one per node, near those of `start`. Same problem, same bits.
std::vector<double> solve_offsets(const OffsetProblem& problem, const std::vector<double>& start);

}  // namespace selvedge
