#include "sim/mesh/sample_outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/disjoint_sets.h"
#include "sim/core/error.h"
#include "sim/mesh/delaunay.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr int kMaxSegments = 10000;  // per edge; more than any garment needs, so that wrong units cause an error

// The largest distance, m, of the curve from its chords for this number of segments, at 5 probes per segment.
double chord_error_of(const Panel& panel, const OutlineEdge& edge, int segments) {
    constexpr int kProbes = 6;
    double worst = 0;
    Vec2d start = outline_point(panel, edge, 0);
    for (int i = 0; i < segments; ++i) {
        const Vec2d end = outline_point(panel, edge, double(i + 1) / segments);
        for (int probe = 1; probe < kProbes; ++probe) {
            const double t = (i + double(probe) / kProbes) / segments;
            worst = std::max(worst, distance_to_segment(outline_point(panel, edge, t), start, end));
        }
        start = end;
    }
    return worst;
}

// Numbers all edges and all corners of a pattern consecutively, for grouping with DisjointSets.
struct FlatPattern {
    const Pattern& pattern;
    std::vector<int> first_edge;
    std::vector<int> first_vertex;
    int edges = 0;
    int vertices = 0;

    explicit FlatPattern(const Pattern& source) : pattern(source) {
        for (const Panel& panel : source.panels) {
            first_edge.push_back(edges);
            first_vertex.push_back(vertices);
            edges += static_cast<int>(panel.edges.size());
            vertices += static_cast<int>(panel.vertices.size());
        }
    }
    int edge(const SeamSide& side) const { return first_edge[static_cast<std::size_t>(side.panel)] + side.edge; }
    int start(const SeamSide& side) const { return vertex(side, outline_edge(side).start); }
    int end(const SeamSide& side) const { return vertex(side, outline_edge(side).end); }

    const OutlineEdge& outline_edge(const SeamSide& side) const {
        return pattern.panels[static_cast<std::size_t>(side.panel)].edges[static_cast<std::size_t>(side.edge)];
    }
    std::vector<SeamSide> sides() const {
        std::vector<SeamSide> all;
        for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
            for (std::size_t e = 0; e < pattern.panels[p].edges.size(); ++e) {
                all.push_back({static_cast<int>(p), static_cast<int>(e)});
            }
        }
        return all;
    }

 private:
    int vertex(const SeamSide& side, int corner) const {
        return first_vertex[static_cast<std::size_t>(side.panel)] + corner;
    }
};

void require_side(const Pattern& pattern, const SeamSide& side, const std::string& place) {
    if (side.panel < 0 || side.panel >= static_cast<int>(pattern.panels.size())) {
        throw InputError("", place, "no panel number " + std::to_string(side.panel));
    }
    const Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
    if (side.edge < 0 || side.edge >= static_cast<int>(panel.edges.size())) {
        throw InputError("", place, "panel '" + panel.name + "' has no edge " + std::to_string(side.edge));
    }
}

void require_seams(const Pattern& pattern) {
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        const Seam& seam = pattern.seams[i];
        const std::string place = "seams[" + std::to_string(i) + "]";
        require_side(pattern, seam.first, place);
        require_side(pattern, seam.second, place);
        if (seam.first == seam.second) throw InputError("", place, "an edge is sewn to itself");
    }
}

// Whether two edges of a panel coincide with opposite directions, as the two sides of a slit of zero width.
bool are_slit_sides(const Panel& panel, const OutlineEdge& a, const OutlineEdge& b) {
    const auto corner = [&](int index) { return panel.vertices[static_cast<std::size_t>(index)]; };
    const auto near = [](const Vec2d& p, const Vec2d& q) { return (p - q).norm() < kWeldDistance; };
    return near(corner(a.start), corner(b.end)) && near(corner(a.end), corner(b.start)) &&
           near(outline_point(panel, a, 0.5), outline_point(panel, b, 0.5));
}

// Groups the edges that must have the same number of segments.
DisjointSets group_edges(const FlatPattern& flat) {
    DisjointSets groups(static_cast<std::size_t>(flat.edges));
    for (const Seam& seam : flat.pattern.seams) groups.join(flat.edge(seam.first), flat.edge(seam.second));
    for (std::size_t p = 0; p < flat.pattern.panels.size(); ++p) {
        const Panel& panel = flat.pattern.panels[p];
        for (std::size_t a = 0; a < panel.edges.size(); ++a) {
            for (std::size_t b = a + 1; b < panel.edges.size(); ++b) {
                if (!are_slit_sides(panel, panel.edges[a], panel.edges[b])) continue;
                groups.join(flat.first_edge[p] + static_cast<int>(a), flat.first_edge[p] + static_cast<int>(b));
            }
        }
    }
    return groups;
}

