#include "sim/paper/curve_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace selvedge::sim {
namespace {

Vec2d unit_or_zero(const Vec2d& v) {
    const double length = v.norm();
    return length > 0 ? Vec2d(v / length) : Vec2d(Vec2d::Zero());
}

// De Casteljau's parts before and after a parameter.
std::pair<CurvePiece, CurvePiece> split_piece(const CurvePiece& piece, double t) {
    CurvePiece first = piece, second = piece;
    const auto mix = [&](const Vec2d& a, const Vec2d& b) { return Vec2d((1 - t) * a + t * b); };
    if (piece.is_line) {
        first.p[3] = second.p[0] = mix(piece.p[0], piece.p[3]);
        return {first, second};
    }
    const Vec2d a = mix(piece.p[0], piece.p[1]), b = mix(piece.p[1], piece.p[2]), c = mix(piece.p[2], piece.p[3]);
    const Vec2d ab = mix(a, b), bc = mix(b, c), middle = mix(ab, bc);
    first.p = {piece.p[0], a, ab, middle};
    second.p = {middle, bc, c, piece.p[3]};
    return {first, second};
}

// Where a coordinate of a piece has a value, by bisection between samples.
void find_crossings(const CurvePiece& piece, Eigen::Index axis, double value, std::vector<double>& found) {
    constexpr int kSamples = 32, kHalvings = 40;
    const int samples = piece.is_line ? 1 : kSamples;
    const auto off = [&](double t) { return piece.at(t)[axis] - value; };
    for (int i = 0; i < samples; ++i) {
        double low = i / static_cast<double>(samples), high = (i + 1) / static_cast<double>(samples);
        if ((off(low) < 0) == (off(high) < 0)) continue;
        const bool rises = off(low) < 0;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = (low + high) / 2;
            ((off(middle) < 0) == rises ? low : high) = middle;
        }
        found.push_back((low + high) / 2);
    }
}

bool is_along_border(const CurvePiece& piece, const Eigen::AlignedBox2d& box) {
    constexpr double kNear = 0.05, kLevel = 0.002;  // mm; rad
    const Vec2d along = piece.p[3] - piece.p[0];
    for (const Eigen::Index axis : {Eigen::Index(0), Eigen::Index(1)}) {
        if (!piece.is_line || std::abs(along[axis]) > kLevel * along.norm()) continue;
        for (const double border : {box.min()[axis], box.max()[axis]}) {
            if (std::abs(piece.p[0][axis] - border) < kNear && std::abs(piece.p[3][axis] - border) < kNear) return true;
        }
    }
    return false;
}

// The parts of a piece of an outline within a box, and whether each begins and ends with the piece.
struct InsidePart {
    CurvePiece piece;
    bool begins = false, ends = false;
};
std::vector<InsidePart> parts_inside(const CurvePiece& piece, const Eigen::AlignedBox2d& box, bool is_outline) {
    std::vector<double> at{0, 1};
    for (const Eigen::Index axis : {Eigen::Index(0), Eigen::Index(1)}) {
        find_crossings(piece, axis, box.min()[axis], at);
        find_crossings(piece, axis, box.max()[axis], at);
    }
    std::ranges::sort(at);
    std::vector<InsidePart> parts;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        constexpr double kShortest = 1e-9;
        if (at[i + 1] - at[i] < kShortest || !box.contains(piece.at((at[i] + at[i + 1]) / 2))) continue;
        CurvePiece part = at[i] > 0 ? split_piece(piece, at[i]).second : piece;
        if (at[i + 1] < 1) part = split_piece(part, (at[i + 1] - at[i]) / (1 - at[i])).first;
        if (is_outline && is_along_border(part, box)) continue;
        parts.push_back({part, at[i] <= 0, at[i + 1] >= 1});
    }
    return parts;
}

// Two parts of one line.
std::optional<CurvePiece> one_line(const CurvePiece& a, const CurvePiece& b) {
    constexpr double kStraight = 0.02;  // rad
    if (!a.is_line || !b.is_line) return std::nullopt;
    CurvePiece line = a;
    line.p[3] = b.p[3];
    const auto turn = [&](const Vec2d& u) {
        const Vec2d v = unit_or_zero(line.p[3] - line.p[0]);
        return std::abs(std::atan2(v.x() * u.y() - v.y() * u.x(), v.dot(u)));
    };
    if (turn(a.leaves()) > kStraight || turn(b.leaves()) > kStraight) return std::nullopt;
    return line;
}

// Two parts of one Bezier: de Casteljau's construction run backwards, and compared.
std::optional<CurvePiece> one_curve(const CurvePiece& a, const CurvePiece& b) {
    constexpr double kSame = 0.1;  // mm
    if (a.is_line || b.is_line) return std::nullopt;
    const double before = (a.p[3] - a.p[2]).norm(), after = (b.p[1] - b.p[0]).norm();
    if (!(before > 0 && after > 0)) return std::nullopt;
    const double t = before / (before + after);
    CurvePiece whole = a;
    whole.p[1] = a.p[0] + (a.p[1] - a.p[0]) / t;
    whole.p[2] = b.p[3] - (b.p[3] - b.p[2]) / (1 - t);
    whole.p[3] = b.p[3];
    const auto [first, second] = split_piece(whole, t);
    for (const double s : {0.25, 0.5, 0.75, 1.0}) {
        if ((first.at(s) - a.at(s)).norm() > kSame || (second.at(s) - b.at(s)).norm() > kSame) return std::nullopt;
    }
    return whole;
}

