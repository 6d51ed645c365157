#include "bench/dense_body.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/body/mannequin.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

std::vector<Vec3d> vertex_normals(const Body& body) {
    std::vector<Vec3d> normals(body.x.size(), Vec3d::Zero());
    const auto at = [&](int v) { return body.x[std::size_t(v)]; };
    for (const auto& [a, b, c] : body.triangles)
        for (const int v : {a, b, c}) normals[std::size_t(v)] += (at(b) - at(a)).cross(at(c) - at(a));
    for (Vec3d& normal : normals) normal.stableNormalize();
    return normals;
}

// An edge and the triangles on both its sides, each with the place of the edge's first corner in it.
struct SharedEdge {
    double length = 0;
    int low = 0, high = 0;
    std::array<std::size_t, 2> triangle{};
    std::array<std::size_t, 2> corner{};
};

std::vector<SharedEdge> longest_first(const Body& body) {
    struct Side {
        int low, high;
        std::size_t triangle, corner;
    };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < body.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(body.triangles[t][k], body.triangles[t][(k + 1) % 3]);
            sides.push_back({low, high, t, k});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    std::vector<SharedEdge> edges;
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const Side& a = sides[i];
        const Side& b = sides[i + 1];
        SELVEDGE_ASSERT(a.low == b.low && a.high == b.high);
        const double length = (body.x[std::size_t(a.low)] - body.x[std::size_t(a.high)]).norm();
        edges.push_back({length, a.low, a.high, {a.triangle, b.triangle}, {a.corner, b.corner}});
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const SharedEdge& a, const SharedEdge& b) { return a.length > b.length; });
    return edges;
}

// The middle of the edge, moved out as far as the normals at its ends bend. (Vlachos et al. 2001)
Vec3d bent_middle(const Body& body, const std::vector<Vec3d>& normals, const SharedEdge& edge) {
    const Vec3d& a = body.x[std::size_t(edge.low)];
    const Vec3d& b = body.x[std::size_t(edge.high)];
    const Vec3d& at_a = normals[std::size_t(edge.low)];
    const Vec3d& at_b = normals[std::size_t(edge.high)];
    const Vec3d along = b - a;
    return (a + b) / 2 + (at_a * along.dot(at_a) - at_b * along.dot(at_b)) / 8;
}

// Both triangles become two.
void split(Body& body, const SharedEdge& edge, const Vec3d& middle) {
    const int m = int(body.x.size());
    body.x.push_back(middle);
    for (std::size_t side = 0; side < 2; ++side) {
        std::array<int, 3>& half = body.triangles[edge.triangle[side]];
        std::array<int, 3> other = half;
        half[(edge.corner[side] + 1) % 3] = m;
        other[edge.corner[side]] = m;
        body.triangles.push_back(other);
    }
}

// Splits the longest edges, none of them in a triangle that this round has split already.
void split_round(Body& body, std::size_t triangles) {
    const std::vector<Vec3d> normals = vertex_normals(body);
    std::vector<bool> is_split(body.triangles.size(), false);
    for (const SharedEdge& edge : longest_first(body)) {
        if (body.triangles.size() + 2 > triangles) return;
        if (is_split[edge.triangle[0]] || is_split[edge.triangle[1]]) continue;
        is_split[edge.triangle[0]] = is_split[edge.triangle[1]] = true;
        split(body, edge, bent_middle(body, normals, edge));
    }
}

}  // namespace

Body dense_body(std::size_t triangles) {
    constexpr std::array<std::size_t, 3> kResolutions{17184, 68736, 274944};
    SELVEDGE_ASSERT(triangles >= kResolutions.front());
    const auto above = std::upper_bound(kResolutions.begin(), kResolutions.end(), triangles);
    Body body = make_mannequin({.subdivisions = int(above - kResolutions.begin())}).body;
    body.bones.clear();
    body.skin.clear();
    while (body.triangles.size() + 2 <= triangles) split_round(body, triangles);
    return body;
}

}  // namespace selvedge
