#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "sim/core/json.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_read.h"

namespace selvedge {
namespace {

constexpr double kShortestEdge = 1e-5;   // m
constexpr double kCrossingError = 1e-4;  // m, how closely curves are followed when looking for crossings
constexpr double kSeamTolerance = 1e-3;  // m, of difference between the two sides of a seam
constexpr double kMostGathers = 4;       // a seam side this many times its partner is a slip of the pen

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

bool touches(const Piece& piece, const Vec2d& p) {
    return side_of(piece, p) == 0 && (p - piece.from).dot(p - piece.to) <= 0;
}

// Where two pieces cross or touch, if they do.
std::optional<Vec2d> meeting(const Piece& a, const Piece& b) {
    const double b_from = side_of(a, b.from);
    const double b_to = side_of(a, b.to);
    const double a_from = side_of(b, a.from);
    const double a_to = side_of(b, a.to);
    const auto parted = [](double one, double other) { return (one > 0 && other < 0) || (one < 0 && other > 0); };
    if (parted(b_from, b_to) && parted(a_from, a_to)) return Vec2d(b.from + b_from / (b_from - b_to) * (b.to - b.from));
    for (const Vec2d& p : {b.from, b.to}) {
        if (touches(a, p)) return p;
    }
    for (const Vec2d& p : {a.from, a.to}) {
        if (touches(b, p)) return p;
    }
    return {};
}

// Neighbours share an end; they cross only where one runs back along the other.
bool folds_back(const Piece& first, const Piece& next) {
    const Vec2d d = first.to - first.from;
    const Vec2d e = next.to - next.from;
    return cross2(d, e) == 0 && d.dot(e) < 0;
}

std::optional<Vec2d> crossing(const Piece& a, const Piece& b, std::size_t count) {
    const bool b_follows = (a.order + 1) % count == b.order;
    const bool a_follows = (b.order + 1) % count == a.order;
    if (!b_follows && !a_follows) return meeting(a, b);
    if (b_follows && folds_back(a, b)) return b.from;
    if (a_follows && folds_back(b, a)) return a.from;
    return {};
}

std::string in_file_units(const Vec2d& p, const Panel& panel, double units) {
    const auto text = [&](double value) { return Json(std::round(value * units * 1e3) / 1e3 + 0.0).number_text(); };
    return "(" + text(panel.is_mirrored ? -p.x() : p.x()) + ", " + text(p.y()) + ")";
}

class ShapeChecker {
 public:
    ShapeChecker(PatternReading& reading, std::string file, double units)
        : reading_(reading), file_(std::move(file)), units_(units) {}

    void check() {
        for (std::size_t i = 0; i < reading_.pattern.panels.size(); ++i) {
            if (reading_.is_sound[i]) check_panel(reading_.pattern.panels[i], reading_.places[i]);
        }
        for (std::size_t i = 0; i < reading_.pattern.seams.size(); ++i) check_seam(i);
    }

 private:
    void add(Severity severity, std::string place, std::string problem) {
        reading_.faults.push_back({severity, file_, std::move(place), std::move(problem)});
    }

    void check_panel(const Panel& panel, const std::string& place) {
        const std::string edges = json_path(place, "edges");
        bool has_length = true;
        for (std::size_t i = 0; i < panel.edges.size(); ++i) {
            if (outline_length(panel, panel.edges[i]) >= kShortestEdge) continue;
            add(Severity::Error, json_path(edges, i), "the edge has no length");
            has_length = false;
        }
        if (has_length) check_crossings(panel, edges);
    }

    // Pieces that overlap in x are compared, each pair once; the first crossing of a pair of edges is reported.
    void check_crossings(const Panel& panel, const std::string& edges) {
        std::vector<Piece> pieces = sample_outline(panel);
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const Piece& a, const Piece& b) { return a.left() < b.left(); });
        std::vector<std::pair<std::size_t, std::size_t>> found;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (std::size_t k = i + 1; k < pieces.size() && pieces[k].left() <= pieces[i].right(); ++k) {
                const std::optional<Vec2d> place = crossing(pieces[i], pieces[k], pieces.size());
                if (!place) continue;
                const auto pair = std::minmax(pieces[i].edge, pieces[k].edge);
                if (std::find(found.begin(), found.end(), std::pair<std::size_t, std::size_t>(pair)) != found.end()) {
                    continue;
                }
                found.emplace_back(pair);
                add(Severity::Error, json_path(edges, pair.first),
                    "the outline crosses or touches itself: edges " + std::to_string(pair.first) + " and " +
                        std::to_string(pair.second) + " meet near " + in_file_units(*place, panel, units_));
                if (found.size() >= kMostCrossings) return;
            }
        }
    }

    void check_seam(std::size_t i) {
        const Seam& seam = reading_.pattern.seams[i];
        const auto length = [&](const SeamSide& side) {
            const Panel& panel = reading_.pattern.panels[static_cast<std::size_t>(side.panel)];
            return outline_length(panel, panel.edges[static_cast<std::size_t>(side.edge)]);
        };
        for (const SeamSide& side : {seam.first, seam.second}) {
            if (!reading_.is_sound[static_cast<std::size_t>(side.panel)]) return;
        }
        const double first = length(seam.first);
        const double second = length(seam.second);
        const double difference = std::abs(first - second);
        if (difference <= kSeamTolerance) return;
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(), "the sides differ by %.1f mm (%.1f and %.1f, ratio %.2f)",
                      1e3 * difference, 1e3 * first, 1e3 * second, std::max(first, second) / std::min(first, second));
        const bool is_absurd = std::max(first, second) > kMostGathers * std::min(first, second);
        add(is_absurd ? Severity::Error : Severity::Warning,
            json_path("pattern.stitches", static_cast<std::size_t>(reading_.seam_indices[i])), text.data());
    }

    static constexpr std::size_t kMostCrossings = 20;  // of one panel: a scribble need not be listed whole

    PatternReading& reading_;
    std::string file_;
    double units_;
};

}  // namespace

void check_shapes(PatternReading& reading, const std::string& file, double units) {
    ShapeChecker(reading, file, units).check();
}

}  // namespace selvedge
