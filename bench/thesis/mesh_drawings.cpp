// Explanatory drawings of chapter 3: figures 3.1 to 3.4, 3.6 and 3.10 to 3.15. Connections, permissions, normals,
// pushes and forces are those of the program, asked of small meshes.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bench/support/svg.h"
#include "bench/support/table.h"
#include "bench/thesis/inks.h"
#include "bench/thesis/provot_cloth.h"
#include "bench/thesis/thesis.h"
#include "sim/adaptive/adapt.h"
#include "sim/adaptive/adaptive_mesh.h"
#include "sim/adaptive/criteria.h"
#include "sim/cloth/contact.h"
#include "sim/collide/collider.h"

namespace selvedge::bench {
namespace {

constexpr double kEquilateralHeight = 0.8660254;  // of an equilateral triangle of side 1

// Triangles in the plane, one panel; material coordinates are positions.
sim::GarmentMesh flat_base(const std::vector<Vec2d>& points, const std::vector<std::array<int, 3>>& triangles) {
    sim::GarmentMesh base;
    for (const Vec2d& p : points) base.x.emplace_back(p.x(), p.y(), 0);
    for (const auto& v : triangles) {
        sim::GarmentTriangle t{.vertices = v};
        for (std::size_t k = 0; k < 3; ++k) t.u[k] = points[static_cast<std::size_t>(v[k])];
        base.triangles.push_back(t);
    }
    base.panel_names = {"cloth"};
    base.panel_grain_angles = {0};
    return base;
}

sim::GarmentMesh one_triangle() {
    return flat_base({{0, 0}, {1, 0}, {0.5, kEquilateralHeight}}, {{0, 1, 2}});
}

sim::GarmentMesh two_triangles() {
    return flat_base({{0, 0}, {1, 0}, {0.5, kEquilateralHeight}, {1.5, kEquilateralHeight}}, {{0, 1, 2}, {1, 3, 2}});
}

sim::EdgeId edge_between(const sim::AdaptiveMesh& mesh, std::uint32_t a, std::uint32_t b) {
    for (const sim::LeafEdge& e : mesh.leaf_edges()) {
        if ((e.a.value == a && e.b.value == b) || (e.a.value == b && e.b.value == a)) return e.edge;
    }
    return {};
}

// Splits edges of one level. Pre: each is permitted.
void split_all(sim::AdaptiveMesh& mesh, const std::vector<sim::EdgeId>& edges) {
    const int level = mesh.level(edges.front());
    for (const sim::EdgeId e : edges) mesh.split(e);
    mesh.retriangulate(level);
    mesh.refresh_lists();
}

std::vector<sim::EdgeId> edges_of(const sim::AdaptiveMesh& mesh, sim::TriangleId t) {
    return {mesh.triangle(t).edges.begin(), mesh.triangle(t).edges.end()};
}

// Positions of the mesh's vertices in a drawing, from the material coordinates of its leaves.
class Placed {
 public:
    Placed(const sim::AdaptiveMesh& mesh, const Vec2d& lower_left, double scale)
        : points_(mesh.vertex_capacity(), Vec2d::Zero()) {
        for (const sim::LeafTriangle& t : mesh.leaf_triangles()) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2d u = t.u[k].cast<double>();
                points_[t.v[k].value] = lower_left + scale * Vec2d(u.x(), -u.y());
            }
        }
    }

    const Vec2d& operator[](sim::VertexId v) const { return points_[v.value]; }

 private:
    std::vector<Vec2d> points_;
};

Vec2d middle_of(const Placed& at, const std::array<sim::VertexId, 3>& v) {
    return (at[v[0]] + at[v[1]] + at[v[2]]) / 3;
}

void draw_leaves(SvgDrawing& svg, const sim::AdaptiveMesh& mesh, const Placed& at) {
    for (const sim::LeafTriangle& t : mesh.leaf_triangles())
        svg.line({at[t.v[0]], at[t.v[1]], at[t.v[2]]}, {.stroke = kInk, .fill = kPaleFill, .is_closed = true});
}

void heading(SvgDrawing& svg, const Vec2d& at, const std::string& text) {
    svg.text(at, text, {.size_px = 14, .is_bold = true});
}

