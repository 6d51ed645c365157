#pragma once
// A closed polyline as a binary tree of boxes over runs of its segments, so that a question about one point need not go
// through all of them. The answers are those of going through all of them, to the last bit.
#include <cstddef>
#include <span>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

class OutlineTree {
 public:
    // heights: one per point, for lowest(). Pre: the outline is not empty; it stays valid.
    OutlineTree(std::span<const Vec2d> outline, std::vector<double> heights);

    // As is_inside() (sim/pattern/outline.h).
    bool is_inside(const Vec2d& point) const;

    // Whether distance_to_outline() (sim/pattern/segment_distance.h) is less than `distance`, m.
    bool is_closer(const Vec2d& point, double distance) const;

    // The least of `most` and, over the outline's points, of their height + slope * their distance from `point`.
    // Pre: slope >= 0.
    double lowest(const Vec2d& point, double slope, double most) const;

    std::span<const double> heights() const { return heights_; }

 private:
    // The first child of a node follows it; the second one is the `next` of the first.
    struct Node {
        Eigen::AlignedBox2d box;  // of the segments, with both ends
        std::size_t first = 0;    // segment; segment i runs from point i to point i + 1
        std::size_t end = 0;      // the segment after the last one
        std::size_t next = 0;     // the node after this one and all below it
        double lowest = 0;        // of the heights at the segments' starts
    };

    void add_node(std::size_t first, std::size_t end);
    bool is_leaf(std::size_t node) const { return nodes_[node].next == node + 1; }
    const Vec2d& end_of(std::size_t segment) const { return outline_[(segment + 1) % outline_.size()]; }
    double distance_from(const Node& node, const Vec2d& point) const;
    void lower(std::size_t node, const Vec2d& point, double slope, double& lowest) const;

    std::span<const Vec2d> outline_;
    std::vector<double> heights_;
    std::vector<Node> nodes_;
    double rounding_ = 0;  // m, more than the error of what is computed from the coordinates
};

}  // namespace selvedge::sim
