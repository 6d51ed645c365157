#include "sim/paper/drawn_darts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "sim/core/math.h"
#include "sim/paper/drawn_outline.h"
#include "sim/paper/outline_place.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kOnOutline = 1e-3;  // m, from the outline to where a leg begins

struct LooseDart {
    Vec2d from, tip, to;  // m
    std::vector<std::size_t> lines;
};

// One leg, from the outline.
struct DartLeg {
    Vec2d from, tip;  // m
    std::size_t line = 0;
};

// Lines of one straight edge, which may be one leg, and of two, which may be both.
struct StraightLines {
    std::vector<DartLeg> single;
    std::vector<LooseDart> bent;
};

StraightLines straight_lines(const std::vector<DrawnPath>& lines) {
    StraightLines found;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const DrawnPath& line = lines[i];
        const bool is_straight =
            std::ranges::all_of(line.edges, [](const OutlineEdge& edge) { return edge.kind == CurveKind::Line; });
        if (line.is_closed || !is_straight || line.vertices.size() != line.edges.size() + 1) continue;
        // A line for the drafter may meet another anywhere.
        if (line.edges.size() == 1 && line.kind != LineKind::Help)
            found.single.push_back({line.vertices[0], line.vertices[1], i});
        if (line.edges.size() == 2) found.bent.push_back({line.vertices[0], line.vertices[1], line.vertices[2], {i}});
    }
    return found;
}

// All that could be darts by how their lines meet.
std::vector<LooseDart> possible_darts(const Panel& outline, const std::vector<DrawnPath>& lines) {
    StraightLines found = straight_lines(lines);
    std::vector<LooseDart> darts = std::move(found.bent);
    const auto is_on_outline = [&](const Vec2d& at) { return nearest_place(outline, at).distance < kOnOutline; };
    for (DartLeg& leg : found.single) {
        if (!is_on_outline(leg.from)) std::swap(leg.from, leg.tip);
    }
    for (std::size_t i = 0; i < found.single.size(); ++i) {
        for (std::size_t j = i + 1; j < found.single.size(); ++j) {
            const DartLeg &one = found.single[i], &other = found.single[j];
            if ((one.tip - other.tip).norm() < kOnOutline)
                darts.push_back({one.from, one.tip, other.from, {one.line, other.line}});
        }
    }
    return darts;
}

// Whether two lines from the outline to a place inside are as the legs of a dart.
bool is_dart(const Panel& outline, const LooseDart& dart) {
    constexpr double kShortest = 0.03, kDeep = 0.02;         // m: a leg; from the tip to the outline
    constexpr double kNarrowest = 0.003;                     // m, of the mouth
    constexpr double kUnlike = 0.02;                         // of a leg's length
    constexpr double kWidest = 60 * std::numbers::pi / 180;  // rad, at the tip
    const Vec2d one = dart.from - dart.tip, other = dart.to - dart.tip;
    const double least = std::min(one.norm(), other.norm()), most = std::max(one.norm(), other.norm());
    if (least < kShortest || most - least > kUnlike * most || (dart.from - dart.to).norm() < kNarrowest) return false;
    if (std::abs(std::atan2(cross2(one, other), one.dot(other))) > kWidest) return false;
    if (nearest_place(outline, dart.from).distance > kOnOutline) return false;
    return nearest_place(outline, dart.to).distance < kOnOutline && nearest_place(outline, dart.tip).distance > kDeep;
}

// The index of the edge that begins at the place of the outline; the edge there is split if none does.
std::size_t edge_from(Panel& outline, const Vec2d& at) {
    const OutlinePlace place = nearest_place(outline, at);
    const auto edge = as_size(place.edge);
    const double length = outline_length(outline, outline.edges[edge]);
    if (place.t * length < kOnOutline) return edge;
    if ((1 - place.t) * length < kOnOutline) return (edge + 1) % outline.edges.size();
    split_edge(outline, place.edge, place.t);
    return edge + 1;
}

// The outline with the dart; none: it does not go straight across the mouth, or the legs leave the panel.
std::optional<Panel> with_dart(Panel outline, const LooseDart& dart) {
    constexpr double kLongest = 1.4;  // of the mouth: a cap that is drawn over it
    edge_from(outline, dart.from);
    std::size_t to = edge_from(outline, dart.to), from = edge_from(outline, dart.from);
    const std::size_t count = outline.edges.size();
    const auto length_between = [&](std::size_t first, std::size_t last) {
        double length = 0;
        for (std::size_t e = first; e != last; e = (e + 1) % count) length += outline_length(outline, outline.edges[e]);
        return length;
    };
    if (length_between(to, from) < length_between(from, to)) std::swap(from, to);
    const int begin = outline.edges[from].start, end = outline.edges[to].start;
    const Vec2d mouth = outline.vertices[as_size(end)] - outline.vertices[as_size(begin)];
    if (from == to || length_between(from, to) > kLongest * mouth.norm()) return std::nullopt;
    const double area = outline_area(outline);
    const int tip = static_cast<int>(outline.vertices.size());
    outline.vertices.push_back(dart.tip);
    OutlineEdge first = straightened(outline.edges[from]), second = first;
    first.start = begin, first.end = tip;
    second.start = tip, second.end = end;
    second.key = {};
    std::vector<OutlineEdge> edges{first, second};
    for (std::size_t e = to; e != from; e = (e + 1) % count) edges.push_back(outline.edges[e]);
    outline.edges = std::move(edges);
    drop_unused_vertices(outline);
    if (outline_area(outline) > area || !find_outline_crossings(outline, {.most = 1}).empty()) return std::nullopt;
    return outline;
}

}  // namespace

DrawnDarts cut_drawn_darts(Panel& outline, const std::vector<DrawnPath>& lines) {
    DrawnDarts darts;
    if (outline.edges.size() < 3) return darts;
    for (const LooseDart& dart : possible_darts(outline, lines)) {
        if (!is_dart(outline, dart)) continue;
        auto cut = with_dart(outline, dart);
        if (!cut) continue;
        outline = std::move(*cut);
        ++darts.count;
        darts.lines.insert(darts.lines.end(), dart.lines.begin(), dart.lines.end());
    }
    return darts;
}

}  // namespace selvedge::sim
