#include "sim/paper/dxf_entities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/Splines>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/paper/dxf_layers.h"

namespace selvedge::sim {
namespace {

std::string layer_of(const DxfEntity& entity) {
    return dxf_string(entity.text(8).value_or(""));
}

// Points on the arc that a bulge (the tangent of a quarter of its angle) makes between two vertices.
void append_bulge(std::vector<Vec2d>& points, const Vec2d& to, double bulge) {
    const Vec2d from = points.back();
    const double angle = 4 * std::atan(bulge);
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (5 * kDegree))));
    const Vec2d half = (to - from) / 2;
    const double rise = std::tan(angle / 2);
    if (bulge != 0 && std::abs(rise) > 1e-9) {
        const Vec2d centre = from + half + Vec2d(-half.y(), half.x()) / rise;
        for (int i = 1; i < steps; ++i)
            points.emplace_back(centre + Eigen::Rotation2Dd(angle * i / steps) * (from - centre));
    }
    points.push_back(to);
}

bool closes(const DxfEntity& entity) {
    return (static_cast<int>(std::clamp(entity.number(70).value_or(0), 0.0, 1e6)) & 1) != 0;
}

// Vertices with their bulges, as points; also closed where the last vertex repeats the first.
void draw_vertices(const std::vector<std::pair<Vec2d, double>>& vertices, bool is_closed, DxfLine& out) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (i == 0) {
            out.points.push_back(vertices[0].first);
        } else {
            append_bulge(out.points, vertices[i].first, vertices[i - 1].second);
        }
    }
    if (vertices.size() < 3) return;
    if (is_closed) append_bulge(out.points, vertices[0].first, vertices.back().second);
    out.is_closed = is_closed || out.points.front() == out.points.back();
}

// Points of a rational B-spline by de Boor's recursion of its control points as (weight x, weight y, weight).  (de Boor
// 1972)
Vec2d spline_point(const std::vector<Vec3d>& control, const std::vector<double>& knots, std::size_t degree, double t) {
    const auto first = knots.begin() + static_cast<std::ptrdiff_t>(degree) + 1;
    const auto last = knots.begin() + static_cast<std::ptrdiff_t>(control.size());
    const std::size_t span = degree + static_cast<std::size_t>(std::upper_bound(first, last, t) - first);
    std::vector<Vec3d> d(control.begin() + static_cast<std::ptrdiff_t>(span - degree),
                         control.begin() + static_cast<std::ptrdiff_t>(span) + 1);
    for (std::size_t r = 1; r <= degree; ++r) {
        for (std::size_t j = degree; j >= r; --j) {
            const double low = knots[span - degree + j], high = knots[span + 1 + j - r];
            const double s = high > low ? (t - low) / (high - low) : 0;
            d[j] = (1 - s) * d[j - 1] + s * d[j];
        }
    }
    return d[degree].head<2>() / d[degree].z();
}

// The cubic spline through points, with parameters by their distances; a long list of points is a line already.
std::vector<Vec2d> line_through(std::vector<Vec2d> points) {
    constexpr std::size_t kMost = 300, kDegreeOfSpline = 3;
    constexpr int kSteps = 16;  // between two points
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() <= kDegreeOfSpline || points.size() > kMost) return points;
    Eigen::Matrix2Xd columns(2, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];
    const auto spline = Eigen::SplineFitting<Eigen::Spline<double, 2, 3>>::Interpolate(
        columns, static_cast<Eigen::DenseIndex>(kDegreeOfSpline));
    std::vector<Vec2d> line;
    const int steps = kSteps * static_cast<int>(points.size() - 1);
    for (int i = 0; i <= steps; ++i) line.emplace_back(spline(i / static_cast<double>(steps)).matrix());
    if (!std::ranges::all_of(line, [](const Vec2d& p) { return p.allFinite(); })) return points;
    line.front() = points.front();
    line.back() = points.back();
    return line;
}

// The text of an MTEXT without its formatting: "{\fArial|b0;Cut 2\Pon fold}" is two lines, "Cut 2" and "on fold".
std::string plain_text(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{' || text[i] == '}') continue;
        if (text[i] != '\\' || i + 1 == text.size()) {
            plain += text[i];
            continue;
        }
        const char what = text[++i];
        if (what == 'P') plain += '\n';
        if (what == '~') plain += ' ';
        if (what == '\\' || what == '{' || what == '}') plain += what;
        constexpr std::string_view kWithValue = "fFHWQTACcp";
        if (kWithValue.find(what) != std::string_view::npos) i = std::min(text.find(';', i), text.size());
    }
    return plain;
}

}  // namespace

bool is_dxf_place(const Vec2d& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargestDxfNumber;
}

