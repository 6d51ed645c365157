#include "sim/paper/folded_ribbing.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr double kOnSide = 0.001;  // m: a corner that is nearer to a side of the band lies on it

// How far points of a panel lie from the side of a band that is sewn to the garment.
struct Band {
    Vec2d start = Vec2d::Zero();
    Vec2d inward = Vec2d::UnitY();
    double height = 0;  // m

    double from_side(const Vec2d& point) const { return inward.dot(point - start); }
    bool is_far(const Vec2d& point) const { return from_side(point) > height - kOnSide; }
};

bool is_sewn_to_others(const Pattern& pattern, int panel, int edge) {
    const SeamSide own{.panel = panel, .edge = edge};
    return std::ranges::any_of(pattern.seams, [&](const Seam& seam) {
        return (seam.first == own && seam.second.panel != panel) || (seam.second == own && seam.first.panel != panel);
    });
}

bool is_sewn(const Pattern& pattern, int panel, int edge) {
    const SeamSide own{.panel = panel, .edge = edge};
    return std::ranges::any_of(pattern.seams,
                               [&](const Seam& seam) { return seam.first == own || seam.second == own; });
}

Vec2d corner(const Panel& panel, int vertex) {
    return panel.vertices[static_cast<std::size_t>(vertex)];
}

std::optional<Band> band_of(const Pattern& pattern, int index) {
    const Panel& panel = pattern.panels[static_cast<std::size_t>(index)];
    const auto longest = std::ranges::max_element(panel.edges, {}, [&](const OutlineEdge& edge) {
        const int number = static_cast<int>(&edge - panel.edges.data());
        return is_sewn_to_others(pattern, index, number) ? outline_length(panel, edge) : 0;
    });
    const auto sewn = static_cast<int>(longest - panel.edges.begin());
    if (!is_sewn_to_others(pattern, index, sewn)) return std::nullopt;
    const Vec2d along = (corner(panel, longest->end) - corner(panel, longest->start)).normalized();
    Band band{.start = corner(panel, longest->start), .inward = {-along.y(), along.x()}};
    for (const Vec2d& v : panel.vertices) band.height = std::max(band.height, band.from_side(v));
    for (const OutlineEdge& edge : panel.edges) {
        if (edge.kind != CurveKind::Line) return std::nullopt;
        const Vec2d a = corner(panel, edge.start), b = corner(panel, edge.end);
        const bool is_end = band.is_far(a) != band.is_far(b);
        if (!band.is_far(a) && std::abs(band.from_side(a)) > kOnSide) return std::nullopt;
        if (is_end && std::abs(along.dot(b - a)) > kOnSide) return std::nullopt;
        if (band.is_far(a) && band.is_far(b) && is_sewn(pattern, index, static_cast<int>(&edge - panel.edges.data())))
            return std::nullopt;
    }
    return band;
}

void fold(Panel& panel, const Band& band, double allowance) {
    const double half = band.height / 2;
    for (OutlineEdge& edge : panel.edges) {
        if (!band.is_far(corner(panel, edge.start)) || !band.is_far(corner(panel, edge.end))) continue;
        edge.allowance = half + edge.allowance.value_or(allowance);
        edge.allowance_corner = AllowanceCorner::Squared;
    }
    const auto folded = [&](const Vec2d& point) {
        return Vec2d(point - std::max(0.0, 2 * (band.from_side(point) - half)) * band.inward);
    };
    for (Vec2d& v : panel.vertices) {
        if (band.is_far(v)) v -= half * band.inward;
    }
    for (InternalLine& line : panel.internal_lines) std::ranges::transform(line.points, line.points.begin(), folded);
    std::ranges::transform(panel.drill_points, panel.drill_points.begin(), folded);
}

}  // namespace

std::vector<std::string> fold_ribbing(Pattern& pattern, std::span<const std::string> panels) {
    std::vector<std::string> notes;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        Panel& panel = pattern.panels[p];
        const std::string& drawn = panel.mirror_of.empty() ? panel.name : panel.mirror_of;
        if (std::ranges::find(panels, drawn) == panels.end()) continue;
        const std::optional<Band> band = band_of(pattern, static_cast<int>(p));
        if (!band || band->height / 2 + kOnSide > kWidestAllowance) continue;
        fold(panel, *band, panel.allowance.value_or(pattern.allowance));
        std::array<char, 96> text{};
        std::snprintf(text.data(), text.size(), ": folded in half, so worn %.1f cm high; cut as it is drawn",
                      50 * band->height);
        notes.push_back(panel.name + text.data());
    }
    return notes;
}

}  // namespace selvedge::sim
