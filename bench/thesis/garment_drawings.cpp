// Explanatory drawings of chapter 4: figures 4.1, 4.4 to 4.6, 4.9 and 4.10. Seams and pushes are those of the program.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bench/support/svg.h"
#include "bench/support/table.h"
#include "bench/thesis/inks.h"
#include "bench/thesis/thesis.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/mesh/sew.h"

namespace selvedge::bench {
namespace {

constexpr std::array<std::string_view, 3> kPanels{"#f3d9d0", "#f7e6c6", "#dcebd8"};
constexpr std::array<std::string_view, 3> kPanelInks{kRedInk, kGoldInk, kGreenInk};

std::string cm(double m) {
    return Cell(100 * m, 1).to_text() + " cm";
}

// Figure 4.1.
std::string data_flow_svg() {
    struct Stage {
        const char* name;
        const char* module;
    };
    constexpr std::array<Stage, 5> kStages{{{"2D panels, seams", "pattern file"},
                                            {"2D mesh of each panel", "sim/mesh"},
                                            {"placed in 3D, linked", "sim/place"},
                                            {"seamed mesh: 3D and 2D", "sim/mesh: sew"},
                                            {"adaptive mesh, cloth", "sim/adaptive, cloth"}}};
    constexpr double kWidth = 180, kStep = 225;
    SvgDrawing svg(kStep * kStages.size() - 25, 170);
    for (std::size_t i = 0; i < kStages.size(); ++i) {
        const double x = 10 + kStep * static_cast<double>(i);
        svg.line({{x, 50}, {x + kWidth, 50}, {x + kWidth, 120}, {x, 120}},
                 {.stroke = kInk, .fill = i < 3 ? kPanels[1] : kPanels[2], .is_closed = true});
        svg.text({x + kWidth / 2, 80}, kStages[i].name, {.anchor = "middle", .is_bold = true});
        svg.text({x + kWidth / 2, 102}, kStages[i].module, {.size_px = 12, .fill = kSoftInk, .anchor = "middle"});
        if (i > 0) svg.arrow({x - kStep + kWidth + 4, 85}, {x - 4, 85}, {.stroke = kInk});
    }
    return svg.to_text();
}

// Figure 4.4: three triangles that meet at one point; in the left picture apart, in the right one merged.
std::string merging_svg() {
    SvgDrawing svg(960, 400);
    for (int tile = 0; tile < 2; ++tile) {
        const bool is_merged = tile == 1;
        const Vec2d centre(230 + 480.0 * tile, 180);
        svg.text({20 + 480.0 * tile, 26}, is_merged ? "Merged" : "Three meshes", {.size_px = 14, .is_bold = true});
        for (std::size_t panel = 0; panel < 3; ++panel) {
            const double turn = 2.0944 * static_cast<double>(panel) - 1.5708;
            const auto out = [&](double more, double length) {
                return Vec2d(length * std::cos(turn + more), length * std::sin(turn + more));
            };
            const Vec2d apart = is_merged ? Vec2d(0, 0) : out(0, 34);
            const std::array<Vec2d, 3> corners{centre + apart, centre + apart + out(-1.0472, 140),
                                               centre + apart + out(1.0472, 140)};
            svg.line({corners.begin(), corners.end()}, {.stroke = kInk, .fill = kPanels[panel], .is_closed = true});
            const Vec2d middle = (corners[0] + corners[1] + corners[2]) / 3;
            for (const Vec2d& corner : corners) {
                const Vec2d inside = corner + 0.3 * (middle - corner);
                svg.dot(inside, 5, kPanelInks[panel]);
                if (!is_merged) svg.dot(corner, 5, kInk);
            }
        }
        if (!is_merged) continue;
        svg.dot(centre, 7, kBlueInk);
        for (const double turn : {-0.5236, 1.5708, 3.6652})
            svg.dot(centre + 140 * Vec2d(std::cos(turn), std::sin(turn)), 7, kBlueInk);
    }
    svg.text({20, 388},
             "Black: vertices. Blue: merged vertices. Red, yellow, green: material coordinates of the corners.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

std::vector<Vec2d> triangle_on(const Vec2d& foot, double base, double height, bool is_below) {
    return {foot - Vec2d(base / 2, 0), foot + Vec2d(base / 2, 0), foot + Vec2d(0, is_below ? height : -height)};
}

// Figure 4.5: two unequal edges, and the edge of their mean length.
std::string unequal_svg() {
    constexpr double kUpper = 0.100, kLower = 0.104, kScale = 2400;  // m; px/m
    constexpr double kShown = 8;                                     // times the difference, so that it can be seen
    const double seamed = sim::seam_rest_length(kUpper, kLower), mean = (kUpper + kLower) / 2;
    const auto drawn = [&](double length) { return kScale * (mean + kShown * (length - mean)); };
    SvgDrawing svg(960, 470);
    const auto draw = [&](double x, double apart, double upper, double lower, bool has_red) {
        for (const bool is_below : {false, true}) {
            const Vec2d foot(x, 235 + (is_below ? apart : -apart));
            const std::vector<Vec2d> t = triangle_on(foot, drawn(is_below ? lower : upper), 150, is_below);
            svg.line(t, {.stroke = kInk, .fill = kPanels[is_below ? 1 : 0], .is_closed = true});
            if (has_red) svg.line({t[0], t[2], t[1]}, {.stroke = kRedInk, .width_px = 3});
            svg.text(t[2] + Vec2d(0, is_below ? 20 : -8), is_below ? "T1" : "T0",
                     {.anchor = "middle", .is_bold = true});
        }
    };
    draw(230, 22, kUpper, kLower, false);
    svg.text({230, 232}, cm(kUpper), {.anchor = "middle"});
    svg.text({230, 252}, cm(kLower), {.anchor = "middle"});
    svg.arrow({440, 235}, {520, 235}, {.stroke = kInk, .width_px = 2});
    draw(730, 0, seamed, seamed, true);
    svg.text({860, 240}, cm(seamed), {.is_bold = true});
    svg.text({20, 455},
             "Differences of length are drawn " + Cell(kShown, 0).to_text() + " times as large. Beyond " +
                 Cell(100 * sim::kSeamEase, 0).to_text() +
                 " % the seam takes the shorter side's length: the longer one gathers.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

// Two triangles of two panels, each with its own material coordinates, that share two vertices.
sim::GarmentMesh seamed_pair() {
    sim::GarmentMesh mesh;
    mesh.x = {{0, 0, 0}, {0.1, 0, 0}, {0.04, 0.09, 0}, {0.07, -0.08, 0}};
    sim::GarmentTriangle upper{.vertices = {0, 1, 2}}, lower{.vertices = {1, 0, 3}, .u = {}, .panel = 1};
    upper.u = {Vec2d(0.02, 0.05), Vec2d(0.1166, 0.0759), Vec2d(0.0354, 0.1474)};
    lower.u = {Vec2d(0.19, 0.075), Vec2d(0.242, -0.0187), Vec2d(0.285, 0.065)};
    mesh.triangles = {upper, lower};
    mesh.panel_names = {"T0", "T1"};
    mesh.panel_grain_angles = {0, 0};
    return mesh;
}

// Figure 4.6: both in their panels' coordinates, and as the hinge between them has them.
std::string continuous_svg() {
    const sim::GarmentMesh base = seamed_pair();
    const sim::AdaptiveMesh mesh(base);
    const sim::Hinge& hinge = mesh.hinges().front();
    constexpr double kScale = 1500;  // px/m
    SvgDrawing svg(960, 400);
    for (std::size_t t = 0; t < 2; ++t) {
        std::vector<Vec2d> corners;
        for (const Vec2d& u : base.triangles[t].u) corners.emplace_back(40 + kScale * u.x(), 310 - kScale * u.y());
        svg.line(corners, {.stroke = kInk, .fill = kPanels[t], .is_closed = true});
        svg.text((corners[0] + corners[1] + corners[2]) / 3, "T" + std::to_string(t),
                 {.anchor = "middle", .is_bold = true});
        svg.line({corners[0], corners[1]}, {.stroke = kPanelInks[t], .width_px = 3});
        svg.dot((corners[0] + corners[1]) / 2, 5, kGoldInk);
    }
    svg.arrow({520, 200}, {600, 200}, {.stroke = kInk, .width_px = 2});
    const Vec2d origin(790, 210);
    const auto at = [&](const Vec2d& p) { return Vec2d(origin + kScale * Vec2d(p.x(), -p.y())); };
    for (std::size_t t = 0; t < 2; ++t) {
        const auto& u = base.triangles[t].u;
        const double half = (u[1] - u[0]).norm() / 2;
        const Vec2d tip = (t == 0 ? hinge.left_at : hinge.right_at).cast<double>();
        svg.line({at({-half, 0}), at({half, 0}), at(tip)}, {.stroke = kInk, .fill = kPanels[t], .is_closed = true});
        const Vec2d aside(0, t == 0 ? -3 : 3);  // px: the edges lie on each other
        svg.line({at({-half, 0}) + aside, at({half, 0}) + aside}, {.stroke = kPanelInks[t], .width_px = 3});
        svg.text((at({-half, 0}) + at({half, 0}) + at(tip)) / 3, "T" + std::to_string(t),
                 {.anchor = "middle", .is_bold = true});
    }
    svg.dot(origin, 5, kGoldInk);
    svg.text({20, 385},
             "Left: in the coordinates of their panels. Right: as the hinge has them; mid-points (dots) coincide.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

// Cross-sections of a surface, and an edge of cloth whose new vertex lies inside. Heights along x, px.
double surface_at(double x) {
    return 200 - 90 * std::exp(-x * x / 9000);
}

void draw_push(SvgDrawing& svg, double left, bool is_closed, bool is_flipped, const std::string& name) {
    const Vec2d origin(left + 205, 0);
    std::vector<Vec2d> outline;
    for (int x = -170; x <= 170; x += 5) outline.emplace_back(origin + Vec2d(x, surface_at(x)));
    if (is_closed) {
        std::vector<Vec2d> area = outline;
        area.emplace_back(origin + Vec2d(170, 285));
        area.emplace_back(origin + Vec2d(-170, 285));
        svg.line(area, {.stroke = kInk, .fill = "#e9e6df", .is_closed = true});
    } else {
        svg.line(outline, {.stroke = kInk, .width_px = 2.5});
    }
    const Vec2d a = origin + Vec2d(-130, 165), b = origin + Vec2d(130, 165), c = (a + b) / 2;
    const Vec2d hit = origin + Vec2d(0, surface_at(0));
    svg.line({a, b}, {.stroke = kSoftInk, .width_px = 2, .is_dashed = true});
    svg.line({a, hit, b}, {.stroke = kGreenInk, .width_px = 3});
    for (const Vec2d& end : {a, b}) {
        svg.dot(end, 5, kInk);
        svg.arrow(end, end + Vec2d(0, is_flipped ? 40 : -40), {.stroke = kBlueInk});
    }
    if (is_flipped) svg.arrow(c, c + Vec2d(0, 70), {.stroke = kBlueInk, .width_px = 2, .is_dashed = true});
    svg.arrow(c, hit, {.stroke = kRedInk, .width_px = 2.5});
    svg.dot(c, 6, kGoldInk);
    svg.dot(hit, 6, kGreenInk);
    svg.text({left + 20, 26}, name, {.size_px = 14, .is_bold = true});
}

constexpr std::string_view kPushKey =
    "Yellow: the new vertex, inside. Green: moved out. Blue: the cloth's normal. Red: the ray that meets the surface.";

std::string push_svg() {
    SvgDrawing svg(430, 330);
    draw_push(svg, 0, true, false, "A new vertex inside an object");
    svg.text({10, 315}, "Yellow: the new vertex. Green: moved out. Blue: normals. Red: the ray.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

std::string both_ways_svg() {
    SvgDrawing svg(860, 330);
    draw_push(svg, 0, false, true, "A: an open surface, the cloth flipped");
    draw_push(svg, 430, true, true, "B: a closed surface, the cloth flipped");
    svg.text({10, 315}, kPushKey, {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

}  // namespace

ThesisResult draw_seams_and_pushes(const ThesisOptions&) {
    return {.drawings = {{"4.1", "From panels to the simulated mesh", data_flow_svg()},
                         {"4.4", "Vertices merge at a seam; material coordinates belong to corners", merging_svg()},
                         {"4.5", "A seam between edges of unequal length", unequal_svg()},
                         {"4.6", "Material coordinates made continuous across a seam", continuous_svg()},
                         {"4.9",
                          "A new vertex inside of an object moves out. Selvedge first tries the normal of the nearest "
                          "point of the surface, and the ray where that points against the cloth's normal",
                          push_svg()},
                         {"4.10", "The ray is followed in both directions", both_ways_svg()}}};
}

}  // namespace selvedge::bench
