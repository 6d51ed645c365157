#include "sim/paper/dxf_grading.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "sim/core/lower_case.h"
#include "sim/paper/dxf_layers.h"
#include "sim/paper/dxf_lines.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

struct NumberedPoint {
    Vec2d at = Vec2d::Zero();
    const std::vector<Vec2d>* moves = nullptr;  // per size
};

// "# 12", "#12".
std::optional<int> rule_number(std::string_view text) {
    if (!text.starts_with('#')) return std::nullopt;
    text.remove_prefix(1);
    while (text.starts_with(' ')) text.remove_prefix(1);
    int number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop != text.data() ? std::optional(number) : std::nullopt;
}

class PieceGrader {
 public:
    PieceGrader(const DxfPiece& piece, const GradeRules& rules, double metres_per_unit)
        : piece_(piece), rules_(rules), scale_(rules.metres_per_unit / metres_per_unit) {
        for (const DxfLayerText& text : piece.texts) {
            const auto number = rule_number(text.text);
            const auto rule = number ? rules.moves.find(*number) : rules.moves.end();
            if (rule != rules.moves.end()) numbered_.push_back({text.at, &rule->second});
        }
        double extent = 0;
        for (const DxfLine& line : piece.lines) extent = std::max(extent, extent_of(line));
        constexpr double kOnPoint = 1e-4;  // of the piece's size
        reach_ = std::max(kOnPoint * extent, std::numeric_limits<double>::min());
        for (std::size_t n = 0; n < numbered_.size(); ++n) cells_[cell_of(numbered_[n].at)].push_back(n);
    }

    std::vector<DxfPiece> grade() const {
        std::vector<DxfPiece> sizes;
        const DxfLine* boundary = largest_closed(piece_, kBoundaryLayer);
        if (!boundary) boundary = largest_closed(piece_, kSewLayer);
        if (numbered_.empty() || !boundary) return sizes;
        for (std::size_t s = 0; s < rules_.sizes.size(); ++s) {
            if (rules_.sizes[s] != rules_.sample_size) sizes.push_back(graded(s, *boundary));
        }
        return sizes;
    }

 private:
    using Cell = std::pair<double, double>;

    Cell cell_of(const Vec2d& p) const { return {std::floor(p.x() / reach_), std::floor(p.y() / reach_)}; }

    // How far the point moves that has a number and lies at a place; of several, the last. None: there is none.
    std::optional<Vec2d> own_move(const Vec2d& p, std::size_t size) const {
        const NumberedPoint* found = nullptr;
        const auto [x, y] = cell_of(p);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                const auto cell = cells_.find({x + dx, y + dy});
                if (cell == cells_.end()) continue;
                // Many numbers at one place: the last one on it counts.
                for (auto n = cell->second.rbegin(); n != cell->second.rend(); ++n) {
                    const NumberedPoint& point = numbered_[*n];
                    if ((point.at - p).norm() > reach_) continue;
                    if (!found || found < &point) found = &point;
                    break;
                }
            }
        }
        if (!found) return std::nullopt;
        return Vec2d(piece_.turn * (scale_ * (*found->moves)[size]));
    }

    // The moves of the points of a line that have numbers.
    std::map<std::size_t, Vec2d> moves_on(const DxfLine& line, std::size_t size) const {
        std::map<std::size_t, Vec2d> moves;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            if (const auto move = own_move(line.points[i], size)) moves[i] = *move;
        }
        return moves;
    }

    DxfPiece graded(std::size_t size, const DxfLine& boundary) const {
        DxfPiece piece = piece_;
        piece.records = {};  // of the size that was drawn
        std::vector<Vec2d> edge = boundary.points;
        const std::map<std::size_t, Vec2d> edge_moves = moves_on(boundary, size);
        if (!edge_moves.empty()) grade_line(edge, edge_moves, true);
        const auto moved = [&](const Vec2d& p) -> Vec2d {
            const std::vector<Vec2d>& drawn = boundary.points;
            Vec2d move = Vec2d::Zero();
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
                const double s = nearest_fraction(p, drawn[i], drawn[i + 1]);
                const double distance = (drawn[i] + s * (drawn[i + 1] - drawn[i]) - p).squaredNorm();
                if (!(distance < least)) continue;
                least = distance;
                move = (1 - s) * (edge[i] - drawn[i]) + s * (edge[i + 1] - drawn[i + 1]);
            }
            return p + move;
        };
        for (DxfLine& line : piece.lines) {
            const std::map<std::size_t, Vec2d> moves = moves_on(line, size);
            if (!moves.empty()) {
                grade_line(line.points, moves, line.is_closed);
            } else {
                for (Vec2d& p : line.points) p = moved(p);
            }
        }
        for (auto& [layer, at] : piece.points) {
            const auto own = own_move(at, size);
            at = own ? Vec2d(at + *own) : moved(at);
        }
        set_size(piece, rules_.sizes[size]);
        return piece;
    }

    const DxfPiece& piece_;
    const GradeRules& rules_;
    double scale_;
    double reach_ = 0;
    std::vector<NumberedPoint> numbered_;
    std::map<Cell, std::vector<std::size_t>> cells_;  // as wide as the reach
};

}  // namespace

void set_size(DxfPiece& piece, const std::string& size) {
    std::erase_if(piece.texts, [](const DxfLayerText& text) { return lower_case(text.text).starts_with("size"); });
    piece.texts.push_back({.layer = kBoundaryLayer, .text = "Size: " + size});
}

std::vector<DxfPiece> graded_pieces(const DxfPiece& piece, const GradeRules& rules, double metres_per_unit) {
    return PieceGrader(piece, rules, metres_per_unit).grade();
}

}  // namespace selvedge::sim
