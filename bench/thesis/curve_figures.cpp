// Figures 6.1 to 6.3: the curve of an edge and the order of edges. Table 6.1: weights of the cubic Lagrange curve.
// Figure 6.4: curve shapes at several percentages of the rest length.
// Figure 6.5: SoftCap.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "bench/support/svg.h"
#include "bench/thesis/inks.h"
#include "bench/thesis/thesis.h"
#include "render/surface/edge_curve.h"

namespace selvedge::bench {
namespace {

constexpr int kLevel = 3;  // the table's

// The weights as integers over a common denominator, found by trying powers of 2 up to 2^10. Empty if there is none.
std::string fractions_of(const Vec4f& weights) {
    for (int denominator = 1; denominator <= 1024; denominator *= 2) {
        std::string text;
        bool is_whole = true;
        for (int i = 0; i < 4; ++i) {
            const double value = static_cast<double>(weights[i]) * denominator;
            is_whole = is_whole && std::abs(value - std::round(value)) < 1e-3;
            text += (i > 0 ? ", " : "") + std::to_string(std::lround(value));
        }
        if (is_whole) return "(" + text + ") / " + std::to_string(denominator);
    }
    return {};
}

}  // namespace

ThesisResult list_curve_weights(const ThesisOptions&) {
    const render::CurveWeights weights(kLevel);
    Table table{.name = "6.1",
                .title = "Weights of the cubic Lagrange curve for a maximum level of 3",
                .note =
                    "A point at t is the sum of the four points P0, L1, L2, P3, each times its weight. The program "
                    "computes the table for any maximum level and looks it up by index.",
                .columns = {"index", "t", "P0", "L1", "L2", "P3", "as fractions"}};
    bool sums_to_one = true;
    for (std::size_t i = 0; i <= weights.steps(); ++i) {
        const Vec4f& w = weights.points(i);
        sums_to_one = sums_to_one && std::abs(w.sum() - 1) < 1e-6F;
        std::vector<Cell> row{i, Cell(static_cast<double>(i) / static_cast<double>(weights.steps()), 3)};
        for (int k = 0; k < 4; ++k) row.push_back(Cell(static_cast<double>(w[k]) + 0.0, 6));  // no negative zero
        row.push_back(fractions_of(w));
        table.add_row(std::move(row));
    }
    return {.tables = {table},
            .trends = {{.item = "T6.1",
                        .reported = "a lookup table of four coefficients per t, for level 3.",
                        .measured = std::to_string(weights.steps() + 1) + " rows; the coefficients of each sum to " +
                                    (sums_to_one ? "1." : "another value than 1."),
                        .agrees = sums_to_one && weights.steps() == 8}}};
}

namespace {

// The shapes, by how far the normals lean at both ends of an edge along x.
struct Shape {
    const char* name;
    float lean_a_deg, lean_b_deg;  // from +y, positive towards +x
};
constexpr std::array<Shape, 3> kShapes{{{"arch", -30, 30}, {"S", -30, -30}, {"one end", -30, 0}}};
constexpr std::array<int, 5> kPercentages{100, 95, 90, 80, 70};
constexpr int kSteps = 64;

// M without a soft cap.
constexpr render::CurveModifier kSquare{.k = {0, 0, 1, 0}, .soft_cap = 1e6F};

Vec4f leaning(float deg) {
    const float angle = deg * std::numbers::pi_v<float> / 180;
    return Vec4f(std::sin(angle), std::cos(angle), 0, 0);
}

std::vector<Vec2d> curve_points(const Shape& shape, int percent) {
    const auto length = static_cast<float>(percent) / 100;
    const render::EdgeCurve curve = make_edge_curve({.a = Vec4f::Zero(),
                                                     .b = Vec4f(length, 0, 0, 0),
                                                     .normal_a = leaning(shape.lean_a_deg),
                                                     .normal_b = leaning(shape.lean_b_deg),
                                                     .rest_length = 1},
                                                    kSquare);
    std::vector<Vec2d> points;
    for (int i = 0; i <= kSteps; ++i) {
        const Vec4f w = render::lagrange_weights(static_cast<double>(i) / kSteps);
        const Vec4f p = curve.a * w[0] + curve.l1 * w[1] + curve.l2 * w[2] + curve.b * w[3];
        points.push_back(p.head<2>().cast<double>());
    }
    return points;
}

double length_of(const std::vector<Vec2d>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
    return sum;
}

constexpr std::array<const char*, kPercentages.size()> kPercentageInks{"#1b3a5c", "#2f6d8f", "#4f9a6a", "#c98a1b",
                                                                       "#b5432a"};

std::string shapes_svg() {
    constexpr double kScale = 300, kTop = 150, kStep = 350;  // px
    SvgDrawing svg(kStep * kShapes.size() + 120, 250);
    for (std::size_t s = 0; s < kShapes.size(); ++s) {
        const double left = 20 + kStep * static_cast<double>(s);
        svg.text({left, 22}, kShapes[s].name, {.size_px = 15, .is_bold = true});
        for (std::size_t p = 0; p < kPercentages.size(); ++p) {
            std::vector<Vec2d> line;
            for (const Vec2d& point : curve_points(kShapes[s], kPercentages[p]))
                line.emplace_back(left + kScale * point.x(), kTop - kScale * point.y());
            svg.line(line, {.stroke = kPercentageInks[p], .width_px = 1.8});
            svg.dot(line.back(), 2.5, kPercentageInks[p]);
        }
        svg.dot({left, kTop}, 2.5, "#222");
    }
    for (std::size_t p = 0; p < kPercentages.size(); ++p) {
        const double y = 60 + 24 * static_cast<double>(p), x = kStep * kShapes.size() + 30;
        svg.line({{x, y - 4}, {x + 24, y - 4}}, {.stroke = kPercentageInks[p], .width_px = 2.5});
        svg.text({x + 32, y}, std::to_string(kPercentages[p]) + " %", {.size_px = 13});
    }
    return svg.to_text();
}

// Figures 6.1 and 6.3: an edge and its curve.

constexpr std::string_view kLightGreenInk = "#4f9a6a", kGreyInk = "#8a8780";

// An edge along x, 1 long, with normals that lean outward, unequally.
constexpr Shape kExample{"", -40, 22};

class CurveSketch {
 public:
    CurveSketch()
        : curve_(make_edge_curve({.a = Vec4f::Zero(),
                                  .b = Vec4f(1, 0, 0, 0),
                                  .normal_a = leaning(kExample.lean_a_deg),
                                  .normal_b = leaning(kExample.lean_b_deg),
                                  .rest_length = 1},
                                 curve_modifier(render::SurfaceKind::Constant))) {}

