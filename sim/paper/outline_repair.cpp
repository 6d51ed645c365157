#include "sim/paper/outline_repair.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kSamePoint = 1e-4;  // m: points this near are one

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
    if ((start_of(panel, a) - end_of(panel, b)).norm() > kSamePoint ||
        (end_of(panel, a) - start_of(panel, b)).norm() > kSamePoint)
        return false;
    const Vec2d along = (end_of(panel, a) - start_of(panel, a)).normalized();
    const Vec2d inward(-along.y(), along.x());  // of the first: the cloth lies to the left of its outline
    for (const int vertex : {a.start, a.end}) panel.vertices[as_size(vertex)] += kHalfWidth * inward;
    for (const int vertex : {b.start, b.end}) panel.vertices[as_size(vertex)] -= kHalfWidth * inward;
    return true;
}

double length_between(const Panel& panel, std::size_t from, std::size_t to) {
    double length = 0;
    for (std::size_t e = from; e < to; ++e) length += outline_length(panel, panel.edges[e]);
    return length;
}

// Where an edge that a crossing divides is divided: at its start, its end or within, where it is split.
enum class Division { AtStart, Within, AtEnd };
Division divide(Panel& panel, std::size_t edge, const Vec2d& at) {
    constexpr double kAtEnd = 0.2e-3;  // m; crossings are found within 0.1 mm
    if ((start_of(panel, panel.edges[edge]) - at).norm() < kAtEnd) return Division::AtStart;
    if ((end_of(panel, panel.edges[edge]) - at).norm() < kAtEnd) return Division::AtEnd;
    const double t = nearest_on_edge(panel, panel.edges[edge], at).t;
    if (!(t > 0 && t < 1)) return t <= 0 ? Division::AtStart : Division::AtEnd;
    split_edge(panel, static_cast<int>(edge), t);
    return Division::Within;
}

// Cuts off the shorter part of the outline between two edges that cross. Returns its length; none: it is too long.
std::optional<double> cut_loop(Panel& panel, std::size_t first, std::size_t second, const Vec2d& at) {
    constexpr double kMostShare = 0.1;  // of the outline's length
    if (first == second) return std::nullopt;
    Panel cut = panel;
    // The loop is the edges from begin up to end. The later edge is divided first: the earlier one keeps its index.
    std::size_t end = divide(cut, second, at) == Division::AtStart ? second : second + 1;
    const Division division = divide(cut, first, at);
    const std::size_t begin = division == Division::AtStart ? first : first + 1;
    if (division == Division::Within) ++end;
    const double loop = length_between(cut, begin, end);
    const double whole = length_between(cut, 0, cut.edges.size());
    if (loop > kMostShare * whole && whole - loop > kMostShare * whole) return std::nullopt;
    const auto from = cut.edges.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = cut.edges.begin() + static_cast<std::ptrdiff_t>(end);
    if (loop <= whole - loop)
        cut.edges.erase(from, to);
    else
        cut.edges = std::vector<OutlineEdge>(from, to);
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