DisjointSets group_corners(const FlatPattern& flat) {
    DisjointSets corners(static_cast<std::size_t>(flat.vertices));
    for (const Seam& seam : flat.pattern.seams) {
        const bool reversed = seam.is_reversed;
        corners.join(flat.start(seam.first), reversed ? flat.end(seam.second) : flat.start(seam.second));
        corners.join(flat.end(seam.first), reversed ? flat.start(seam.second) : flat.end(seam.second));
    }
    return corners;
}

// Raises counts where sewing merges both ends of an edge (a ring needs 3 segments), or the ends of two edges that are
// not sewn to each other (2 segments each). With fewer segments the sewn mesh would be degenerate there.
void raise_degenerate_counts(const FlatPattern& flat, DisjointSets& groups, std::vector<int>& counts) {
    DisjointSets corners = group_corners(flat);
    std::map<std::pair<int, int>, std::vector<int>> straight;  // merged ends -> groups with one segment
    for (const SeamSide& side : flat.sides()) {
        const int group = groups.find(flat.edge(side));
        int& count = counts[static_cast<std::size_t>(group)];
        const std::pair<int, int> ends = std::minmax({corners.find(flat.start(side)), corners.find(flat.end(side))});
        if (ends.first == ends.second) count = std::max(count, 3);
        if (count != 1) continue;
        std::vector<int>& same_ends = straight[ends];
        if (std::ranges::find(same_ends, group) == same_ends.end()) same_ends.push_back(group);
    }
    for (const auto& [ends, same_ends] : straight) {
        if (same_ends.size() < 2) continue;
        for (int group : same_ends) {
            int& count = counts[static_cast<std::size_t>(group)];
            count = std::max(count, 2);
        }
    }
}

// Edges that are shorter than a stitch, on both sides of their seams, become points: a triangle at such an edge would
// be stretched to a multiple by corners that meet a millimetre beside it. But a panel of which fewer than three
// segments would be left keeps its edges.
void drop_shortest(const FlatPattern& flat, DisjointSets& groups, std::vector<int>& counts) {
    constexpr double kStitch = 0.002;  // m
    std::vector<bool> is_short(counts.size(), true);
    for (const SeamSide& side : flat.sides()) {
        const Panel& panel = flat.pattern.panels[static_cast<std::size_t>(side.panel)];
        if (panel.edges.size() > 3 && outline_length(panel, flat.outline_edge(side)) < kStitch) continue;
        is_short[static_cast<std::size_t>(groups.find(flat.edge(side)))] = false;
    }
    for (std::size_t p = 0; p < flat.pattern.panels.size(); ++p) {
        std::vector<std::size_t> edges;  // their groups
        int left = 0;
        for (std::size_t e = 0; e < flat.pattern.panels[p].edges.size(); ++e) {
            edges.push_back(static_cast<std::size_t>(groups.find(flat.first_edge[p] + static_cast<int>(e))));
            if (!is_short[edges.back()]) left += counts[edges.back()];
        }
        if (left >= 3) continue;
        for (const std::size_t group : edges) is_short[group] = false;
    }
    for (std::size_t group = 0; group < counts.size(); ++group) {
        if (is_short[group]) counts[group] = 0;
    }
}

}  // namespace

int segments_needed(const Panel& panel, const OutlineEdge& edge, const MeshOptions& options) {
    const double length = outline_length(panel, edge);
    const double wanted = std::round(length / options.target_edge);
    if (!(wanted <= kMaxSegments)) {
        throw InputError("", "panel '" + panel.name + "'",
                         "an outline edge of " + std::to_string(length) + " m is too long to mesh");
    }
    int segments = std::max(1, static_cast<int>(wanted));
    if (edge.kind == CurveKind::Line) return segments;
    while (segments < kMaxSegments) {
        const double error = chord_error_of(panel, edge, segments);
        if (error <= options.chord_error) break;
        // The error decreases with the square of the number of segments: jump to a number that is certainly needed.
        const int leap = static_cast<int>(0.7 * segments * std::sqrt(std::min(error / options.chord_error, 1e4)));
        segments = std::max(segments + 1, leap);
    }
    return std::min(segments, kMaxSegments);
}