    static Vec2d at(const Vec4f& p) {
        return {130 + 640 * static_cast<double>(p.x()), 310 - 640 * static_cast<double>(p.y())};
    }
    Vec4f point(double t) const {
        const Vec4f w = render::lagrange_weights(t);
        return curve_.a * w[0] + curve_.l1 * w[1] + curve_.l2 * w[2] + curve_.b * w[3];
    }

    void draw_edge_and_curve() {
        svg_.line({at(curve_.a), at(curve_.b)}, {.stroke = kInk, .width_px = 2});
        std::vector<Vec2d> line;
        for (int i = 0; i <= kSteps; ++i) line.push_back(at(point(static_cast<double>(i) / kSteps)));
        svg_.line(line, {.stroke = kLightGreenInk, .width_px = 3});
        for (int i = 0; i <= 8; ++i) {
            const Vec4f flat(static_cast<float>(i) / 8, 0, 0, 0);
            svg_.line({at(flat), at(point(i / 8.0))}, {.stroke = kBlueInk});
            svg_.dot(at(point(i / 8.0)), 3.5, kLightGreenInk);
            svg_.dot(at(flat), 3, kBlueInk);
        }
    }
    void mark(const Vec4f& p, std::string_view name, std::string_view ink, double dy = -12) {
        svg_.dot(at(p), 5, ink);
        svg_.text(at(p) + Vec2d(0, dy), name, {.size_px = 15, .fill = ink, .anchor = "middle", .is_bold = true});
    }

    const render::EdgeCurve& curve() const { return curve_; }
    SvgDrawing& svg() { return svg_; }

