#pragma once
// The exact minimum of a sum of wrapped absolute values: where to move one panel, with the others held. Between its
// kinks such a sum is straight, and it is lowest where one of its parts is zero.
#include <vector>

namespace selvedge {

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

}  // namespace selvedge
