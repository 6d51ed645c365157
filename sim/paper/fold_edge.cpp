#include "sim/paper/fold_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/paper/cut_text.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

struct Candidate {
    int edge = 0;
    double weight = 0;
    double length = 0;
};

Vec2d direction_at(const Panel& panel, const OutlineEdge& edge, double t) {
    constexpr double kStep = 1e-3;
    const double from = std::clamp(t - kStep, 0.0, 1.0), to = std::clamp(t + kStep, 0.0, 1.0);
    return (outline_point(panel, edge, to) - outline_point(panel, edge, from)).normalized();
}

// How far two directions are from a right angle, rad.
double off_right_angle(const Vec2d& a, const Vec2d& b) {
    return std::abs(std::abs(std::atan2(cross2(a, b), a.dot(b))) - std::numbers::pi / 2);
}

double extent_along(const Panel& panel, const Vec2d& along) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec2d& vertex : panel.vertices) {
        low = std::min(low, vertex.dot(along));
        high = std::max(high, vertex.dot(along));
    }
    return high - low;
}

std::optional<Candidate> candidate_of(const Panel& panel, std::size_t e) {
    constexpr double kAlong = 4 * kDegree, kSquare = 12 * kDegree;
    constexpr double kLeast = 0.4;                          // of the panel along it: the side of a bodice is less
    constexpr std::array<double, 3> kWeights{0.2, 0.6, 1};  // by the number of right angles
    const OutlineEdge& edge = panel.edges[e];
    if (edge.kind != CurveKind::Line) return std::nullopt;
    const Vec2d start = panel.vertices[as_size(edge.start)], end = panel.vertices[as_size(edge.end)];
    const Vec2d along = (end - start).normalized();
    const Vec2d grain(-std::sin(panel.grain_angle), std::cos(panel.grain_angle));
    const double length = (end - start).norm();
    if (std::abs(cross2(along, grain)) > std::sin(kAlong)) return std::nullopt;
    if (length < kLeast * extent_along(panel, along)) return std::nullopt;
    const OutlineEdge& before = panel.edges[(e + panel.edges.size() - 1) % panel.edges.size()];
    const OutlineEdge& after = panel.edges[(e + 1) % panel.edges.size()];
    std::size_t right_angles = off_right_angle(direction_at(panel, before, 1), along) < kSquare ? 1 : 0;
    right_angles += off_right_angle(along, direction_at(panel, after, 0)) < kSquare ? 1 : 0;
    if (!find_outline_crossings(unfolded(panel, static_cast<int>(e)), {.most = 1}).empty()) return std::nullopt;
    return Candidate{static_cast<int>(e), length * kWeights[right_angles], length};
}

// The candidate that a text about the fold stands beside, nearer than to any other; none: there is no such text.
std::optional<int> edge_beside_text(const Panel& panel, const std::vector<Candidate>& candidates,
                                    const std::vector<DrawnText>& texts) {
    constexpr double kBeside = 0.03;  // m
    std::optional<int> found;
    double least = kBeside;
    for (const DrawnText& text : texts) {
        if (!names_fold(text.text)) continue;
        for (const Candidate& one : candidates) {
            const OutlineEdge& edge = panel.edges[as_size(one.edge)];
            const double distance =
                distance_to_segment(text.at, panel.vertices[as_size(edge.start)], panel.vertices[as_size(edge.end)]);
            if (distance < least) least = distance, found = one.edge;
        }
    }
    return found;
}

}  // namespace

FoldEdge find_fold_edge(const Panel& panel, const std::vector<DrawnText>& texts) {
    constexpr double kSurely = 1.25;  // times the weight of the next
    std::vector<Candidate> candidates;
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        if (const auto one = candidate_of(panel, e)) candidates.push_back(*one);
    }
    if (candidates.empty()) return {};
    if (const auto beside = edge_beside_text(panel, candidates, texts)) return {.edge = beside, .is_any = true};
    std::ranges::stable_sort(candidates, std::greater<>(), &Candidate::weight);
    const bool is_sure = candidates.size() == 1 || candidates[0].weight > kSurely * candidates[1].weight;
    return {.edge = is_sure ? std::optional(candidates[0].edge) : std::nullopt, .is_any = true};
}

}  // namespace selvedge::sim