void transform(DxfPiece& piece, const Eigen::Affine2d& map) {
    piece.turn = map.linear() * piece.turn;
    for (DxfLine& line : piece.lines) {
        for (Vec2d& p : line.points) p = map * p;
    }
    for (auto& [layer, at] : piece.points) at = map * at;
    for (DxfLayerText& text : piece.texts) text.at = map * text.at;
    for (DxfInsert& insert : piece.inserts) insert.map = map * insert.map;
}

void append(DxfPiece& piece, DxfPiece more) {
    std::ranges::move(more.lines, std::back_inserter(piece.lines));
    std::ranges::move(more.points, std::back_inserter(piece.points));
    std::ranges::move(more.texts, std::back_inserter(piece.texts));
    std::ranges::move(more.inserts, std::back_inserter(piece.inserts));
}

void DxfEntityReader::fail(const DxfEntity& entity, const std::string& problem) const {
    throw InputError(file_, "line " + std::to_string(entity.line), std::string(entity.type) + ": " + problem);
}

double DxfEntityReader::coordinate(const DxfEntity& entity, std::string_view text) const {
    const auto value = dxf_number(text);
    if (!value || std::abs(*value) > kLargestDxfNumber)
        fail(entity, "'" + std::string(text.substr(0, 40)) + "' is no coordinate");
    return *value;
}

Vec2d DxfEntityReader::point(const DxfEntity& entity, int code) const {
    const auto x = entity.text(code), y = entity.text(code + 10);
    if (!x || !y) fail(entity, "a point is missing");
    return {coordinate(entity, *x), coordinate(entity, *y)};
}

// All points of a code, in order.
std::vector<Vec2d> DxfEntityReader::points(const DxfEntity& entity, int code) const {
    std::vector<Vec2d> all;
    for (const DxfGroup& group : entity.groups) {
        if (group.code == code) all.emplace_back(coordinate(entity, group.value), 0);
        if (group.code == code + 10 && !all.empty()) all.back().y() = coordinate(entity, group.value);
    }
    return all;
}

DxfLine DxfEntityReader::line_of(const DxfEntity& entity) const {
    DxfLine line{.layer = dxf_layer_number(entity.text(8).value_or("")), .line = entity.line};
    line.layer_name = layer_of(entity);
    line.style = line.layer_name + "|" + std::string(entity.text(62).value_or("")) + "|" +
                 std::string(entity.text(6).value_or(""));
    return line;
}

bool DxfEntityReader::is_hidden(const DxfEntity& entity) const {
    return entity.number(60).value_or(0) == 1 || hidden_layers_.contains(lower_case(layer_of(entity)));
}

void DxfEntityReader::add(DxfPiece& piece, DxfLine line, const DxfEntity& entity) {
    // A flat object seen from below has its x axis to the left; lines, splines and ellipses have the drawing's.  (DXF
    // Reference, "Object Coordinate Systems")
    const bool is_flat = entity.type.ends_with("POLYLINE") || entity.type == "ARC" || entity.type == "CIRCLE";
    if (is_flat && entity.number(230).value_or(1) < 0) {
        for (Vec2d& p : line.points) p.x() = -p.x();
    }
    if (!std::ranges::all_of(line.points, is_dxf_place)) fail(entity, "a point is not a number, or too large");
    vertices_ += line.points.size();
    if (vertices_ > kMostDxfVertices) throw InputError(file_, "", "more than 2 million vertices");
    if (line.points.size() >= 2) piece.lines.push_back(std::move(line));
}

void DxfEntityReader::read_comments(const DxfEntity& entity, DxfPiece& piece) {
    constexpr int kComment = 999;
    for (const DxfGroup& group : entity.groups) {
        if (group.code != kComment || !group.value.starts_with("SELVEDGE ")) continue;
        piece.texts.push_back({.layer = kAnnotationLayer, .text = dxf_string(group.value)});
    }
}

