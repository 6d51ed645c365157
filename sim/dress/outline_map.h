#pragma once
// From a place in a panel to the like place in another with the same edges: points of the outline go to points of the
// same edges at the same share of their length, what is inside follows by mean value coordinates.
// (Floater 2003; Hormann and Floater 2006)
#include <vector>

#include "sim/core/vec.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

class OutlineMap {
 public:
    // Pre: as many edges in both, each with a length.
    OutlineMap(const Panel& from, const Panel& to);

    // Equal panels leave every point as it is. What lies outside of a hollow outline may come out anywhere near it.
    Vec2d operator()(const Vec2d& u) const;

 private:
    bool is_identity_ = false;
    std::vector<Vec2d> from_;
    std::vector<Vec2d> to_;
};

}  // namespace selvedge
