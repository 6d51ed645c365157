#include "sim/paper/dxf_grading.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "sim/core/lower_case.h"
#include "sim/paper/dxf_layers.h"
#include "sim/paper/dxf_lines.h"

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
        reach_ = kOnPoint * extent;
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
    // The moves of the points of a line that have numbers.
    std::map<std::size_t, Vec2d> moves_on(const DxfLine& line, std::size_t size) const {
        std::map<std::size_t, Vec2d> moves;
        for (const NumberedPoint& point : numbered_) {
            for (std::size_t i = 0; i < line.points.size(); ++i) {
                if ((line.points[i] - point.at).norm() <= reach_) moves[i] = scale_ * (*point.moves)[size];
            }
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
            std::size_t nearest = 0;
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < edge.size(); ++i) {
                const double distance = (boundary.points[i] - p).squaredNorm();
                if (distance < least) least = distance, nearest = i;
            }
            return p + edge[nearest] - boundary.points[nearest];
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
            const auto own = std::ranges::find_if(
                numbered_, [&, place = at](const NumberedPoint& one) { return (one.at - place).norm() <= reach_; });
            at = own != numbered_.end() ? Vec2d(at + scale_ * (*own->moves)[size]) : moved(at);
        }
        std::erase_if(piece.texts, [](const DxfLayerText& text) { return lower_case(text.text).starts_with("size"); });
        piece.texts.push_back({.layer = kBoundaryLayer, .text = "Size: " + rules_.sizes[size]});
        return piece;
    }

    const DxfPiece& piece_;
    const GradeRules& rules_;
    double scale_;
    double reach_ = 0;
    std::vector<NumberedPoint> numbered_;
};

}  // namespace

std::vector<DxfPiece> graded_pieces(const DxfPiece& piece, const GradeRules& rules, double metres_per_unit) {
    return PieceGrader(piece, rules, metres_per_unit).grade();
}

}  // namespace selvedge::sim
