#include "sim/mesh/outline_tree.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/core/assert.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLeafSegments = 4;
constexpr double kRoundingShare = 1e-12;  // of the largest coordinate: a few thousand units in the last place

}  // namespace

OutlineTree::OutlineTree(std::span<const Vec2d> outline, std::vector<double> heights)
    : outline_(outline), heights_(std::move(heights)) {
    SELVEDGE_ASSERT(!outline_.empty() && heights_.size() == outline_.size());
    nodes_.reserve(outline_.size());
    add_node(0, outline_.size());
    for (const Vec2d& p : outline_) rounding_ = std::max(rounding_, kRoundingShare * p.cwiseAbs().maxCoeff());
}

void OutlineTree::add_node(std::size_t first, std::size_t end) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({.box = {}, .first = first, .end = end, .next = 0, .lowest = heights_[first]});
    if (end - first > kLeafSegments) {
        const std::size_t middle = first + (end - first) / 2;
        add_node(first, middle);
        add_node(middle, end);
    }
    Node& node = nodes_[index];
    for (std::size_t i = first; i < end; ++i) {
        node.box.extend(outline_[i]).extend(end_of(i));
        node.lowest = std::min(node.lowest, heights_[i]);
    }
    node.next = nodes_.size();
}

bool OutlineTree::is_inside(const Vec2d& point) const {
    bool inside = false;
    for (std::size_t n = 0; n < nodes_.size();) {
        const Node& node = nodes_[n];
        const bool is_above = node.box.min().y() > point.y(), is_below = node.box.max().y() <= point.y();
        const bool is_left = node.box.max().x() < point.x() - rounding_;
        // A run that is right of the point crosses its line as often, modulo 2, as the chord between the run's ends.
        const bool is_right = node.box.min().x() > point.x() + rounding_;
        if (is_right && (outline_[node.first].y() > point.y()) != (end_of(node.end - 1).y() > point.y()))
            inside = !inside;
        if (is_above || is_below || is_left || is_right) {
            n = node.next;
            continue;
        }
        if (is_leaf(n)) {
            for (std::size_t i = node.first; i < node.end; ++i) {
                if (is_crossed_rightwards(point, outline_[i], end_of(i))) inside = !inside;
            }
        }
        ++n;
    }
    return inside;
}

// At most what is computed for any of its points and segments.
double OutlineTree::distance_from(const Node& node, const Vec2d& point) const {
    return node.box.exteriorDistance(point) - rounding_;
}

bool OutlineTree::is_closer(const Vec2d& point, double distance) const {
    for (std::size_t n = 0; n < nodes_.size();) {
        const Node& node = nodes_[n];
        if (distance_from(node, point) > distance) {
            n = node.next;
            continue;
        }
        if (is_leaf(n)) {
            for (std::size_t i = node.first; i < node.end; ++i) {
                if (distance_to_segment(point, outline_[i], end_of(i)) < distance) return true;
            }
        }
        ++n;
    }
    return false;
}

double OutlineTree::lowest(const Vec2d& point, double slope, double most) const {
    lower(0, point, slope, most);
    return most;
}

void OutlineTree::lower(std::size_t node, const Vec2d& point, double slope, double& lowest) const {
    if (is_leaf(node)) {
        for (std::size_t i = nodes_[node].first; i < nodes_[node].end; ++i)
            lowest = std::min(lowest, heights_[i] + slope * (outline_[i] - point).norm());
        return;
    }
    const auto bound = [&](std::size_t n) { return nodes_[n].lowest + slope * distance_from(nodes_[n], point); };
    std::array<std::pair<double, std::size_t>, 2> children{{{bound(node + 1), node + 1}, {0, nodes_[node + 1].next}}};
    children[1].first = bound(children[1].second);
    if (children[1] < children[0]) std::swap(children[0], children[1]);
    for (const auto& [least, child] : children) {
        if (least < lowest) lower(child, point, slope, lowest);
    }
}

}  // namespace selvedge::sim
