#include "sim/paper/cut_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <polyclipping/clipper.hpp>

#include "sim/core/error.h"
#include "sim/core/math.h"
#include "sim/paper/dart_cap.h"
#include "sim/paper/fit_curve.h"
#include "sim/paper/polyline_crossing.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

using Polyline = std::vector<Vec2d>;

Vec2d to_the_right(const Vec2d& v) {
    return {v.y(), -v.x()};
}

// An edge moved by a distance, and its directions at both ends.
struct MovedEdge {
    Polyline line;
    Vec2d at_start = Vec2d::UnitX();  // unit, in the direction of travel
    Vec2d at_end = Vec2d::UnitX();
    double width = 0;  // m, outward
    bool is_line = false;
};

MovedEdge moved(const Panel& panel, const OutlineEdge& edge, double width, double chord_error) {
    MovedEdge out;
    out.width = width;
    out.is_line = edge.kind == CurveKind::Line;
    out.at_start = curve_direction(panel, edge, EdgeEnd::Start);
    out.at_end = curve_direction(panel, edge, EdgeEnd::End);
    const Polyline points = outline_polyline(panel, edge, chord_error);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec2d along = i == 0 ? out.at_start
                      : i + 1 == points.size()
                          ? out.at_end
                          : Vec2d((points[i + 1] - points[i]).normalized() + (points[i] - points[i - 1]).normalized());
        const double turn = along.norm();
        along /= turn;
        const bool is_inner = i > 0 && i + 1 < points.size();
        // Between two chords the parallel lies further out, so that it keeps its distance from both.
        out.line.push_back(points[i] + (is_inner ? 2 * width / turn : width) * to_the_right(along));
    }
    return out;
}

// Lets both end at the crossing.
void trim(MovedEdge& a, MovedEdge& b, const PolylineCrossing& at) {
    a.line = part_before(a.line, at);
    b.line = part_after(b.line, at);
}

// The place where the tangents at a corner meet; none if they are nearly parallel.
std::optional<Vec2d> mitre(const MovedEdge& a, const MovedEdge& b) {
    const double area = cross2(a.at_end, b.at_start);
    if (std::abs(area) < 1e-6) return std::nullopt;
    const double s = cross2(b.line.front() - a.line.back(), b.at_start) / area;
    return a.line.back() + s * a.at_end;
}

std::vector<MovedEdge> moved_edges(const Panel& panel, const std::vector<double>& widths, double chord_error) {
    std::vector<MovedEdge> edges;
    for (std::size_t e = 0; e < panel.edges.size(); ++e)
        edges.push_back(moved(panel, panel.edges[e], widths[e], chord_error));
    return edges;
}

// ---- Outward.

// The points between the cut lines of two edges at their corner.
Polyline corner_points(const MovedEdge& a, const MovedEdge& b, const Vec2d& corner, AllowanceCorner style_a,
                       AllowanceCorner style_b, double longest_mitre) {
    if ((a.line.back() - b.line.front()).norm() < 1e-9) return {};
    if (style_a == AllowanceCorner::Squared || style_b == AllowanceCorner::Squared) {
        // The end of each cut line is square to its edge; the corner itself lies between.
        const Vec2d outer = a.line.back() + b.line.front() - corner;
        return cross2(a.at_end, b.at_start) > 0 ? Polyline{outer} : Polyline{};
    }
    const std::optional<Vec2d> tip = mitre(a, b);
    if (!tip) return {};
    // Where allowances differ, the lines of edges that go on nearly straight meet far off, on the wrong side of the
    // corner: they are joined by a step.
    constexpr double kOff = 1e-9;  // m
    if ((*tip - a.line.back()).dot(a.at_end) < -kOff || (*tip - b.line.front()).dot(b.at_start) > kOff) return {};
    const double reach = longest_mitre * std::max(a.width, b.width);
    if ((*tip - corner).norm() <= reach) return {*tip};
    // Cut off square to the middle of the corner, at the longest mitre.
    const Vec2d middle = (*tip - corner).normalized();
    const auto at_reach = [&](const Vec2d& from, const Vec2d& along) {
        const double s = (reach - (from - corner).dot(middle)) / along.dot(middle);
        return Vec2d(from + s * along);
    };
    if (std::abs(a.at_end.dot(middle)) < 1e-6 || std::abs(b.at_start.dot(middle)) < 1e-6) return {};
    return {at_reach(a.line.back(), a.at_end), at_reach(b.line.front(), b.at_start)};
}