 private:
    render::EdgeCurve curve_;
    SvgDrawing svg_{900, 370};
};

struct BezierPoints {
    Vec4f p1, p2;
};

// The inner control points: those at a third and two thirds of the edge, projected on the normal planes of its ends.
BezierPoints bezier_points(const render::EdgeCurve& curve) {
    const Vec4f along = curve.b - curve.a;
    return {.p1 = (2 * curve.a + curve.b - along.dot(curve.normal_a) * curve.normal_a) / 3,
            .p2 = (curve.a + 2 * curve.b + along.dot(curve.normal_b) * curve.normal_b) / 3};
}

std::string bezier_svg() {
    CurveSketch sketch;
    const render::EdgeCurve& curve = sketch.curve();
    const BezierPoints bezier = bezier_points(curve);
    for (const auto& [end, normal] : {std::pair(curve.a, curve.normal_a), std::pair(curve.b, curve.normal_b)}) {
        const float sign = end.x() > 0 ? -1.0F : 1.0F;  // towards the other end
        const Vec4f inward(sign * normal.y(), -sign * normal.x(), 0, 0);
        sketch.svg().line({CurveSketch::at(end - 0.15F * inward), CurveSketch::at(end + 0.45F * inward)},
                          {.stroke = kGreyInk, .width_px = 1.5, .is_dashed = true});
        sketch.svg().arrow(CurveSketch::at(end), CurveSketch::at(end + 0.16F * normal),
                           {.stroke = kGoldInk, .width_px = 2.5});
    }
    sketch.draw_edge_and_curve();
    const Vec4f c1 = (2 * curve.a + curve.b) / 3, c2 = (curve.a + 2 * curve.b) / 3;
    for (const auto& [from, to] : {std::pair(c1, bezier.p1), std::pair(c2, bezier.p2)})
        sketch.svg().arrow(CurveSketch::at(from), CurveSketch::at(to), {.stroke = kRedInk});
    sketch.mark(c1, "C1", kRedInk, 22);
    sketch.mark(c2, "C2", kRedInk, 22);
    sketch.mark(curve.a, "P0", kInk, 22);
    sketch.mark(bezier.p1, "P1", kInk);
    sketch.mark(bezier.p2, "P2", kInk);
    sketch.mark(curve.b, "P3", kInk, 22);
    return sketch.svg().to_text();
}

std::string lagrange_svg() {
    CurveSketch sketch;
    const render::EdgeCurve& curve = sketch.curve();
    const BezierPoints bezier = bezier_points(curve);
    sketch.svg().line(
        {CurveSketch::at(curve.a), CurveSketch::at(bezier.p1), CurveSketch::at(bezier.p2), CurveSketch::at(curve.b)},
        {.stroke = kGreyInk, .width_px = 1.5, .is_dashed = true});
    sketch.draw_edge_and_curve();
    sketch.mark(curve.a, "P0", kInk, 22);
    sketch.mark(bezier.p1, "P1", kGreyInk);
    sketch.mark(bezier.p2, "P2", kGreyInk);
    sketch.mark(curve.b, "P3", kInk, 22);
    sketch.mark(curve.l1, "L1", kRedInk, 24);
    sketch.mark(curve.l2, "L2", kRedInk, 24);
    return sketch.svg().to_text();
}

// Figure 6.2: the root edges of a triangle at level 3, by when their vertices are evaluated.

struct OrderedEdges {
    SvgDrawing svg{560, 500};
    std::array<int, 3> count{};  // segments at level 3 by their order
};

void draw_segments(OrderedEdges& drawn, const Vec2d& a, const Vec2d& b, std::size_t order) {
    constexpr std::array<std::string_view, 3> kOrderInks{"#c0392b", kBlueInk, kGreenInk};
    constexpr std::array<double, 3> kWidths{5, 3.5, 2};
    const int segments = 8 >> order;
    drawn.svg.line({a, b}, {.stroke = kOrderInks[order], .width_px = kWidths[order]});
    for (int i = 1; i < segments; ++i)
        drawn.svg.dot(a + (b - a) * (i / static_cast<double>(segments)), 3.5, kOrderInks[order]);
    drawn.count[order] += segments;
}

// The edges inside a triangle of this level, then those inside its four children.
void draw_inside_of(OrderedEdges& drawn, const std::array<Vec2d, 3>& p, std::size_t level) {
    if (level == kLevel) return;
    const std::array<Vec2d, 3> m{(p[0] + p[1]) / 2, (p[1] + p[2]) / 2, (p[2] + p[0]) / 2};
    for (std::size_t k = 0; k < 3; ++k) {
        draw_inside_of(drawn, {p[k], m[k], m[(k + 2) % 3]}, level + 1);
    }
    draw_inside_of(drawn, m, level + 1);
    for (std::size_t k = 0; k < 3; ++k) {
        // The innermost edges have no vertices left to evaluate.
        if (level + 1 == kLevel) {
            drawn.svg.line({m[k], m[(k + 1) % 3]}, {.stroke = "#c9c6bf", .width_px = 1});
        } else {
            draw_segments(drawn, m[k], m[(k + 1) % 3], level + 1);
        }
    }
}

std::string order_svg() {
    OrderedEdges drawn;
    const std::array<Vec2d, 3> corners{Vec2d(40, 440), Vec2d(520, 440), Vec2d(280, 24)};
    draw_inside_of(drawn, corners, 0);
    for (std::size_t k = 0; k < 3; ++k) draw_segments(drawn, corners[k], corners[(k + 1) % 3], 0);
    for (const Vec2d& corner : corners) drawn.svg.dot(corner, 7, kInk);
    drawn.svg.text({20, 478}, "1) red: edges of the coarse triangle  2) blue: inside it  3) green: inside its children",
                   {.size_px = 12, .fill = kSoftInk});
    return drawn.svg.to_text();
}

}  // namespace

ThesisResult draw_curve_shapes(const ThesisOptions&) {
    Table table{.name = "figure-6.4",
                .title = "Length of the curve over the rest length",
                .note =
                    "A curve that restored the length would have 1. Normals lean by 30 degrees: outward at both ends "
                    "(arch), to the same side at both (S), at one end only.",
                .columns = {"length / rest length, %", "M"}};
    for (const Shape& shape : kShapes) table.columns.push_back(shape.name);
    bool bends_more = true;
    std::array<double, kShapes.size()> last{};
    for (const int percent : kPercentages) {
        const double length = percent / 100.0;
        std::vector<Cell> row{percent, Cell(1 / (length * length), 3)};
        for (std::size_t s = 0; s < kShapes.size(); ++s) {
            const double restored = length_of(curve_points(kShapes[s], percent));
            bends_more = bends_more && restored / length > last[s];
            last[s] = restored / length;
            row.push_back(Cell(restored, 3));
        }
        table.add_row(std::move(row));
    }
    return {
        .tables = {table},
        .drawings = {{"6.4",
                      "Curves of edges of rest length 1 at 100 to 70 % of it, M = (rest length / length)^2, "
                      "without soft cap",
                      shapes_svg()}},
        .trends = {{.item = "F6.4",
                    .reported = "with M = (rest length / length)^2, all three shapes bend more the shorter the edge.",
                    .measured = bends_more ? "for all three, the curve grows against its chord at each step."
                                           : "some curve does not grow against its chord at some step.",
                    .agrees = bends_more}}};
}

ThesisResult draw_soft_cap(const ThesisOptions&) {
    Figure figure{.series = {.name = "6.5",
                             .title = "SoftCap(M, 1): values up to 1 stay, larger ones grow slowly towards 2",
                             .columns = {"M", "SoftCap(M, 1)", "M itself"}},
                  .y_label = "SoftCap"};
    bool keeps_small = true, stays_below_two = true;
    for (int i = 0; i <= 120; ++i) {
        const float m = 0.05F * static_cast<float>(i), capped = render::soft_cap(m, 1);
        keeps_small = keeps_small && (m > 1 || capped == m);
        stays_below_two = stays_below_two && capped < 2;
        figure.series.add_row({Cell(static_cast<double>(m), 2), Cell(static_cast<double>(capped), 4),
                               m <= 2 ? Cell(static_cast<double>(m), 4) : Cell()});
    }
    return {
        .figures = {figure},
        .trends = {{.item = "F6.5",
                    .reported = "values below SC = 1 are not changed; above, SC + (M - SC) / M.",
                    .measured = std::string(keeps_small ? "values up to 1 are unchanged" : "a value up to 1 changes") +
                                (stays_below_two ? ", and none up to 6 reaches 2." : ", and some reach 2."),
                    .agrees = keeps_small && stays_below_two}}};
}

ThesisResult draw_edge_curves(const ThesisOptions&) {
    return {
        .drawings = {{"6.1", "The Bezier of an edge from the normals at its ends; three bisections", bezier_svg()},
                     {"6.2", "The order of edges in a coarse triangle at level 3", order_svg()},
                     {"6.3", "The Lagrange curve through L1 and L2, the Bezier at t = 1/3 and 2/3", lagrange_svg()}}};
}

}  // namespace selvedge::bench
