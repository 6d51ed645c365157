#include "sim/paper/drawn_allowances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "sim/paper/polyline_crossing.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

using Polyline = std::vector<Vec2d>;

constexpr double kChord = 1e-4;          // m
constexpr double kAllowanceGrid = 1e-4;  // m, of allowances
constexpr double kWidest = 0.12;         // m, that counts as an allowance

std::vector<Polyline> lines_of(const Panel& panel) {
    std::vector<Polyline> lines;
    for (const OutlineEdge& edge : panel.edges) lines.push_back(outline_polyline(panel, edge, kChord));
    return lines;
}

class AllowanceMeter {
 public:
    AllowanceMeter(const Panel& panel, const std::vector<Panel>& cut_lines) : panel_(panel), sewn_(lines_of(panel)) {
        for (const Panel& cut : cut_lines) {
            for (Polyline& line : lines_of(cut)) cut_.push_back(std::move(line));
        }
    }

    // In steps of the grid; none if it is not even, or wider than an allowance is.
    std::optional<long> measure(const OutlineEdge& edge) const {
        constexpr double kUneven = 0.5e-3;  // m
        std::array<double, 3> distances{};
        for (std::size_t i = 0; i < distances.size(); ++i)
            distances[i] = distance_at(edge, 0.35 + 0.15 * static_cast<double>(i));
        const auto [low, high] = std::ranges::minmax(distances);
        if (!(high - low <= kUneven)) return std::nullopt;
        // Drafts are drawn in halves of a millimetre, and rounded.
        constexpr long kHalf = 5;  // in steps of the grid
        const double steps = (low + high) / 2 / kAllowanceGrid;
        const long half = kHalf * std::lround(steps / kHalf);
        return std::abs(steps - static_cast<double>(half)) < 2 ? half : std::lround(steps);
    }

 private:
    // How far the cut line is from a point of an edge, square to it, m; infinite if the sewing line lies between.
    double distance_at(const OutlineEdge& edge, double t) const {
        constexpr double kStep = 1e-4;    // of the edge's length
        constexpr double kInside = 1e-4;  // m: a cut line may lie on the sewing line
        const Vec2d p = outline_point(panel_, edge, t);
        const Vec2d along =
            (outline_point(panel_, edge, t + kStep) - outline_point(panel_, edge, t - kStep)).normalized();
        const Vec2d outward(along.y(), -along.x());
        const auto first_of = [&](const std::vector<Polyline>& lines, double from) {
            const Polyline out{p + from * outward, p + kWidest * outward};
            double least = std::numeric_limits<double>::infinity();
            for (const Polyline& line : lines) {
                for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                    if (const auto at = find_crossing(out, {line[i], line[i + 1]}))
                        least = std::min(least, (at->place - p).dot(outward));
                }
            }
            return least;
        };
        const double cut = first_of(cut_, -kInside);
        return cut <= first_of(sewn_, kInside) + kInside ? std::max(0.0, cut) : std::numeric_limits<double>::infinity();
    }

    const Panel& panel_;
    std::vector<Polyline> sewn_, cut_;
};

}  // namespace

void measure_allowances(Panel& panel, const std::vector<Panel>& cut_lines) {
    if (cut_lines.empty()) return;
    const AllowanceMeter meter(panel, cut_lines);
    std::map<long, double> lengths;  // of outline, by allowance
    std::vector<std::optional<long>> widths;
    for (const OutlineEdge& edge : panel.edges) {
        widths.push_back(meter.measure(edge));
        if (widths.back()) lengths[*widths.back()] += outline_length(panel, edge);
    }
    if (lengths.empty()) return;
    const auto usual = std::ranges::max_element(lengths, {}, [](const auto& one) { return one.second; });
    panel.allowance = kAllowanceGrid * static_cast<double>(usual->first);
    for (std::size_t e = 0; e < widths.size(); ++e) {
        if (widths[e] && *widths[e] != usual->first)
            panel.edges[e].allowance = kAllowanceGrid * static_cast<double>(*widths[e]);
    }
}

}  // namespace selvedge::sim