// Where the neighbour's cut line, mirrored about the hem's edge, meets the hem's cut line: turned up, the allowance
// lies on the panel. `hem_along` points along the hem to the corner, `side_along` from the corner into the neighbour.
Vec2d mirrored_corner(const Vec2d& corner, const Vec2d& hem_along, const Vec2d& side_along, double hem_width,
                      const Vec2d& hem_outward, const Vec2d& side_shift) {
    const auto reflected = [&](const Vec2d& v) { return Vec2d(2 * v.dot(hem_along) * hem_along - v); };
    const Vec2d from = corner + reflected(side_shift), along = reflected(side_along);
    const double rise = along.dot(hem_outward);
    if (std::abs(rise) < 0.1) return corner + hem_width * hem_outward;
    const double s = (hem_width - (from - corner).dot(hem_outward)) / rise;
    return from + s * along;
}

constexpr double kClipperGrid = 1e-7;  // m, of Clipper's integers

ClipperLib::Path to_grid(const Polyline& line) {
    ClipperLib::Path path;
    for (const Vec2d& p : line)
        path.emplace_back(std::llround(p.x() / kClipperGrid), std::llround(p.y() / kClipperGrid));
    return path;
}

// The outer boundary of a closed line that may cross itself.
Polyline outer_boundary(const Polyline& line) {
    ClipperLib::Paths simple;
    ClipperLib::SimplifyPolygon(to_grid(line), simple, ClipperLib::pftPositive);
    const auto largest =
        std::ranges::max_element(simple, {}, [](const ClipperLib::Path& path) { return ClipperLib::Area(path); });
    if (largest == simple.end()) return line;
    Polyline outer;
    for (const ClipperLib::IntPoint& p : *largest)
        outer.emplace_back(kClipperGrid * static_cast<double>(p.X), kClipperGrid * static_cast<double>(p.Y));
    return outer;
}

bool is_hem(const OutlineEdge& edge) {
    return edge.allowance_corner == AllowanceCorner::Mirrored;
}

// The cut lines of two neighbours and what lies between them.
void append_corner(Polyline& line, const Panel& panel, const MovedEdge& a, const MovedEdge& b, const OutlineEdge& from,
                   const OutlineEdge& to, const CutLineOptions& options) {
    const Vec2d corner = panel.vertices[as_size(to.start)];
    if (is_hem(from) && !is_hem(to)) {
        line.push_back(
            mirrored_corner(corner, a.at_end, b.at_start, a.width, to_the_right(a.at_end), b.line.front() - corner));
        return;
    }
    if (is_hem(to) && !is_hem(from)) {
        line.push_back(a.line.back());
        line.push_back(
            mirrored_corner(corner, b.at_start, -a.at_end, b.width, to_the_right(b.at_start), a.line.back() - corner));
        return;
    }
    const Polyline between =
        corner_points(a, b, corner, from.allowance_corner, to.allowance_corner, options.longest_mitre);
    line.insert(line.end(), between.begin(), between.end());
}

// Makes the cut line of a panel, edge by edge.
class CutLineMaker {
 public:
    CutLineMaker(const Panel& panel, const CutLineOptions& options)
        : panel_(panel), options_(options), count_(panel.edges.size()), is_leg_(count_), caps_(count_) {
        for (const OutlineEdge& edge : panel.edges)
            widths_.push_back(allowance_of(panel, edge, options.pattern_allowance));
        edges_ = moved_edges(panel, widths_, options.chord_error);
    }

    CutLine make() {
        std::vector<bool> is_of_dart(count_, false);
        for (const Dart& dart : options_.darts) {
            for (std::size_t k = 0; k < 2 * as_size(dart.leg_edges); ++k)
                is_of_dart[(as_size(dart.first_leg) + k) % count_] = true;
        }
        for (const Dart& dart : options_.darts) cover(dart, is_of_dart);
        trim_corners();
        for (std::size_t e = 0; e < count_; ++e) {
            if (!is_leg_[e]) append(e);
        }
        cut_.outline = outer_boundary(cut_.outline);
        for (const Notch& notch : panel_.notches) cut_.notches.push_back(carried_out(notch));
        return std::move(cut_);
    }

 private:
    std::size_t after(std::size_t e) const { return (e + 1) % count_; }
    std::size_t before(std::size_t e) const { return (e + count_ - 1) % count_; }