std::vector<std::vector<int>> count_segments(const Pattern& pattern, const MeshOptions& options) {
    require_seams(pattern);
    const FlatPattern flat(pattern);
    DisjointSets groups = group_edges(flat);
    std::vector<int> counts(static_cast<std::size_t>(flat.edges), 1);  // valid at each group's representative
    for (const SeamSide& side : flat.sides()) {
        const Panel& panel = pattern.panels[static_cast<std::size_t>(side.panel)];
        int& count = counts[static_cast<std::size_t>(groups.find(flat.edge(side)))];
        count = std::max(count, segments_needed(panel, flat.outline_edge(side), options));
    }
    raise_degenerate_counts(flat, groups, counts);
    drop_shortest(flat, groups, counts);

    std::vector<std::vector<int>> segments(pattern.panels.size());
    for (const SeamSide& side : flat.sides()) {
        const int count = counts[static_cast<std::size_t>(groups.find(flat.edge(side)))];
        segments[static_cast<std::size_t>(side.panel)].push_back(count);
    }
    return segments;
}

SampledOutline sample_outline(const Panel& panel, const std::vector<int>& segments) {
    SELVEDGE_ASSERT(segments.size() == panel.edges.size());
    SampledOutline sampled;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        SELVEDGE_ASSERT(segments[i] >= 0);
        sampled.runs.push_back({static_cast<int>(sampled.points.size()), segments[i]});
        for (int k = 0; k < segments[i]; ++k) {
            sampled.points.push_back(outline_point(panel, panel.edges[i], double(k) / segments[i]));
        }
    }
    return sampled;
}

namespace {

struct Segment {
    Vec2d start;
    Vec2d end;
};

bool boxes_meet(const Segment& a, const Segment& b) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [a_low, a_high] = std::minmax(a.start[axis], a.end[axis]);
        const auto [b_low, b_high] = std::minmax(b.start[axis], b.end[axis]);
        if (a_high < b_low || b_high < a_low) return false;
    }
    return true;
}

// Whether p is strictly between the ends of s. Pre: p is on the line of s.
bool is_between(const Vec2d& p, const Segment& s) {
    const int axis = std::abs(s.end.x() - s.start.x()) >= std::abs(s.end.y() - s.start.y()) ? 0 : 1;
    const auto [low, high] = std::minmax(s.start[axis], s.end[axis]);
    return low < p[axis] && p[axis] < high;
}

bool is_crossing(const Segment& a, const Segment& b) {
    if (!boxes_meet(a, b)) return false;
    if (a.start == b.start && a.end == b.end) return true;
    const int b_start = side_of(a.start, a.end, b.start);
    const int b_end = side_of(a.start, a.end, b.end);
    const int a_start = side_of(b.start, b.end, a.start);
    const int a_end = side_of(b.start, b.end, a.end);
    if (b_start * b_end < 0 && a_start * a_end < 0) return true;
    return (b_start == 0 && is_between(b.start, a)) || (b_end == 0 && is_between(b.end, a)) ||
           (a_start == 0 && is_between(a.start, b)) || (a_end == 0 && is_between(a.end, b));
}

}  // namespace

double smallest_angle(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    const auto angle = [](const Vec2d& at, const Vec2d& p, const Vec2d& q) {
        return std::atan2(std::abs(cross2(p - at, q - at)), (p - at).dot(q - at));
    };
    const double ab = (b - a).squaredNorm();
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    if (ab <= bc && ab <= ca) return angle(c, a, b);
    return bc <= ca ? angle(a, b, c) : angle(b, c, a);
}

void weld(std::vector<Vec2d>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if ((points[i] - points[k]).squaredNorm() < kWeldDistance * kWeldDistance) {
                points[i] = points[k];
                break;
            }
        }
    }
}

// Tests only segments whose boxes meet: sorted by their lower ends, along the axis on which they are shorter.
std::optional<std::pair<int, int>> find_crossing(std::span<const Vec2d> outline) {
    const std::size_t count = outline.size();
    const auto segment = [&](std::size_t i) { return Segment{outline[i], outline[(i + 1) % count]}; };
    std::pair first(count, count);  // of all pairs, the one that comes first
    Vec2d extent = Vec2d::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        const Segment own = segment(i);
        extent += (own.end - own.start).cwiseAbs();
        if (own.start == own.end) first = std::min(first, {i, i});
    }
    const int axis = extent.x() <= extent.y() ? 0 : 1;
    const auto low = [&](std::size_t i) { return std::min(outline[i][axis], outline[(i + 1) % count][axis]); };
    const auto high = [&](std::size_t i) { return std::max(outline[i][axis], outline[(i + 1) % count][axis]); };
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, low);
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t m = k + 1; m < count && low(order[m]) <= high(order[k]); ++m) {
            const std::pair<std::size_t, std::size_t> pair = std::minmax(order[k], order[m]);
            if (pair < first && is_crossing(segment(pair.first), segment(pair.second))) first = pair;
        }
    }
    if (first.first == count) return std::nullopt;
    return std::pair(static_cast<int>(first.first), static_cast<int>(first.second));
}

}  // namespace selvedge::sim
