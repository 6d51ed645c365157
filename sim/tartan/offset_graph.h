#pragma once
// How far each panel's stripes must be moved so that they meet at the seams: one family of stripes at a time, as a
// wrapped least-deviations problem on the graph of panels. The cost of a seam is the sum over its samples of weight x
// |o_a -+ o_b + value|, wrapped to half a repeat. Absolute deviations, not squares: where a cycle of seams cannot
// close, one seam takes the whole error, as a tailor hides it, and the others stay exact.
//
// Within a level seams are joined in the order given (a spanning tree, exact along it); then single panels and the
// parts that were joined are moved in turn, each to the exact minimum of the seams about it, until nothing gets better.
// What a level has joined moves as one piece in the next: an earlier level is never made worse by a later one.
#include <optional>
#include <vector>

#include "sim/tartan/sett.h"

namespace selvedge::sim {

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

// The exact minimum of a sum of wrapped absolute values: where to move one panel, with the others held. Between its
// kinks such a sum is straight, and it is lowest where one of its parts is zero.

// value wrapped to half a repeat, with its sign: in [-repeat/2, repeat/2].
double wrapped(double value, double repeat);

struct ShiftTerm {
    double value = 0;
    double weight = 0;  // 0 or more
    int factor = 1;     // +-1 or +-2
};

// The shift d, |d| <= repeat/2, that makes the sum of weight * |wrapped(factor * d + value)| smallest: 0 if nothing is
// better, and else of equal ones the one nearest to 0. n terms take n log n.
double best_shift(const std::vector<ShiftTerm>& terms, double repeat);

// Where the stripes of a sett come again, and where they mirror: what matching needs to know of the colours. Both are
// read off the colours themselves, for a sett may be written longer than it is, and be its own mirror image without a
// pivot in its threadcount (K8 W8).

struct StripeRepeat {
    double size = 0;               // m, the shortest; 0: one colour only, nothing to match
    std::optional<double> mirror;  // m from the first thread; it mirrors half a repeat further too. None: never
};

StripeRepeat warp_repeat(const Sett& sett);  // of the colours along the weft
StripeRepeat weft_repeat(const Sett& sett);  // of the colours along the warp

}  // namespace selvedge::sim