    // Lays a cap over the mouth of a dart, unless it begins or ends at another's.
    void cover(const Dart& dart, const std::vector<bool>& is_of_dart) {
        const std::size_t first = as_size(dart.first_leg) % count_, legs = 2 * as_size(dart.leg_edges);
        if (legs + 2 > count_) return;
        const std::size_t from = before(first), last = (first + legs - 1) % count_, to = after(last);
        if (is_of_dart[from] || is_of_dart[to]) return;
        for (std::size_t k = 0; k < legs; ++k) {
            if (panel_.edges[(first + k) % count_].allowance) return;
        }
        const DartMouth mouth{.begin = panel_.vertices[as_size(panel_.edges[first].start)],
                              .end = panel_.vertices[as_size(panel_.edges[last].end)],
                              .begin_outward = -edges_[first].at_start,
                              .end_outward = edges_[last].at_end,
                              .pressed_to = dart.pressed_to,
                              .mitre = options_.longest_mitre * std::max(widths_[from], widths_[to])};
        std::optional<DartCap> cap = cap_dart(mouth, edges_[from].line, edges_[to].line);
        if (!cap) return;
        for (std::size_t k = 0; k < legs; ++k) is_leg_[(first + k) % count_] = true;
        const std::size_t tip = (first + legs / 2) % count_;
        cut_.darts.push_back(
            {.begin = {.on_outline = mouth.begin, .on_cut = cap->before.back(), .outward = mouth.begin_outward},
             .end = {.on_outline = mouth.end, .on_cut = cap->after.front(), .outward = mouth.end_outward},
             .fold = {panel_.vertices[as_size(panel_.edges[tip].start)], cap->fold},
             .is_as_wanted = cap->pressed_to == dart.pressed_to});
        legs_.push_back({first, last});
        edges_[from].line = std::move(cap->before);
        edges_[to].line = std::move(cap->after);
        caps_[from] = std::move(cap->cap);
    }

    bool is_between_edges(std::size_t e) const { return !is_leg_[e] && !is_leg_[after(e)]; }

    bool is_hem_corner(std::size_t e) const {
        return is_between_edges(e) && is_hem(panel_.edges[e]) != is_hem(panel_.edges[after(e)]);
    }

    void trim_corners() {
        for (std::size_t e = 0; e < count_; ++e) {
            if (!is_between_edges(e) || is_hem_corner(e) || count_ <= 2) continue;
            MovedEdge& next = edges_[after(e)];
            if (const auto crossing = find_crossing(edges_[e].line, next.line)) trim(edges_[e], next, *crossing);
        }
    }

    // The cut line of an edge, and what lies between it and the next.
    void append(std::size_t e) {
        Polyline own = edges_[e].line;
        // A hem's own ends give way to the mirrored corners.
        if (is_hem(panel_.edges[e]) && is_hem_corner(before(e)) && own.size() > 1) own.erase(own.begin());
        if (is_hem(panel_.edges[e]) && is_hem_corner(e) && own.size() > 1) own.pop_back();
        cut_.outline.insert(cut_.outline.end(), own.begin(), own.end());
        if (is_between_edges(e)) {
            append_corner(cut_.outline, panel_, edges_[e], edges_[after(e)], panel_.edges[e], panel_.edges[after(e)],
                          options_);
        } else {
            cut_.outline.insert(cut_.outline.end(), caps_[e].begin(), caps_[e].end());
        }
    }

    NotchLine carried_out(const Notch& notch) const {
        const std::size_t e = as_size(notch.edge);
        NotchLine line = is_leg_[e] ? on_leg(notch) : up_to_cut(on_edge(notch));
        line.kind = notch.kind;
        line.count = notch.count;
        return line;
    }

    NotchLine on_edge(const Notch& notch) const {
        const OutlineEdge& edge = panel_.edges[as_size(notch.edge)];
        constexpr double kStep = 1e-4;
        const double t = std::clamp(notch.t, kStep, 1 - kStep);
        const Vec2d along =
            (outline_point(panel_, edge, t + kStep) - outline_point(panel_, edge, t - kStep)).normalized();
        NotchLine line{.on_outline = outline_point(panel_, edge, notch.t), .outward = to_the_right(along)};
        line.on_cut = line.on_outline + widths_[as_size(notch.edge)] * line.outward;
        return line;
    }

