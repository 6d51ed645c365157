#include "sim/paper/cut_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <polyclipping/clipper.hpp>

#include "sim/core/error.h"
#include "sim/paper/fit_curve.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

using Polyline = std::vector<Vec2d>;

std::size_t as_size(int index) {
    return static_cast<std::size_t>(index);
}

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

struct Crossing {
    std::size_t before = 0;  // segment of the first line
    std::size_t after = 0;   // segment of the second line
    Vec2d place = Vec2d::Zero();
};

// Where the end of one line meets the beginning of the next: the meeting nearest to the corner.
std::optional<Crossing> find_crossing(const Polyline& a, const Polyline& b) {
    for (std::size_t j = 0; j + 1 < b.size(); ++j) {
        for (std::size_t k = a.size() - 1; k-- > 0;) {
            const Vec2d d = a[k + 1] - a[k], e = b[j + 1] - b[j], off = b[j] - a[k];
            const double area = cross2(d, e);
            if (std::abs(area) < 1e-18) continue;
            const double s = cross2(off, e) / area, t = cross2(off, d) / area;
            if (s >= -1e-9 && s <= 1 + 1e-9 && t >= -1e-9 && t <= 1 + 1e-9)
                return Crossing{k, j, a[k] + std::clamp(s, 0.0, 1.0) * d};
        }
    }
    return std::nullopt;
}

// Lets both end at the crossing.
void trim(MovedEdge& a, MovedEdge& b, const Crossing& at) {
    a.line.resize(at.before + 1);
    a.line.push_back(at.place);
    b.line.erase(b.line.begin(), b.line.begin() + static_cast<std::ptrdiff_t>(at.after) + 1);
    b.line.insert(b.line.begin(), at.place);
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

constexpr double kGrid = 1e-7;  // m, of Clipper's integers

ClipperLib::Path to_grid(const Polyline& line) {
    ClipperLib::Path path;
    for (const Vec2d& p : line) path.emplace_back(std::llround(p.x() / kGrid), std::llround(p.y() / kGrid));
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
        outer.emplace_back(kGrid * static_cast<double>(p.X), kGrid * static_cast<double>(p.Y));
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

}  // namespace

double allowance_of(const Panel& panel, const OutlineEdge& edge, double pattern_allowance) {
    return edge.allowance.value_or(panel.allowance.value_or(pattern_allowance));
}

CutLine cut_line(const Panel& panel, const CutLineOptions& options) {
    std::vector<double> widths;
    for (const OutlineEdge& edge : panel.edges) widths.push_back(allowance_of(panel, edge, options.pattern_allowance));
    std::vector<MovedEdge> edges = moved_edges(panel, widths, options.chord_error);
    const std::size_t count = edges.size();
    CutLine cut;
    for (std::size_t e = 0; e < count; ++e) {
        const std::size_t next = (e + 1) % count;
        const bool is_hem_corner = is_hem(panel.edges[e]) != is_hem(panel.edges[next]);
        if (!is_hem_corner) {
            if (const auto crossing = find_crossing(edges[e].line, edges[next].line); crossing && count > 2)
                trim(edges[e], edges[next], *crossing);
        }
    }
    for (std::size_t e = 0; e < count; ++e) {
        const std::size_t next = (e + 1) % count;
        Polyline own = edges[e].line;
        const OutlineEdge& before = panel.edges[(e + count - 1) % count];
        // A hem's own ends give way to the mirrored corners.
        if (is_hem(panel.edges[e]) && !is_hem(before) && own.size() > 1) own.erase(own.begin());
        if (is_hem(panel.edges[e]) && !is_hem(panel.edges[next]) && own.size() > 1) own.pop_back();
        cut.outline.insert(cut.outline.end(), own.begin(), own.end());
        append_corner(cut.outline, panel, edges[e], edges[next], panel.edges[e], panel.edges[next], options);
    }
    cut.outline = outer_boundary(cut.outline);
    for (const Notch& notch : panel.notches) {
        const OutlineEdge& edge = panel.edges[as_size(notch.edge)];
        constexpr double kStep = 1e-4;
        const double t = std::clamp(notch.t, kStep, 1 - kStep);
        const Vec2d along =
            (outline_point(panel, edge, t + kStep) - outline_point(panel, edge, t - kStep)).normalized();
        NotchLine line{.on_outline = outline_point(panel, edge, notch.t)};
        line.outward = to_the_right(along);
        line.on_cut = line.on_outline + widths[as_size(notch.edge)] * line.outward;
        line.kind = notch.kind;
        line.count = notch.count;
        cut.notches.push_back(line);
    }
    return cut;
}

// ---- Inward.

namespace {

void append_fitted(Panel& panel, const MovedEdge& edge, const OutlineEdge& own, bool is_last) {
    constexpr double kTolerance = 2.5e-5;  // m
    const auto add = [&](OutlineEdge piece, const Vec2d& start) {
        piece.start = static_cast<int>(panel.vertices.size());
        piece.end = piece.start + 1;
        piece.label = own.label;
        panel.vertices.push_back(start);
        panel.edges.push_back(std::move(piece));
    };
    if (edge.is_line) {
        add({}, edge.line.front());
    } else {
        for (const CubicPoints& cubic : fit_curve(edge.line, {.tolerance = kTolerance})) {
            OutlineEdge piece;
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
