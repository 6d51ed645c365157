#pragma once
// Buckling: an edge that is shorter than its material cannot lie straight, it must curve.  (SPEC 1.3; thesis ch. 6)
//
// LengthCriterion asks the same question with the ratio the other way up, compression c = 1 - 1/r: it is meant for
// cloth that is simulated, and starts where a wrinkle pays (c = 0.05, r = 1.053). Buckling is meant for the surface
// that is drawn, whose curves bulge with r from the first percent on, and so starts at 1.02. Two classes, so that
// either can be had by its own name and thresholds; the comparison itself stands in LengthCriterion alone.
#include "sim/adaptive/criteria.h"

namespace selvedge {

struct BucklingOptions {
    float split_ratio = 1.02F;   // rest length / length; a larger ratio asks for a split
    float rejoin_ratio = 1.01F;  // 1 or more, below split_ratio
};

template <class Position>
class BucklingCriterion {
 public:
    explicit BucklingCriterion(const std::vector<Position>& x, const BucklingOptions& options = {})
        : length_(x, {.split_compression = 1.0F - 1.0F / options.split_ratio,
                      .rejoin_compression = 1.0F - 1.0F / options.rejoin_ratio}) {}

    template <class Edge>
    bool wants_split(const AdaptiveMesh& mesh, const Edge& e) const {
        return length_.wants_split(mesh, e);
    }
    bool allows_rejoin(const AdaptiveMesh& mesh, EdgeId e) const { return length_.allows_rejoin(mesh, e); }

 private:
    LengthCriterion<Position> length_;
};

}  // namespace selvedge