std::size_t DxfEntityReader::read(const std::vector<DxfEntity>& all, std::size_t index, DxfPiece& piece) {
    const DxfEntity& entity = all[index];
    read_comments(entity, piece);
    if (entity.number(67).value_or(0) == 1) return 0;  // on a sheet of paper space, not in the drawing
    if (is_hidden(entity)) {
        ++hidden_;
        if (entity.type == "INSERT") {
            read_insert(entity, piece);
            piece.inserts.back().is_hidden = true;
        }
        if (entity.type != "POLYLINE") return 0;
        DxfPiece unseen;
        return read_polyline(all, index, unseen);
    }
    if (entity.type == "POLYLINE") return read_polyline(all, index, piece);
    if (entity.type == "LWPOLYLINE") {
        read_lwpolyline(entity, piece);
    } else if (entity.type == "LINE") {
        DxfLine line = line_of(entity);
        line.points = {point(entity, 10), point(entity, 11)};
        line.is_segment = true;
        add(piece, std::move(line), entity);
    } else if (entity.type == "POINT") {
        piece.points.emplace_back(dxf_layer_number(entity.text(8).value_or("")), point(entity, 10));
    } else if (entity.type == "TEXT" || entity.type == "MTEXT" || entity.type == "ATTRIB" || entity.type == "ATTDEF") {
        read_text(entity, piece);
    } else if (entity.type == "ARC" || entity.type == "CIRCLE") {
        read_arc(entity, piece);
    } else if (entity.type == "ELLIPSE") {
        read_ellipse(entity, piece);
    } else if (entity.type == "SPLINE") {
        read_spline(entity, piece);
    } else if (entity.type == "INSERT") {
        read_insert(entity, piece);
    } else if (entity.type != "SEQEND" && unknown_.emplace(std::string(entity.type), 0).second) {
        notes_.push_back("line " + std::to_string(entity.line) + ": " + std::string(entity.type) + " left out");
    }
    return 0;
}

std::size_t DxfEntityReader::read_polyline(const std::vector<DxfEntity>& all, std::size_t index, DxfPiece& piece) {
    std::vector<std::pair<Vec2d, double>> vertices;
    std::size_t taken = 0;
    for (std::size_t i = index + 1; i < all.size() && all[i].type == "VERTEX"; ++i) {
        constexpr unsigned kControlVertex = 16;
        const auto flags = static_cast<unsigned>(std::clamp(all[i].number(70).value_or(0), 0.0, 1e6));
        const bool is_control = (flags & kControlVertex) != 0;
        vertices.emplace_back(point(all[i], 10), is_control ? std::numeric_limits<double>::quiet_NaN()
                                                            : std::clamp(all[i].number(42).value_or(0), -1e3, 1e3));
        ++taken;
    }
    // In a spline fit, the vertices that only steer it.
    std::erase_if(vertices, [](const auto& vertex) { return std::isnan(vertex.second); });
    if (index + taken + 1 < all.size() && all[index + taken + 1].type == "SEQEND") ++taken;
    for (std::size_t i = index + 1; i <= index + taken; ++i) read_comments(all[i], piece);
    DxfLine line = line_of(all[index]);
    draw_vertices(vertices, closes(all[index]), line);
    add(piece, std::move(line), all[index]);
    return taken;
}

void DxfEntityReader::read_lwpolyline(const DxfEntity& entity, DxfPiece& piece) {
    std::vector<std::pair<Vec2d, double>> vertices;
    std::size_t heights = 0;
    for (const DxfGroup& group : entity.groups) {
        if (group.code == 10) vertices.emplace_back(Vec2d(coordinate(entity, group.value), 0), 0);
        if (vertices.empty()) continue;
        if (group.code == 20) vertices.back().first.y() = coordinate(entity, group.value);
        if (group.code == 42) vertices.back().second = std::clamp(dxf_number(group.value).value_or(0), -1e3, 1e3);
        heights += group.code == 20 ? 1 : 0;
    }
    if (heights != vertices.size()) fail(entity, "a vertex has no y");
    DxfLine line = line_of(entity);
    draw_vertices(vertices, closes(entity), line);
    add(piece, std::move(line), entity);
}

void DxfEntityReader::read_arc(const DxfEntity& entity, DxfPiece& piece) {
    const Vec2d centre = point(entity, 10);
    const double radius = entity.number(40).value_or(0);
    if (!(radius > 0) || radius > kLargestDxfNumber) fail(entity, "the radius is wrong");
    const bool is_circle = entity.type == "CIRCLE";
    const double from = is_circle ? 0 : std::fmod(entity.number(50).value_or(0), 360) * kDegree;
    double to = is_circle ? 2 * std::numbers::pi : std::fmod(entity.number(51).value_or(360), 360) * kDegree;
    if (to <= from) to += 2 * std::numbers::pi;
    const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / (3 * kDegree))));
    DxfLine line = line_of(entity);
    line.is_closed = is_circle;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        line.points.emplace_back(centre + radius * Vec2d(std::cos(angle), std::sin(angle)));
    }
    if (is_circle) line.points.back() = line.points.front();
    add(piece, std::move(line), entity);
}