// Figure 3.1: from some vertices to their adjacent leaf triangles.
std::string adjacency_svg() {
    sim::GarmentMesh base = flat_base(
        {{0, 0},
         {1, 0},
         {2, 0},
         {-0.5, kEquilateralHeight},
         {0.5, kEquilateralHeight},
         {1.5, kEquilateralHeight},
         {2.5, kEquilateralHeight},
         {0, 2 * kEquilateralHeight},
         {1, 2 * kEquilateralHeight},
         {2, 2 * kEquilateralHeight}},
        {{0, 4, 3}, {0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {3, 4, 7}, {4, 8, 7}, {4, 5, 8}, {5, 9, 8}, {5, 6, 9}});
    sim::AdaptiveMesh mesh(base);
    SvgDrawing svg(760, 440);
    const Placed at(mesh, {150, 400}, 210);
    draw_leaves(svg, mesh, at);
    for (const auto& [vertex, colour] : {std::pair(4U, kRedInk), std::pair(5U, kBlueInk), std::pair(0U, kGreenInk)}) {
        const sim::VertexId v(vertex);
        for (const sim::TriangleId t : mesh.triangles_at(v)) {
            const Vec2d to = middle_of(at, mesh.triangle(t).vertices);
            const Vec2d aside = 0.06 * Vec2d(-(to - at[v]).y(), (to - at[v]).x());  // arrows to one triangle stay apart
            svg.arrow(at[v], to + aside, {.stroke = colour, .width_px = 1.8});
        }
        svg.dot(at[v], 7, colour);
    }
    return svg.to_text();
}

// The edge and its descendants, one row for each level, from x0 to x1.
struct EdgeRows {
    SvgDrawing& svg;
    const sim::AdaptiveMesh& mesh;
    double top, row;

    double y(int level) const { return top + row * level; }

    template <class Draw>  // draw(edge, x0, x1)
    void for_each(sim::EdgeId e, double x0, double x1, const Draw& draw) const {
        draw(e, x0, x1);
        if (!mesh.is_split(e)) return;
        const double x = (x0 + x1) / 2;
        for_each(mesh.edge(e).children[0], x0, x, draw);
        for_each(mesh.edge(e).children[1], x, x1, draw);
    }
};

// A mesh in which the first base edge is split towards its first end down to the deepest level.
sim::AdaptiveMesh split_towards_a_corner() {
    const sim::GarmentMesh base = one_triangle();
    sim::AdaptiveMesh mesh(base, {.max_level = 3});
    sim::TriangleId corner(0);
    for (int level = 0; level < 3; ++level) {
        split_all(mesh, edges_of(mesh, corner));
        corner = mesh.triangle(corner).internal_triangles[0];
    }
    return mesh;
}

// Figure 3.2: centres, and the child edges AC and CB, of which each AC is split again.
std::string children_svg() {
    const sim::AdaptiveMesh mesh = split_towards_a_corner();
    SvgDrawing svg(900, 330);
    const EdgeRows rows{svg, mesh, 50, 75};
    rows.for_each(sim::EdgeId(0), 60, 840, [&](sim::EdgeId e, double x0, double x1) {
        const int level = mesh.level(e);
        const double y = rows.y(level), x = (x0 + x1) / 2;
        svg.line({{x0, y}, {x1, y}}, {.stroke = kInk, .width_px = 2});
        for (const double end : {x0, x1}) svg.dot({end, y}, 4.5, kInk);
        if (!mesh.is_split(e)) return;
        const double below = rows.y(level + 1);
        svg.line({{x, y}, {x, below}}, {.stroke = kSoftInk, .width_px = 1, .is_dashed = true});
        svg.dot({x, y}, 5.5, kRedInk);
        svg.text({x + 14, y + 20}, "C", {.size_px = 14, .fill = kRedInk, .anchor = "middle"});
        svg.text({(x0 + x) / 2, below - 10}, "AC", {.anchor = "middle"});
        svg.text({(x + x1) / 2, below - 10}, "CB", {.anchor = "middle"});
    });
    for (int level = 0; level <= 3; ++level)
        svg.text({60, rows.y(level) + 22}, "level " + std::to_string(level), {.size_px = 12, .fill = kSoftInk});
    svg.text({48, 54}, "A", {.size_px = 15, .anchor = "end", .is_bold = true});
    svg.text({852, 54}, "B", {.size_px = 15, .is_bold = true});
    return svg.to_text();
}

struct NamedBox {
    Vec2d at = Vec2d::Zero();  // its centre, px
    std::string name;
};

void draw_box(SvgDrawing& svg, const NamedBox& box, std::string_view fill, double width = 66) {
    const Vec2d w(width / 2, 0), h(0, 15);
    svg.line({box.at - w - h, box.at + w - h, box.at + w + h, box.at - w + h},
             {.stroke = kInk, .width_px = 1.2, .fill = fill, .is_closed = true});
    svg.text(box.at + Vec2d(0, 5), box.name, {.anchor = "middle"});
}

// From a box to others, from border to border.
void link(SvgDrawing& svg, const Vec2d& from, const std::vector<NamedBox>& to, std::string_view fill) {
    for (const NamedBox& box : to) {
        const Vec2d along = (box.at - from).normalized();
        svg.arrow(from + 24 * along, box.at - 24 * along, {.stroke = kSoftInk});
        draw_box(svg, box, fill);
    }
}

// Figure 3.3: what an edge refers to, by both structures.
std::string edge_links_svg() {
    constexpr std::string_view kVertex = "#e5eef5", kEdge = "#f7ecd8", kTriangle = "#e8f1e6";
    SvgDrawing svg(1000, 420);
    heading(svg, {20, 28}, "Edge-Pair: two half-edges");
    for (const double side : {0.0, 1.0}) {
        const Vec2d half(150 + 240 * side, 220);
        const double out = 2 * side - 1;
        link(svg, half, {{half + Vec2d(43 * out, -120), side < 0.5 ? "A" : "B"}, {half + Vec2d(-43 * out, -120), "C"}},
             kVertex);
        link(svg, half, {{half + Vec2d(-45, 120), "AC"}, {half + Vec2d(45, 120), "CB"}}, kEdge);
        link(svg, half, {{half + Vec2d(95 * out, 60), side < 0.5 ? "left" : "right"}}, kTriangle);
        draw_box(svg, {half, side < 0.5 ? "half" : "twin"}, "#ffffff", 60);
    }
    svg.arrow({182, 214}, {358, 214}, {.stroke = kRedInk});
    svg.arrow({358, 228}, {182, 228}, {.stroke = kRedInk});
    heading(svg, {540, 28}, "Edge-Trio: one edge with two sides");
    const Vec2d edge(770, 220);
    link(svg, edge, {{edge + Vec2d(-110, -120), "A"}, {edge + Vec2d(0, -120), "C"}, {edge + Vec2d(110, -120), "B"}},
         kVertex);
    link(svg, edge, {{edge + Vec2d(-60, 120), "AC"}, {edge + Vec2d(60, 120), "CB"}}, kEdge);
    for (const double out : {-1.0, 1.0}) {
        const Vec2d side = edge + Vec2d(95 * out, 0);
        svg.line({edge, side}, {.stroke = kRedInk});
        link(svg, side, {{side + Vec2d(95 * out, 60), out < 0 ? "left" : "right"}}, kTriangle);
        draw_box(svg, {side, out < 0 ? "side 0" : "side 1"}, "#ffffff");
    }
    draw_box(svg, {edge, "edge"}, "#ffffff", 60);
    svg.text({20, 405}, "Blue: vertices. Yellow: edges. Green: triangles. Red: what holds the two sides together.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

// Figure 3.4: the vertices of a triangle and its sides of edges, anticlockwise.
std::string triangle_links_svg() {
    const sim::GarmentMesh base = one_triangle();
    const sim::AdaptiveMesh mesh(base);
    SvgDrawing svg(520, 430);
    const Placed at(mesh, {90, 380}, 360);
    draw_leaves(svg, mesh, at);
    const sim::AdaptiveTriangle& t = mesh.triangle(sim::TriangleId(0));
    const Vec2d middle = middle_of(at, t.vertices);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2d &a = at[t.vertices[k]], &b = at[t.vertices[(k + 1) % 3]];
        const Vec2d in_a = a + 0.13 * (middle - a), in_b = b + 0.13 * (middle - b);
        svg.arrow(in_a + 0.06 * (in_b - in_a), in_b - 0.06 * (in_b - in_a), {.stroke = kRedInk, .width_px = 2});
        const Vec2d side = (in_a + in_b) / 2;
        svg.arrow(middle, side + 0.18 * (middle - side), {.stroke = kSoftInk});
        svg.arrow(middle, a + 0.28 * (middle - a), {.stroke = kBlueInk});
        svg.dot(a, 7, kBlueInk);
        const Vec2d out = (a - middle).normalized(), beyond = ((a + b) / 2 - middle).normalized();
        svg.text(a + 22 * out + Vec2d(0, 5), "V" + std::to_string(k),
                 {.size_px = 15, .anchor = "middle", .is_bold = true});
        svg.text((a + b) / 2 + 18 * beyond + Vec2d(0, 5), "E" + std::to_string(k),
                 {.size_px = 15, .fill = kRedInk, .anchor = "middle", .is_bold = true});
    }
    return svg.to_text();
}

// Figure 3.6: internal triangles inside of their parents, each drawn a little smaller.
void draw_nested(SvgDrawing& svg, const sim::AdaptiveMesh& mesh, const Placed& at, sim::TriangleId id) {
    constexpr std::array<std::string_view, 3> kFills{kPaleFill, "#dbe7d6", "#f4e2c4"};
    constexpr double kInset = 4;  // px per level, from its second on
    const sim::AdaptiveTriangle& t = mesh.triangle(id);
    const Vec2d middle = middle_of(at, t.vertices);
    std::vector<Vec2d> corners;
    for (const sim::VertexId v : t.vertices) {
        const Vec2d to = middle - at[v];
        corners.emplace_back(at[v] + (t.level == 0 ? 0 : kInset * (t.level + 1)) * to.normalized());
    }
    svg.line(corners, {.stroke = kInk, .width_px = 1.2, .fill = kFills[t.level % 3U], .is_closed = true});
    if (is_leaf(t)) return;
    for (std::size_t i = 0; i < sim::layout(t.configuration).triangle_count; ++i)
        draw_nested(svg, mesh, at, t.internal_triangles[i]);
}

std::string patterns_svg() {
    constexpr double kScale = 165, kStep = 235, kLeft = 20;
    const sim::GarmentMesh base = one_triangle();
    sim::AdaptiveMesh mesh(base);
    SvgDrawing svg(5 * kStep - 30, 270);
    int tile = 0;
    const auto show = [&](const std::string& name) {
        const Placed at(mesh, {kLeft + kStep * tile, 200}, kScale);
        draw_nested(svg, mesh, at, sim::TriangleId(0));
        svg.text({kLeft + kStep * tile + kScale / 2, 228}, name, {.anchor = "middle"});
        if (tile > 0) {
            const double x = kLeft + kStep * tile - 58, y = 120;
            svg.arrow({x, y - 6}, {x + 46, y - 6}, {.stroke = kRedInk, .width_px = 2});
            svg.arrow({x + 46, y + 6}, {x, y + 6}, {.stroke = kBlueInk, .width_px = 2});
        }
        ++tile;
    };
    show("S0");
    split_all(mesh, {edge_between(mesh, 0, 1)});
    show("S1");
    split_all(mesh, {edge_between(mesh, 1, 2)});
    show("S4");
    split_all(mesh, {edge_between(mesh, 2, 0)});
    show("S7");
    split_all(mesh, edges_of(mesh, mesh.triangle(sim::TriangleId(0)).internal_triangles[0]));
    show("S7, its child t0 in S7");
    svg.text({kLeft, 258}, "Red: splits. Blue: rejoins. Each is one transition of one triangle and its neighbours.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

// Figures 3.10 and 3.11: green may change, red may not; grey is at the deepest level.
std::string_view split_colour(const sim::AdaptiveMesh& mesh, sim::EdgeId e) {
    if (mesh.may_split(e)) return kGreenInk;
    return mesh.level(e) == mesh.max_level() ? "#9a9a96" : kRedInk;
}

std::string flattened_edge_svg() {
    const sim::AdaptiveMesh mesh = split_towards_a_corner();
    SvgDrawing svg(900, 470);
    heading(svg, {20, 28}, "The hierarchy of an edge");
    const EdgeRows rows{svg, mesh, 70, 70};
    constexpr double kFlat = 390;
    const auto draw_edge = [&](sim::EdgeId e, double x0, double x1, double y) {
        const double gap = 7;
        svg.line({{x0 + gap, y}, {x1 - gap, y}}, {.stroke = split_colour(mesh, e), .width_px = 4});
    };
    const auto draw_centre = [&](sim::EdgeId e, double x, double y) {
        svg.dot({x, y}, 7.0 - mesh.level(e), mesh.may_rejoin(e) ? kGreenInk : kRedInk);
    };
    rows.for_each(sim::EdgeId(0), 110, 860, [&](sim::EdgeId e, double x0, double x1) {
        const int level = mesh.level(e);
        const double y = rows.y(level), x = (x0 + x1) / 2;
        if (!mesh.is_split(e)) {
            draw_edge(e, x0, x1, y);
            draw_edge(e, x0, x1, kFlat);
            return;
        }
        svg.line({{x0, y}, {x1, y}}, {.stroke = kSoftInk, .width_px = 1});
        for (const double below : {rows.y(level + 1), kFlat})
            svg.line({{x, y}, {x, below}}, {.stroke = "#c9c6bf", .width_px = 1, .is_dashed = true});
        draw_centre(e, x, y);
        draw_centre(e, x, kFlat);
    });
    for (int level = 0; level <= 3; ++level)
        svg.text({20, rows.y(level) + 5}, "level " + std::to_string(level), {.size_px = 12, .fill = kSoftInk});
    heading(svg, {20, kFlat - 40}, "The same, flattened");
    svg.text({20, 440},
             "Lines: edges that may be split are green. Dots: centres of split edges; they may rejoin if green.",
             {.size_px = 12, .fill = kSoftInk});
    svg.text({20, 458}, "Grey edges have level 3, the deepest here; with a deepest level of 4 they could be split.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

void draw_permissions(SvgDrawing& svg, const sim::AdaptiveMesh& mesh, const Placed& at) {
    for (const sim::LeafTriangle& t : mesh.leaf_triangles())
        svg.line({at[t.v[0]], at[t.v[1]], at[t.v[2]]},
                 {.stroke = kPaleFill, .width_px = 0.5, .fill = kPaleFill, .is_closed = true});
    for (const sim::LeafEdge& e : mesh.leaf_edges()) {
        const Vec2d &a = at[e.a], &b = at[e.b];
        const Vec2d gap = 7 * (b - a).normalized();
        svg.line({a + gap, b - gap}, {.stroke = split_colour(mesh, e.edge), .width_px = 3});
    }
    for (int level = 0; level < mesh.max_level(); ++level) {
        for (const sim::EdgeId e : mesh.split_edges(level))
            svg.dot(at[mesh.centre(e)], 6.5 - level, mesh.may_rejoin(e) ? kGreenInk : kRedInk);
    }
}

std::string permissions_svg() {
    constexpr double kScale = 260;
    const sim::GarmentMesh base = two_triangles();
    SvgDrawing svg(960, 620);
    const auto show = [&](int tile, const std::string& name, const sim::AdaptiveMesh& mesh) {
        const Vec2d corner(30 + 480 * (tile % 2), 40 + 290 * (tile / 2));
        heading(svg, corner + Vec2d(0, -14), name);
        draw_permissions(svg, mesh, Placed(mesh, corner + Vec2d(0, 235), kScale));
    };
    sim::AdaptiveMesh mesh(base, {.max_level = 3});
    split_all(mesh, {edge_between(mesh, 0, 1), edge_between(mesh, 1, 2)});
    show(0, "Two edges of the left triangle are split", mesh);
    split_all(mesh, {edge_between(mesh, 2, 0)});
    show(1, "All three are split: its children are regular", mesh);
    split_all(mesh, edges_of(mesh, mesh.triangle(sim::TriangleId(0)).internal_triangles[0]));
    show(2, "One child is refined: its edges' parents must wait", mesh);
    sim::AdaptiveMesh both(base, {.max_level = 3});
    sim::NoState none;
    set_uniform_level(both, none, 1);
    show(3, "Both triangles are refined", both);
    svg.text({30, 605},
             "Lines: edges that may be split are green, others red. Dots: centres that may rejoin are green.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

// A patch that is bent like the lid of a barrel, seen at an angle.
Vec2d oblique(const Vec3d& p, const Vec2d& origin, double scale) {
    return origin + scale * Vec2d(p.x() + 0.45 * p.y(), -p.z() - 0.42 * p.y());
}

// Figure 3.12: normals at the ends of an edge, and the angle between them.
std::string curvature_svg() {
    constexpr int kQuads = 4;
    constexpr double kRadius = 1.7, kSpan = 0.7;
    const sim::CurvatureOptions options;
    SvgDrawing svg(960, 380);
    const auto lifted = [&](double x, double y) {
        return Vec3d(kRadius * std::sin(x / kRadius), y, kRadius * std::cos(x / kRadius) - kRadius);
    };
    const auto at = [&](const Vec3d& p) { return oblique(p, {230, 230}, 150); };
    for (int i = 0; i < kQuads; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double x = kSpan * (i - kQuads / 2.0), y = kSpan * j;
            svg.line({at(lifted(x, y)), at(lifted(x + kSpan, y)), at(lifted(x + kSpan, y + kSpan)),
                      at(lifted(x, y + kSpan))},
                     {.stroke = kInk, .width_px = 1, .fill = kPaleFill, .is_closed = true});
            svg.line({at(lifted(x, y)), at(lifted(x + kSpan, y + kSpan))}, {.stroke = kInk, .width_px = 1});
        }
    }
    const Vec3d a = lifted(-kSpan, kSpan), b = lifted(0, kSpan);
    svg.line({at(a), at(b)}, {.stroke = kRedInk, .width_px = 4});
    std::array<Vec3d, 2> normals;
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec3d& end = k == 0 ? a : b;
        normals[k] = Vec3d(end.x(), 0, end.z() + kRadius).normalized();
        svg.arrow(at(end), at(end + 0.7 * normals[k]), {.stroke = kBlueInk, .width_px = 2.5});
        svg.dot(at(end), 5, kBlueInk);
    }
    svg.dot((at(a) + at(b)) / 2, 6, kGoldInk);
    const Vec2d foot(740, 300);
    const double angle = std::acos(normals[0].dot(normals[1]));
    std::vector<Vec2d> arc;
    const auto along = [&](double turn) { return Vec2d(std::sin(turn), -std::cos(turn)); };
    for (int i = 0; i <= 24; ++i) arc.emplace_back(foot + 110 * along(angle * (i / 24.0 - 0.5)));
    for (const double half : {-0.5, 0.5})
        svg.arrow(foot, foot + 200 * along(half * angle), {.stroke = kBlueInk, .width_px = 2.5});
    svg.line(arc, {.stroke = kRedInk, .width_px = 2});
    svg.text(foot + Vec2d(0, -120), Cell(angle, 2).to_text() + " rad", {.fill = kRedInk, .anchor = "middle"});
    svg.text({560, 350},
             "An edge asks for a split above " + Cell(options.split_angle, 2).to_text() + " rad, and rejoins below " +
                 Cell(options.rejoin_angle, 2).to_text() + " rad.",
             {.size_px = 12, .fill = kSoftInk});
    return svg.to_text();
}

// Figure 3.13: an edge cuts the object, is split, and its centre is moved to the offset surface.
std::string collision_svg() {
    constexpr float kRadius = 1, kOffset = 0.03F;
    const sim::SphereCollider sphere(Vec3f::Zero(), kRadius);
    const Vec3f a(-0.95F, 0.55F, 0), b(0.75F, 0.78F, 0);
    const Vec3f middle = (a + b) / 2, moved = sim::outside(middle, Vec3f::UnitY(), sphere, kOffset);
    SvgDrawing svg(1050, 260);
    for (int step = 0; step < 3; ++step) {
        const Vec2d origin(175 + 350 * step, 250);
        const auto at = [&](const Vec3f& p) {
            return Vec2d(origin + 140 * Vec2d(static_cast<double>(p.x()), -static_cast<double>(p.y())));
        };
        std::vector<Vec2d> arc{{origin.x() - 140, 258}};
        for (int i = 0; i <= 48; ++i) {
            const float turn = std::numbers::pi_v<float> * static_cast<float>(i) / 48;
            arc.push_back(at(Vec3f(-std::cos(turn), std::sin(turn), 0)));
        }
        arc.emplace_back(origin.x() + 140, 258);
        svg.line(arc, {.stroke = kInk, .fill = kPaleFill});
        const Vec3f& centre = step == 2 ? moved : middle;
        svg.line({at(a), at(centre), at(b)}, {.stroke = step == 0 ? kRedInk : kGreenInk, .width_px = 3});
        for (const Vec3f& end : {a, b}) svg.dot(at(end), 5.5, kInk);
        if (step > 0) svg.dot(at(centre), 6, kGoldInk);
        if (step == 2) svg.arrow(at(middle), at(centre), {.stroke = kRedInk});
        constexpr std::array<const char*, 3> kNames{"The edge cuts the object", "It is split",
                                                    "C moves to the surface"};
        heading(svg, {origin.x() - 140, 24}, kNames[static_cast<std::size_t>(step)]);
    }
    return svg.to_text();
}

// Figure 3.14: the directions and lengths of edges before and after a split into four.
std::string directions_svg() {
    const sim::GarmentMesh base = one_triangle();
    sim::AdaptiveMesh mesh(base);
    SvgDrawing svg(860, 330);
    const float whole = mesh.rest_length(sim::EdgeId(0));
    for (int tile = 0; tile < 2; ++tile) {
        if (tile == 1) split_all(mesh, edges_of(mesh, sim::TriangleId(0)));
        const Placed at(mesh, {40 + 430.0 * tile, 290}, 300);
        draw_leaves(svg, mesh, at);
        heading(svg, {40 + 430.0 * tile, 26}, tile == 0 ? "(a)" : "(b)");
        for (const sim::LeafEdge& e : mesh.leaf_edges()) {
            const Vec2d &a = at[e.a], &b = at[e.b];
            if (std::abs(a.y() - b.y()) > 1) continue;  // one direction is highlighted
            svg.line({a, b}, {.stroke = kRedInk, .width_px = 4});
            svg.text((a + b) / 2 + Vec2d(0, 18), Cell(e.rest_length / whole, 1).to_text() + " L",
                     {.fill = kRedInk, .anchor = "middle"});
        }
    }
    return svg.to_text();
}

// Figure 3.15: a hinge, and the forces of bending on its four vertices.
std::string bending_svg() {
    const std::array<Vec3f, 4> flat{Vec3f(0, 0, 0), Vec3f(0, 1.4F, 0), Vec3f(-1.2F, 0.7F, 0.45F),
                                    Vec3f(1.2F, 0.7F, 0.45F)};
    constexpr std::array<const char*, 4> kNames{"A", "B", "L", "R"};
    const std::array<Vec3f, 4> forces = bending_forces(flat, 1);
    float most = 0;
    for (const Vec3f& f : forces) most = std::max(most, f.norm());
    SvgDrawing svg(960, 360);
    for (int tile = 0; tile < 2; ++tile) {
        const Vec2d origin(215 + 470 * tile, 300);
        const auto at = [&](const Vec3f& p) { return oblique(p.cast<double>(), origin, 150); };
        for (const std::array<std::size_t, 3>& t : {std::array<std::size_t, 3>{0, 1, 2}, {1, 0, 3}})
            svg.line({at(flat[t[0]]), at(flat[t[1]]), at(flat[t[2]])},
                     {.stroke = kInk, .fill = kPaleFill, .is_closed = true});
        svg.line({at(flat[0]), at(flat[1])}, {.stroke = kRedInk, .width_px = 4});
        for (std::size_t k = 0; k < 4; ++k) {
            if (tile == 1)
                svg.arrow(at(flat[k]), at(flat[k] + 0.6F / most * forces[k]), {.stroke = kBlueInk, .width_px = 2.5});
            svg.dot(at(flat[k]), 5, kInk);
            const Vec2d aside(k == 2 ? -16 : 12, k == 1 ? -10 : 18);
            svg.text(at(flat[k]) + aside, kNames[k], {.size_px = 15, .is_bold = true});
        }
        heading(svg, {20 + 470.0 * tile, 26}, tile == 0 ? "a) the element" : "b) the forces that flatten it");
    }
    return svg.to_text();
}

}  // namespace

ThesisResult draw_mesh_structure(const ThesisOptions&) {
    return {
        .drawings = {{"3.1", "Vertices and the leaf triangles round them, as the mesh gives them", adjacency_svg()},
                     {"3.2", "A split edge: central vertices C, child edges AC and CB", children_svg()},
                     {"3.3", "What an edge refers to", edge_links_svg()},
                     {"3.4", "A triangle: its vertices, and its sides of edges anticlockwise", triangle_links_svg()},
                     {"3.6", "Patterns of refinement; internal triangles lie inside of their parents", patterns_svg()},
                     {"3.10", "Permitted splits and rejoins of one edge, deepest level 3", flattened_edge_svg()},
                     {"3.11", "Permitted splits and rejoins, asked of the mesh", permissions_svg()},
                     {"3.12", "Normals at the ends of an edge, and the angle between them", curvature_svg()},
                     {"3.13", "A collision splits an edge; the new vertex is moved out", collision_svg()},
                     {"3.14", "An edge L long, and the edges of its direction after the split", directions_svg()},
                     {"3.15", "A bending element, and the forces on its vertices", bending_svg()}}};
}

}  // namespace selvedge::bench
