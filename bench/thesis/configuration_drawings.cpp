// Figures 3.5, 3.7 and 3.8: states and configurations, drawn from the tables that the mesh itself uses.
#include <array>
#include <string>

#include "bench/support/svg.h"
#include "bench/thesis/inks.h"
#include "bench/thesis/thesis.h"
#include "sim/adaptive/configuration.h"

namespace selvedge::bench {
namespace {

constexpr double kTriangleSide = 200, kGap = 36, kHead = 26;  // px
constexpr double kTriangleHeight = 0.866 * kTriangleSide;

// The six points of a triangle whose tile starts at this corner: V0 V1 V2 M0 M1 M2.
std::array<Vec2d, 6> points_at(const Vec2d& corner) {
    const Vec2d v0(0, kTriangleHeight), v1(kTriangleSide, kTriangleHeight), v2(kTriangleSide / 2, 0);
    std::array<Vec2d, 6> p{v0, v1, v2, Vec2d::Zero(), Vec2d::Zero(), Vec2d::Zero()};
    for (Vec2d& point : p) point += corner;
    for (std::size_t k = 0; k < 3; ++k) p[3 + k] = 0.5 * (p[k] + p[(k + 1) % 3]);
    return p;
}

void draw_outline(SvgDrawing& svg, const std::array<Vec2d, 6>& p) {
    svg.line({p[0], p[1], p[2]}, {.stroke = kInk, .fill = kPaleFill, .is_closed = true});
}

void draw_split_points(SvgDrawing& svg, const std::array<Vec2d, 6>& p, sim::SplitMask split) {
    for (std::size_t k = 0; k < 3; ++k) {
        if ((split >> k & 1U) != 0) svg.dot(p[3 + k], 4, kRedInk);
    }
}

void draw_inside(SvgDrawing& svg, const std::array<Vec2d, 6>& p, const sim::Layout& inside) {
    for (std::size_t i = 0; i < inside.edge_count; ++i) {
        const auto& [a, b] = inside.edges[i].points;
        svg.line({p[a], p[b]}, {.stroke = kInk});
    }
}

void draw_names(SvgDrawing& svg, const std::array<Vec2d, 6>& p, const sim::Layout& inside) {
    for (std::size_t i = 0; i < inside.triangle_count; ++i) {
        Vec2d middle = Vec2d::Zero();
        for (const sim::LocalPoint point : inside.triangles[i].points) middle += p[point] / 3;
        svg.text(middle + Vec2d(0, 5), "t" + std::to_string(i), {.size_px = 12, .anchor = "middle"});
    }
    for (std::size_t i = 0; i < inside.edge_count; ++i) {
        const auto& [a, b] = inside.edges[i].points;
        const Vec2d middle = 0.7 * p[a] + 0.3 * p[b];  // clear of the names of triangles
        svg.text(middle + Vec2d(3, -3), "e" + std::to_string(i), {.size_px = 11, .fill = kRedInk});
    }
}

Vec2d tile_corner(std::size_t i, std::size_t columns) {
    return {kGap / 2 + static_cast<double>(i % columns) * (kTriangleSide + kGap),
            kHead + 8 + static_cast<double>(i / columns) * (kTriangleHeight + kHead + kGap)};
}

SvgDrawing sheet(std::size_t count, std::size_t columns) {
    const auto rows = static_cast<double>((count + columns - 1) / columns);
    return {static_cast<double>(columns) * (kTriangleSide + kGap), rows * (kTriangleHeight + kHead + kGap)};
}

std::string name_of(char letter, std::size_t number) {
    return letter + std::to_string(number);
}

std::string states_svg() {
    SvgDrawing svg = sheet(sim::kStates, 4);
    for (std::size_t split = 0; split < sim::kStates; ++split) {
        const std::size_t state = sim::state_of(static_cast<sim::SplitMask>(split));
        const Vec2d corner = tile_corner(state, 4);
        const auto p = points_at(corner);
        draw_outline(svg, p);
        draw_split_points(svg, p, static_cast<sim::SplitMask>(split));
        svg.text(corner - Vec2d(0, 10), name_of('S', state), {.size_px = 15, .is_bold = true});
    }
    return svg.to_text();
}

std::string configurations_svg(bool has_names) {
    SvgDrawing svg = sheet(sim::kConfigurations, 4);
    for (std::size_t c = 0; c < sim::kConfigurations; ++c) {
        const auto configuration = static_cast<sim::Configuration>(c);
        const sim::Layout& inside = sim::layout(configuration);
        const Vec2d corner = tile_corner(c, 4);
        const auto p = points_at(corner);
        draw_outline(svg, p);
        draw_inside(svg, p, inside);
        draw_split_points(svg, p, inside.split);
        if (has_names) draw_names(svg, p, inside);
        svg.text(corner - Vec2d(0, 10), name_of('C', c), {.size_px = 15, .is_bold = true});
        if (!has_names) {
            svg.text(corner + Vec2d(34, -10), "state " + name_of('S', sim::state_of(configuration)),
                     {.size_px = 12, .fill = kSoftInk});
        }
    }
    return svg.to_text();
}

}  // namespace

ThesisResult draw_configurations(const ThesisOptions&) {
    return {.drawings = {{"3.5", "The states by split edges (dots)", states_svg()},
                         {"3.7", "The configurations and their states", configurations_svg(false)},
                         {"3.8", "The configurations with internal triangles t and internal edges e",
                          configurations_svg(true)}}};
}

}  // namespace selvedge::bench