// Around a centre, from the end of the long half axis; codes 41 and 42 are angles of the stretched circle.
void DxfEntityReader::read_ellipse(const DxfEntity& entity, DxfPiece& piece) {
    const Vec2d centre = point(entity, 10), along = point(entity, 11);
    const double ratio = std::clamp(entity.number(40).value_or(1), -1.0, 1.0);
    const double side = entity.number(230).value_or(1) < 0 ? -1 : 1;  // from which it is seen
    const Vec2d across = side * ratio * Vec2d(-along.y(), along.x());
    const double whole = 2 * std::numbers::pi;
    const double from = std::fmod(entity.number(41).value_or(0), whole);
    double to = std::clamp(entity.number(42).value_or(whole), -2 * whole, 2 * whole);
    while (to <= from) to += whole;
    to = std::min(to, from + whole);
    const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / (3 * kDegree))));
    DxfLine line = line_of(entity);
    constexpr double kSame = 1e-6;  // rad
    line.is_closed = to - from > whole - kSame;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        line.points.emplace_back(centre + std::cos(angle) * along + std::sin(angle) * across);
    }
    if (line.is_closed) line.points.back() = line.points.front();
    add(piece, std::move(line), entity);
}

// By its control points; where it has none, through its fit points.
void DxfEntityReader::read_spline(const DxfEntity& entity, DxfPiece& piece) {
    DxfLine line = line_of(entity);
    const std::vector<Vec2d> control = points(entity, 10);
    if (control.empty()) {
        std::vector<Vec2d> fit = points(entity, 11);
        if (fit.size() < 2) fail(entity, "it has neither control points nor fit points");
        line.is_closed = closes(entity) || (fit.size() > 2 && fit.front() == fit.back());
        if (line.is_closed && fit.front() != fit.back()) fit.push_back(fit.front());
        line.points = line_through(std::move(fit));
        return add(piece, std::move(line), entity);
    }
    std::vector<double> knots, weights;
    for (const DxfGroup& group : entity.groups) {
        if (group.code == 40) knots.push_back(coordinate(entity, group.value));
        if (group.code == 41) weights.push_back(coordinate(entity, group.value));
    }
    if (weights.size() != control.size()) weights.assign(control.size(), 1);
    if (!(std::ranges::min(weights) > 0)) fail(entity, "a weight is not more than 0");
    const auto degree = static_cast<std::size_t>(std::clamp(entity.number(71).value_or(3), 1.0, 10.0));
    if (control.size() <= degree || knots.size() != control.size() + degree + 1 || !std::ranges::is_sorted(knots))
        fail(entity, "its knots do not fit its control points");
    const double from = knots[degree], to = knots[control.size()];
    if (degree == 1) {
        line.points = control;
        line.is_closed = control.size() > 3 && control.front() == control.back();
        return add(piece, std::move(line), entity);
    }
    std::vector<Vec3d> weighted;
    for (std::size_t i = 0; i < control.size(); ++i)
        weighted.emplace_back(weights[i] * control[i].x(), weights[i] * control[i].y(), weights[i]);
    const std::size_t steps = std::min<std::size_t>(16 * control.size(), 20000);
    for (std::size_t i = 0; i <= steps; ++i) {
        const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(steps);
        line.points.push_back(spline_point(weighted, knots, degree, t));
    }
    line.is_closed = closes(entity) || (line.points.front() - line.points.back()).norm() == 0;
    if (line.is_closed) line.points.push_back(line.points.front());
    add(piece, std::move(line), entity);
}

void DxfEntityReader::read_text(const DxfEntity& entity, DxfPiece& piece) {
    DxfLayerText text{.layer = dxf_layer_number(entity.text(8).value_or("")), .text = {}};
    for (const DxfGroup& group : entity.groups) {
        if (group.code == 3 && entity.type == "MTEXT") text.text += dxf_string(group.value);
    }
    text.text += dxf_string(entity.text(1).value_or(""));
    if (entity.type == "MTEXT") text.text = plain_text(text.text);
    if (entity.text(10) && entity.text(20)) text.at = point(entity, 10);
    if (entity.type != "MTEXT" && entity.number(230).value_or(1) < 0) text.at.x() = -text.at.x();
    piece.texts.push_back(std::move(text));
}

void DxfEntityReader::read_insert(const DxfEntity& entity, DxfPiece& piece) {
    const auto factor = [&](int code) {
        const double value = entity.number(code).value_or(1);
        if (value == 0 || std::abs(value) > kLargestDxfNumber) fail(entity, "the scale is wrong");
        return value;
    };
    DxfInsert insert{.block = dxf_string(entity.text(2).value_or("")), .line = entity.line};
    const Vec2d to = entity.text(10) && entity.text(20) ? point(entity, 10) : Vec2d(0, 0);
    if (entity.number(230).value_or(1) < 0) insert.map.scale(Vec2d(-1, 1));
    insert.map.translate(to);
    insert.map.rotate(Eigen::Rotation2Dd(std::fmod(entity.number(50).value_or(0), 360) * kDegree));
    insert.map.scale(Vec2d(factor(41), factor(42)));
    piece.inserts.push_back(std::move(insert));
}

}  // namespace selvedge::sim
