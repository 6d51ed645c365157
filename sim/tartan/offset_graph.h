#pragma once
// Solves for the stripe offsets of panels, for one family of stripes (warp or weft), so that stripes meet at the seams:
// a wrapped least-absolute-deviations problem on the graph whose nodes are panels and whose terms are seams. Also the
// exact 1D minimiser that it uses, and the period and symmetry of a sett. The cost of a seam is the sum over its
// samples of weight x |o_a -+ o_b + value|, where the difference is wrapped to half a repeat. Absolute deviations
// instead of squares: if a cycle of seams cannot close, one seam takes the whole error, as a tailor would do it, and
// the others are exact.
//
// Levels are solved in ascending order. Within a level, seams are joined in the given order, which gives a spanning
// tree that is matched along its seams. Then single panels and joined pieces are moved in turn, each to the exact
// minimum of its seams' cost, until nothing improves (at most 40 iterations). Pieces that a level has joined move as
// one in the later levels, so that a later level never worsens an earlier one.
#include <optional>
#include <vector>

#include "sim/tartan/sett.h"

namespace selvedge::sim {

struct OffsetSample {
    double value = 0;   // m
    double weight = 0;  // 0 or more
};

// One seam, between the nodes a and b, which may be equal.
struct OffsetTerm {
    int a = 0;
    int b = 0;
    bool is_mirrored = false;  // o_a + o_b + value instead of o_a - o_b + value
    int level = 0;             // lower levels have strict priority
    std::vector<OffsetSample> samples;
};

struct OffsetProblem {
    int nodes = 0;
    double repeat = 0;              // m, positive
    std::vector<OffsetTerm> terms;  // within a level: in the order of joining
    std::vector<int> rank;          // per node; of a piece that can move freely, the node of lowest rank stays
};

// Returns one offset per node, m. `start`: the initial offsets, m. Output is bit-identical for the same input.
std::vector<double> solve_offsets(const OffsetProblem& problem, const std::vector<double>& start);

// `value` modulo `repeat`, in [-repeat/2, repeat/2].
double wrapped(double value, double repeat);

// A term weight * |wrapped(factor * shift + value)| of the cost of shifting one panel.
struct ShiftTerm {
    double value = 0;
    double weight = 0;  // 0 or more
    int factor = 1;     // +-1 or +-2
};

// The exact minimiser d, |d| <= repeat/2, of the sum of weight * |wrapped(factor * d + value)|. The sum is piecewise
// linear, so that it is evaluated at its breakpoints, in O(n log n) for n terms. Returns 0 if no shift is better than
// none; otherwise, of equal minima, the one nearest to 0.
double best_shift(const std::vector<ShiftTerm>& terms, double repeat);

// The period and the mirror lines of a sett's stripes, computed from their colours, because a threadcount may contain
// several periods, and a sett without pivots can be symmetric (K8 W8).
struct StripeRepeat {
    double size = 0;               // m, shortest period; 0: a single colour, nothing to match
    std::optional<double> mirror;  // m from the first thread; another is half a repeat further. None: not symmetric
};

StripeRepeat warp_repeat(const Sett& sett);  // colours of the warp threads, along the weft
StripeRepeat weft_repeat(const Sett& sett);  // colours of the weft threads, along the warp

}  // namespace selvedge::sim
