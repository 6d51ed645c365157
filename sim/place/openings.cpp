#include "sim/place/openings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "sim/core/edge_table.h"

namespace selvedge::sim {
namespace {

constexpr double kFar = 100;  // m, longer than any garment is away

// Bodies and garments are mirror images, so that lines and triangles often lie in the same plane. Shifted by this they
// do not.
const Vec3d kOffMirrorPlane(1.7e-4, 0.4e-4, -2.3e-4);  // m

struct BorderEdge {
    int from = 0;
    int to = 0;
    int panel = 0;
    double length = 0;  // m
};

// The edges with one triangle, in the triangle's direction, in the order of the triangles.
std::vector<BorderEdge> border_edges(const GarmentMesh& sewn) {
    const EdgeTable<int> table(sewn.triangles, &GarmentTriangle::vertices);
    std::vector<std::array<int, 2>> sides;  // triangle and corner
    for (const auto edge : table.edges()) {
        if (edge.size() == 1) sides.push_back({edge[0].triangle, edge[0].k});
    }
    std::ranges::sort(sides);
    std::vector<BorderEdge> border;
    for (const auto& [triangle, corner] : sides) {
        const GarmentTriangle& t = sewn.triangles[static_cast<std::size_t>(triangle)];
        const auto k = static_cast<std::size_t>(corner), next = (k + 1) % 3;
        border.push_back({t.vertices[k], t.vertices[next], t.panel, (t.u[next] - t.u[k]).norm()});
    }
    return border;
}

std::vector<int> panels_by_length(const std::vector<BorderEdge>& edges) {
    std::map<int, double> lengths;
    for (const BorderEdge& edge : edges) lengths[edge.panel] += edge.length;
    std::vector<std::pair<double, int>> sorted;
    for (const auto& [panel, length] : lengths) sorted.emplace_back(-length, panel);
    std::ranges::sort(sorted);
    std::vector<int> panels;
    for (const auto& entry : sorted) panels.push_back(entry.second);
    return panels;
}

}  // namespace

Vec3d centre_of(const Opening& opening, std::span<const Vec3d> x) {
    Vec3d sum = Vec3d::Zero();
    for (const int v : opening.vertices) sum += x[static_cast<std::size_t>(v)];
    return sum / static_cast<double>(opening.vertices.size());
}

std::vector<Opening> find_openings(const GarmentMesh& sewn) {
    const std::vector<BorderEdge> border = border_edges(sewn);
    std::multimap<int, std::size_t> leaving;
    for (std::size_t i = 0; i < border.size(); ++i) leaving.emplace(border[i].from, i);
    std::vector<Opening> openings;
    std::vector<bool> used(border.size(), false);
    for (std::size_t first = 0; first < border.size(); ++first) {
        std::vector<BorderEdge> loop;
        std::optional<std::size_t> at = first;
        while (at && !used[*at]) {
            used[*at] = true;
            loop.push_back(border[*at]);
            at.reset();
            const auto [begin, end] = leaving.equal_range(loop.back().to);
            for (auto next = begin; next != end && !at; ++next) {
                if (!used[next->second]) at = next->second;
            }
        }
        if (loop.empty() || loop.back().to != loop.front().from) continue;
        Opening opening{.vertices = {}, .panels = panels_by_length(loop), .length = 0};
        for (const BorderEdge& edge : loop) {
            opening.vertices.push_back(edge.from);
            opening.length += edge.length;
        }
        openings.push_back(std::move(opening));
    }
    return openings;
}

namespace {

struct Segment {
    Vec3d a;
    Vec3d b;
};

using Corners = std::array<Vec3d, 3>;

double volume(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    return (b - a).cross(c - a).dot(d - a);
}

// +1 where the segment crosses the triangle from its back to its front, -1 the other way, 0 where it misses it.
int crossing(const Segment& s, const Corners& t) {
    const double side_a = volume(t[0], t[1], t[2], s.a), side_b = volume(t[0], t[1], t[2], s.b);
    if ((side_a > 0) == (side_b > 0)) return 0;
    const bool first = volume(s.a, s.b, t[0], t[1]) > 0;
    if (first != (volume(s.a, s.b, t[1], t[2]) > 0) || first != (volume(s.a, s.b, t[2], t[0]) > 0)) return 0;
    return side_b > 0 ? 1 : -1;
}

// Where along the segment it crosses the triangle's plane, 0..1. Pre: it crosses it.
double crossing_share(const Segment& s, const Corners& t) {
    const Vec3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    return normal.dot(t[0] - s.a) / normal.dot(s.b - s.a);
}

// A garment's surface, and its openings spanned by triangles about their centres.
class Surface {
 public:
    Surface(const GarmentMesh& sewn, std::span<const Vec3d> x, std::span<const Opening> openings) {
        for (const GarmentTriangle& t : sewn.triangles) cloth_.push_back(corners(x, t.vertices));
        for (const Opening& opening : openings) {
            const auto point = [&](std::size_t i) {
                return x[static_cast<std::size_t>(opening.vertices[i % opening.vertices.size()])];
            };
            const Vec3d centre = centre_of(opening, x);
            std::vector<Corners>& span = spans_.emplace_back();
            for (std::size_t i = 0; i < opening.vertices.size(); ++i)
                span.push_back({centre, point(i + 1), point(i)});  // closes the surface: the other way round
        }
    }

