#pragma once
// Where the interior vertices of a panel start: on a hexagonal grid, kept off the outline, finer where the outline is
// sampled finely.  (SPEC 3.1)
#include <span>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

// The edge length wanted at each place of a panel: the outline's own spacing on the outline, growing with the
// distance from it up to the target.
class SizeField {
 public:
    // target_edge: m. Pre: outline is not empty.
    SizeField(std::span<const Vec2d> outline, double target_edge);
    double at(const Vec2d& point) const;  // m
    double smallest() const;              // m, over the outline

 private:
    std::span<const Vec2d> outline_;
    std::vector<double> spacing_;
    double target_edge_;
};

// A place and direction for the grid; several are tried and the best mesh is kept.
struct GridPose {
    double along = 0;        // shift along the rows, in edges
    double across = 0;       // shift across them, in rows
    bool is_turned = false;  // rows run along y instead of x
};

std::vector<Vec2d> place_interior_points(std::span<const Vec2d> outline, const SizeField& size, double target_edge,
                                         const GridPose& pose);

}  // namespace selvedge
