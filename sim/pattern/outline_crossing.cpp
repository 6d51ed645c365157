#include "sim/pattern/outline_crossing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr double kCrossingError = 1e-4;  // m, how closely curves are followed

// A piece of a sampled outline, and the edge that it belongs to.
struct Piece {
    Vec2d from;
    Vec2d to;
    std::size_t edge;
    std::size_t order;  // along the loop

    double left() const { return std::min(from.x(), to.x()); }
    double right() const { return std::max(from.x(), to.x()); }
};

std::vector<Piece> sample_outline(const Panel& panel) {
    std::vector<Piece> pieces;
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        const std::vector<Vec2d> points = outline_polyline(panel, panel.edges[e], kCrossingError);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            if (points[i] != points[i + 1]) pieces.push_back({points[i], points[i + 1], e, pieces.size()});
        }
    }
    return pieces;
}

double side_of(const Piece& piece, const Vec2d& p) {
    return cross2(piece.to - piece.from, p - piece.from);
}

bool touches(const Piece& piece, const Vec2d& p, double clearance) {
    if (clearance == 0) return side_of(piece, p) == 0 && (p - piece.from).dot(p - piece.to) <= 0;
    const Vec2d along = piece.to - piece.from;
    const double s = std::clamp(along.dot(p - piece.from) / along.squaredNorm(), 0.0, 1.0);
    return (piece.from + s * along - p).norm() <= clearance;
}

// Where two pieces cross or touch, if they do.
std::optional<Vec2d> meeting(const Piece& a, const Piece& b, double clearance) {
    const double b_from = side_of(a, b.from);
    const double b_to = side_of(a, b.to);
    const double a_from = side_of(b, a.from);
    const double a_to = side_of(b, a.to);
    const auto parted = [](double one, double other) { return (one > 0 && other < 0) || (one < 0 && other > 0); };
    if (parted(b_from, b_to) && parted(a_from, a_to)) return Vec2d(b.from + b_from / (b_from - b_to) * (b.to - b.from));
    for (const Vec2d& p : {b.from, b.to}) {
        if (touches(a, p, clearance)) return p;
    }
    for (const Vec2d& p : {a.from, a.to}) {
        if (touches(b, p, clearance)) return p;
    }
    return {};
}

// Neighbours share an end; they cross only where one runs back along the other.
bool folds_back(const Piece& first, const Piece& next, double clearance) {
    const Vec2d d = first.to - first.from;
    const Vec2d e = next.to - next.from;
    return std::abs(cross2(d, e)) <= clearance * std::max(d.norm(), e.norm()) && d.dot(e) < 0;
}

std::optional<Vec2d> crossing(const Piece& a, const Piece& b, std::size_t count, double clearance) {
    const bool b_follows = (a.order + 1) % count == b.order;
    const bool a_follows = (b.order + 1) % count == a.order;
    if (!b_follows && !a_follows) return meeting(a, b, clearance);
    if (b_follows && folds_back(a, b, clearance)) return b.from;
    if (a_follows && folds_back(b, a, clearance)) return a.from;
    return {};
}

}  // namespace

// Pieces that overlap in x are compared, each pair once.
std::vector<OutlineCrossing> find_outline_crossings(const Panel& panel, const CrossingSearch& search) {
    std::vector<Piece> pieces = sample_outline(panel);
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.left() < b.left(); });
    std::vector<OutlineCrossing> found;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t k = i + 1; k < pieces.size() && pieces[k].left() <= pieces[i].right() + search.clearance;
             ++k) {
            const std::optional<Vec2d> place = crossing(pieces[i], pieces[k], pieces.size(), search.clearance);
            if (!place) continue;
            const auto [first, second] = std::minmax(pieces[i].edge, pieces[k].edge);
            const auto is_known = [&, one = first, other = second](const OutlineCrossing& known) {
                return known.first == one && known.second == other;
            };
            if (std::any_of(found.begin(), found.end(), is_known)) continue;
            found.push_back({first, second, *place});
            if (found.size() >= search.most) return found;
        }
    }
    return found;
}

}  // namespace selvedge