    // Where the segment first meets the cloth, 0..1.
    std::optional<double> first_meeting(const Segment& segment) const {
        std::optional<double> first;
        for (const Corners& triangle : cloth_) {
            if (crossing(segment, triangle) == 0) continue;
            const double share = crossing_share(segment, triangle);
            if (!first || share < *first) first = share;
        }
        return first;
    }

    // Signed crossings with the span of an opening.
    int crossings(std::size_t opening, const Segment& segment) const {
        int sum = 0;
        for (const Corners& triangle : spans_[opening]) sum += crossing(segment, triangle);
        return sum;
    }

 private:
    static Corners corners(std::span<const Vec3d> x, const std::array<int, 3>& v) {
        return {x[static_cast<std::size_t>(v[0])], x[static_cast<std::size_t>(v[1])],
                x[static_cast<std::size_t>(v[2])]};
    }

    std::vector<Corners> cloth_;
    std::vector<std::vector<Corners>> spans_;  // per opening
};

bool is_leg(LimbKind kind) {
    return kind == LimbKind::LeftLeg || kind == LimbKind::RightLeg;
}

// Directions in which the line can go on beyond a limb's end without passing through the body, best first.
std::vector<Vec3d> ways_on(LimbKind kind, const std::vector<Vec3d>& line) {
    const double side = kind == LimbKind::LeftArm ? 1 : kind == LimbKind::RightArm ? -1 : 0;
    Vec3d best = (line.back() - line[line.size() - 2]).normalized();
    if (kind == LimbKind::Head) best = Vec3d::UnitZ();  // a hood is open in front
    std::vector<Vec3d> ways{best};
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                if (side * x < 0 || (is_leg(kind) && y > 0) || (kind == LimbKind::Head && y < 0)) continue;
                ways.push_back(Vec3d(x, y, z).normalized());
            }
        }
    }
    std::ranges::stable_sort(ways, [&](const Vec3d& a, const Vec3d& b) { return a.dot(best) > b.dot(best); });
    return ways;
}

// The line of a limb from the hips to infinity; nullopt if every way on from its end meets the cloth.
std::optional<std::vector<Vec3d>> line_to_infinity(const Surface& surface, const BodyLimbs& limbs, LimbKind kind,
                                                   const PassageOptions& options) {
    constexpr double kBeforeCloth = 0.5;  // of the way from the last joint to the cloth
    std::vector<Vec3d> line = line_to_end(limbs, kind);
    if (kind == LimbKind::Head) line.pop_back();  // from the middle of the head, not from its top
    // From within the foot, not from its sole: cloth may lie under it.
    if (is_leg(kind)) line.back() = (line.back() + line[line.size() - 2]) / 2;
    for (Vec3d& point : line) point += kOffMirrorPlane;
    for (std::size_t i = 1; i < line.size() && options.ends_at_cloth; ++i) {
        const auto meeting = surface.first_meeting({line[i - 1], line[i]});
        if (!meeting) continue;
        line[i] = line[i - 1] + kBeforeCloth * *meeting * (line[i] - line[i - 1]);
        line.resize(i + 1);
    }
    for (const Vec3d& way : ways_on(kind, line)) {
        const Vec3d end = line.back() + kFar * way + kOffMirrorPlane;
        if (surface.first_meeting({line.back(), end})) continue;
        line.push_back(end);
        return line;
    }
    return std::nullopt;
}

int linking_number(const Surface& surface, std::size_t opening, const std::vector<Vec3d>& line) {
    int sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += surface.crossings(opening, {line[i - 1], line[i]});
    return sum;
}

}  // namespace

// All lines start at the same point, so their linking numbers with an opening have a common offset, which depends on
// the spanning surface. The limbs with the larger number leave through the opening.
LimbPassages find_passages(const GarmentMesh& sewn, std::span<const Vec3d> x, std::span<const Opening> openings,
                           const BodyLimbs& limbs, const PassageOptions& options) {
    const Surface surface(sewn, x, openings);
    LimbPassages passages;
    std::array<std::vector<int>, kLimbCount> numbers;
    for (std::size_t limb = 0; limb < kLimbCount; ++limb) {
        if (!limbs.limbs[limb].is_found) continue;
        const auto line = line_to_infinity(surface, limbs, static_cast<LimbKind>(limb), options);
        if (!line) continue;
        passages.known.set(limb);
        for (std::size_t i = 0; i < openings.size(); ++i) numbers[limb].push_back(linking_number(surface, i, *line));
    }
    for (std::size_t i = 0; i < openings.size(); ++i) {
        LimbSet& through = passages.through.emplace_back();
        int least = std::numeric_limits<int>::max();
        for (std::size_t limb = 0; limb < kLimbCount; ++limb) {
            if (passages.known[limb]) least = std::min(least, numbers[limb][i]);
        }
        for (std::size_t limb = 0; limb < kLimbCount; ++limb)
            through[limb] = passages.known[limb] && numbers[limb][i] > least;
    }
    return passages;
}

}  // namespace selvedge::sim