    // Near a corner the cut line may lie nearer to the outline, or farther, than the allowance.
    NotchLine up_to_cut(NotchLine line) const {
        constexpr double kOn = 1e-4;       // m
        constexpr double kFarthest = 0.6;  // m, more than any allowance
        if (distance_to_outline(line.on_cut, cut_.outline) < kOn) return line;
        const double width = (line.on_cut - line.on_outline).norm();
        const Polyline out{line.on_outline, line.on_outline + kFarthest * line.outward};
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < cut_.outline.size(); ++i) {
            const auto at = find_crossing(out, {cut_.outline[i], cut_.outline[(i + 1) % cut_.outline.size()]});
            if (!at || std::abs((at->place - line.on_outline).norm() - width) >= least) continue;
            least = std::abs((at->place - line.on_outline).norm() - width);
            line.on_cut = at->place;
        }
        return line;
    }

    // At the mouth it is carried out along the leg. Inside there is no edge to cut it into.
    NotchLine on_leg(const Notch& notch) const {
        constexpr double kAtMouth = 0.01;  // of the edge's length
        for (std::size_t d = 0; d < legs_.size(); ++d) {
            if (legs_[d].first == as_size(notch.edge) && notch.t < kAtMouth) return cut_.darts[d].begin;
            if (legs_[d].last == as_size(notch.edge) && notch.t > 1 - kAtMouth) return cut_.darts[d].end;
        }
        NotchLine line = on_edge(notch);
        line.on_cut = line.on_outline;
        return line;
    }

    struct Legs {
        std::size_t first = 0, last = 0;  // edges at the mouth
    };

    const Panel& panel_;
    const CutLineOptions& options_;
    std::size_t count_;
    std::vector<bool> is_leg_;      // per edge: of a dart that has a cap
    std::vector<Polyline> caps_;    // per edge before a dart's mouth
    std::vector<double> widths_;    // per edge, m
    std::vector<MovedEdge> edges_;  // per edge
    std::vector<Legs> legs_;        // as cut_.darts
    CutLine cut_;
};

}  // namespace

double allowance_of(const Panel& panel, const OutlineEdge& edge, double pattern_allowance) {
    return edge.allowance.value_or(panel.allowance.value_or(pattern_allowance));
}

CutLine cut_line(const Panel& panel, const CutLineOptions& options) {
    return CutLineMaker(panel, options).make();
}

// ---- Inward.

namespace {

void append_fitted(Panel& panel, const MovedEdge& edge, const OutlineEdge& own, bool is_last) {
    constexpr double kTolerance = 2.5e-5;  // m
    const auto add = [&](OutlineEdge piece, const Vec2d& start) {
        piece.start = static_cast<int>(panel.vertices.size());
        piece.end = piece.start + 1;
        panel.vertices.push_back(start);
        panel.edges.push_back(std::move(piece));
    };
    if (edge.is_line) {
        add(straightened(own), edge.line.front());
    } else {
        for (const CubicPoints& cubic : fit_curve(edge.line, {.tolerance = kTolerance})) {
            OutlineEdge piece = straightened(own);
            piece.kind = CurveKind::Cubic;
            piece.control = {cubic[1], cubic[2]};
            add(std::move(piece), cubic[0]);
        }
    }
    if (is_last) panel.edges.back().end = 0;
}

// Joins the ends of neighbours where they do not cross: at smooth joints in the middle, at hollow corners where the
// tangents meet.
void join(MovedEdge& a, MovedEdge& b) {
    const std::optional<Vec2d> tip = mitre(a, b);
    const bool is_corner = tip && (*tip - a.line.back()).norm() < 6 * std::abs(a.width);
    const Vec2d place = is_corner ? *tip : Vec2d((a.line.back() + b.line.front()) / 2);
    if (is_corner && !a.is_line) a.line.push_back(place);
    if (is_corner && !b.is_line) b.line.insert(b.line.begin(), place);
    a.line.back() = place;
    b.line.front() = place;
}

}  // namespace

Panel inset_panel(const Panel& cut, double width) {
    constexpr double kChordError = 1e-5;  // m
    std::vector<MovedEdge> edges = moved_edges(cut, std::vector<double>(cut.edges.size(), -width), kChordError);
    const std::size_t count = edges.size();
    for (std::size_t e = 0; e < count; ++e) {
        MovedEdge& next = edges[(e + 1) % count];
        if (const auto crossing = find_crossing(edges[e].line, next.line); crossing && count > 2) {
            trim(edges[e], next, *crossing);
        } else {
            join(edges[e], next);
        }
    }
    Panel panel = cut;
    panel.vertices.clear();
    panel.edges.clear();
    for (std::size_t e = 0; e < count; ++e) {
        const Polyline& line = edges[e].line;
        const bool is_turned = line.size() < 2 || (line.back() - line.front()).dot(edges[e].at_start) <= 0;
        if (is_turned && edges[e].is_line)
            throw InputError("", cut.name, "edge " + std::to_string(e) + " is too short to take the allowance off");
        append_fitted(panel, edges[e], cut.edges[e], e + 1 == count);
    }
    return panel;
}

}  // namespace selvedge::sim
