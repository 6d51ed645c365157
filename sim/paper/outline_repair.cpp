#include "sim/paper/outline_repair.h"

#include <algorithm>
#include <cmath>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kSame = 1e-4;  // m: points this near are one

std::size_t as_size(int index) {
    return static_cast<std::size_t>(index);
}

Vec2d start_of(const Panel& panel, const OutlineEdge& edge) {
    return panel.vertices[as_size(edge.start)];
}

Vec2d end_of(const Panel& panel, const OutlineEdge& edge) {
    return panel.vertices[as_size(edge.end)];
}

// Takes off one straight line that runs back over the one before it.
bool drop_retraced(Panel& panel) {
    constexpr double kParallel = 1e-3;  // sine
    const std::size_t count = panel.edges.size();
    for (std::size_t e = 0; e < count && count > 3; ++e) {
        OutlineEdge& edge = panel.edges[e];
        const std::size_t n = (e + 1) % count;
        const OutlineEdge& next = panel.edges[n];
        if (edge.kind != CurveKind::Line || next.kind != CurveKind::Line) continue;
        const Vec2d in = end_of(panel, edge) - start_of(panel, edge);
        const Vec2d out = end_of(panel, next) - start_of(panel, next);
        if (in.dot(out) >= 0 || std::abs(cross2(in, out)) > kParallel * in.norm() * out.norm()) continue;
        edge.end = next.end;
        panel.edges.erase(panel.edges.begin() + static_cast<std::ptrdiff_t>(n));
        const std::size_t kept = n < e ? e - 1 : e;
        const OutlineEdge rest = panel.edges[kept];
        if ((end_of(panel, rest) - start_of(panel, rest)).norm() < kShortestEdge) {
            panel.edges.erase(panel.edges.begin() + static_cast<std::ptrdiff_t>(kept));
            const std::size_t left = panel.edges.size();
            panel.edges[(kept + left - 1) % left].end = panel.edges[kept % left].start;
        }
        return true;
    }
    return false;
}

// Opens a slit between two straight edges that lie on each other, as where a dart closes before it ends at the hem.
bool open_slit(Panel& panel, std::size_t first, std::size_t second) {
    constexpr double kHalfWidth = 1e-4;  // m
    const OutlineEdge a = panel.edges[first], b = panel.edges[second];
    if (a.kind != CurveKind::Line || b.kind != CurveKind::Line) return false;
    if ((start_of(panel, a) - end_of(panel, b)).norm() > kSame ||
        (end_of(panel, a) - start_of(panel, b)).norm() > kSame)
        return false;
    const Vec2d along = (end_of(panel, a) - start_of(panel, a)).normalized();
    const Vec2d inward(-along.y(), along.x());  // of the first: the cloth lies to the left of its outline
    for (const int vertex : {a.start, a.end}) panel.vertices[as_size(vertex)] += kHalfWidth * inward;
    for (const int vertex : {b.start, b.end}) panel.vertices[as_size(vertex)] -= kHalfWidth * inward;
    return true;
}

// The fraction of the edge that is nearest to a point on it.
double fraction_near(const Panel& panel, const OutlineEdge& edge, const Vec2d& p) {
    constexpr int kSteps = 256;
    double best = 0, least = (outline_point(panel, edge, 0) - p).norm();
    for (int i = 1; i <= kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps, distance = (outline_point(panel, edge, t) - p).norm();
        if (distance < least) least = distance, best = t;
    }
    return best;
}

double length_between(const Panel& panel, std::size_t from, std::size_t to) {
    double length = 0;
    for (std::size_t e = from; e < to; ++e) length += outline_length(panel, panel.edges[e]);
    return length;
}

// Cuts off the shorter part of the outline between two edges that cross. Returns its length; none: it is too long.
std::optional<double> cut_loop(Panel& panel, std::size_t first, std::size_t second, const Vec2d& at) {
    constexpr double kMostShare = 0.1;    // of the outline's length
    constexpr double kAtEnd = 1.0 / 128;  // of an edge: nearer crossings are at its end
    if (first == second) return std::nullopt;
    Panel cut = panel;
    // Later edges first, so that the earlier one keeps its index.
    for (const std::size_t edge : {second, first}) {
        const double t = fraction_near(cut, cut.edges[edge], at);
        if (t > kAtEnd && t < 1 - kAtEnd) {
            split_edge(cut, static_cast<int>(edge), t);
            if (edge == first) ++second;
        } else if (edge == second && t <= kAtEnd) {
            --second;
        }
        if (edge == first && t <= kAtEnd && edge > 0) --first;
    }
    // The loop is what lies after the first edge, up to the second.
    const double loop = length_between(cut, first + 1, second + 1);
    const double whole = length_between(cut, 0, cut.edges.size());
    if (loop > kMostShare * whole && whole - loop > kMostShare * whole) return std::nullopt;
    const auto begin = cut.edges.begin() + static_cast<std::ptrdiff_t>(first) + 1;
    const auto end = cut.edges.begin() + static_cast<std::ptrdiff_t>(second) + 1;
    if (loop <= whole - loop)
        cut.edges.erase(begin, end);
    else
        cut.edges = std::vector<OutlineEdge>(begin, end);
    if (cut.edges.size() < 3) return std::nullopt;
    const std::size_t left = cut.edges.size();
    for (std::size_t e = 0; e < left; ++e) cut.edges[e].end = cut.edges[(e + 1) % left].start;
    panel = std::move(cut);
    return std::min(loop, whole - loop);
}

}  // namespace

OutlineRepairs repair_outline(Panel& panel) {
    constexpr int kMost = 40;  // repairs
    OutlineRepairs repairs;
    while (repairs.retraced < kMost && drop_retraced(panel)) ++repairs.retraced;
    for (int i = 0; i < kMost; ++i) {
        bool is_mended = false;
        for (const OutlineCrossing& crossing : find_outline_crossings(panel)) {
            if (open_slit(panel, crossing.first, crossing.second)) {
                ++repairs.slits;
                is_mended = true;
                break;
            }
            const std::optional<double> loop = cut_loop(panel, crossing.first, crossing.second, crossing.place);
            if (!loop) continue;
            ++repairs.loops;
            if (*loop > repairs.longest_loop) repairs.longest_loop = *loop, repairs.place = crossing.place;
            is_mended = true;
            break;
        }
        if (!is_mended) break;
    }
    return repairs;
}

}  // namespace selvedge::sim