// Joins the end of one piece to the beginning of another. Returns whether the first has become both.
bool merge_pieces(CurvePiece& a, CurvePiece& b) {
    if (std::optional<CurvePiece> line = one_line(a, b)) {
        a = *line;
        return true;
    }
    if (std::optional<CurvePiece> curve = one_curve(a, b)) {
        a = *curve;
        return true;
    }
    a.p[3] = b.p[0] = (a.p[3] + b.p[0]) / 2;
    return false;
}

}  // namespace

Vec2d CurvePiece::at(double t) const {
    if (is_line) return (1 - t) * p[0] + t * p[3];
    const double s = 1 - t;
    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

Vec2d CurvePiece::leaves() const {
    if (!is_line) {
        for (const std::size_t i : {std::size_t(1), std::size_t(2)}) {
            if ((p[i] - p[0]).norm() > 1e-6) return unit_or_zero(p[i] - p[0]);
        }
    }
    return unit_or_zero(p[3] - p[0]);
}

Vec2d CurvePiece::arrives() const {
    return -reversed().leaves();
}

CurvePiece CurvePiece::reversed() const {
    return {is_line, {p[3], p[2], p[1], p[0]}};
}

std::vector<CurvePiece> pieces_of(const DrawnPath& path) {
    std::vector<CurvePiece> pieces;
    for (const OutlineEdge& edge : path.edges) {
        const Vec2d from = path.vertices[static_cast<std::size_t>(edge.start)];
        const Vec2d to = path.vertices[static_cast<std::size_t>(edge.end)];
        const bool is_line = edge.kind != CurveKind::Cubic;
        pieces.push_back({is_line, {from, is_line ? from : edge.control[0], is_line ? to : edge.control[1], to}});
    }
    return pieces;
}

DrawnPath path_of(const std::vector<CurvePiece>& pieces, bool is_closed, const DrawnPath& like) {
    DrawnPath path = like;
    path.vertices.clear();
    path.edges.clear();
    path.turns.clear();
    path.is_closed = is_closed;
    for (const CurvePiece& piece : pieces) {
        OutlineEdge edge;
        edge.start = static_cast<int>(path.vertices.size());
        edge.end = edge.start + 1;
        if (!piece.is_line) {
            edge.kind = CurveKind::Cubic;
            edge.control = {piece.p[1], piece.p[2]};
        }
        path.vertices.push_back(piece.p[0]);
        path.edges.push_back(std::move(edge));
    }
    if (path.edges.empty()) return path;
    if (is_closed) {
        path.edges.back().end = 0;
    } else {
        path.vertices.push_back(pieces.back().p[3]);
    }
    return path;
}

CutRuns cut_to_box(const DrawnPath& path, const Eigen::AlignedBox2d& box) {
    CutRuns cut;
    cut.is_whole = true;
    bool goes_on = false, begins_at_start = false;
    const std::vector<CurvePiece> pieces = pieces_of(path);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        bool reaches_end = false;
        for (const InsidePart& part : parts_inside(pieces[i], box, path.is_closed)) {
            if (!goes_on || !part.begins) cut.runs.emplace_back();
            if (cut.runs.size() == 1 && cut.runs.front().empty()) begins_at_start = i == 0 && part.begins;
            cut.runs.back().push_back(part.piece);
            cut.is_whole = cut.is_whole && part.begins && part.ends;
            goes_on = reaches_end = part.ends;
        }
        goes_on = reaches_end;
        cut.is_whole = cut.is_whole && reaches_end;
    }
    cut.is_whole = cut.is_whole && cut.runs.size() == 1;
    // The last run of a closed path goes on in its first one.
    if (path.is_closed && !cut.is_whole && goes_on && begins_at_start && cut.runs.size() > 1) {
        std::vector<CurvePiece> last = std::move(cut.runs.back());
        cut.runs.pop_back();
        last.insert(last.end(), cut.runs.front().begin(), cut.runs.front().end());
        cut.runs.front() = std::move(last);
    }
    return cut;
}

void append_pieces(std::vector<CurvePiece>& run, const std::vector<CurvePiece>& more) {
    if (more.empty()) return;
    CurvePiece first = more.front();
    const bool is_one = !run.empty() && merge_pieces(run.back(), first);
    if (!is_one) run.push_back(first);
    run.insert(run.end(), more.begin() + 1, more.end());
}

void close_pieces(std::vector<CurvePiece>& run) {
    if (run.size() < 2) return;
    if (!merge_pieces(run.back(), run.front())) return;
    run.front() = run.back();
    run.pop_back();
}

}  // namespace selvedge::sim
