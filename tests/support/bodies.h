#pragma once
// Closed test surfaces (box, sphere), a body cut at a height, and simple checks of a body's surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "sim/body/body.h"

namespace selvedge::sim::shapes {

// Axis-aligned box from low to high; each face is divided into cells x cells squares.
inline Body box(const Vec3d& low, const Vec3d& high, int cells) {
    Body body;
    std::map<std::array<int, 3>, int> vertices;
    const auto vertex = [&](const std::array<int, 3>& grid) {
        const auto [found, is_new] = vertices.try_emplace(grid, int(body.x.size()));
        if (is_new) {
            const Vec3d t = Vec3d(grid[0], grid[1], grid[2]) / cells;
            body.x.emplace_back(low + (high - low).cwiseProduct(t));
        }
        return found->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int side : {0, cells})
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    const auto at = [&](int di, int dj) {
                        std::array<int, 3> grid{};
                        grid[axis] = side;
                        grid[(axis + 1) % 3] = i + di;
                        grid[(axis + 2) % 3] = j + dj;
                        return vertex(grid);
                    };
                    std::array<int, 4> square{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
                    if (side == 0) std::swap(square[1], square[3]);
                    body.triangles.push_back({square[0], square[1], square[2]});
                    body.triangles.push_back({square[0], square[2], square[3]});
                }
    return body;
}

// A cube's grid projected onto the sphere.
inline Body sphere(const Vec3d& centre, double radius, int cells) {
    Body body = box(Vec3d::Constant(-1), Vec3d::Constant(1), cells);
    for (Vec3d& p : body.x) p = centre + radius * p.normalized();
    return body;
}

inline double box_distance(const Vec3d& p, const Vec3d& low, const Vec3d& high) {
    const Vec3d outside = (low - p).cwiseMax(p - high);
    return outside.cwiseMax(0).norm() + std::min(outside.maxCoeff(), 0.0);
}

// Whether every directed edge occurs once and so does its opposite.
inline bool is_closed(const Body& body) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& triangle : body.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[{triangle[k], triangle[(k + 1) % 3]}];
    return !uses.empty() && std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
        return use.second == 1 && uses.contains({use.first.second, use.first.first});
    });
}

// m^3; positive when the surface has outward orientation.
inline double volume(const Body& body) {
    double sum = 0;
    for (const auto& [a, b, c] : body.triangles)
        sum += body.x[std::size_t(a)].dot(body.x[std::size_t(b)].cross(body.x[std::size_t(c)])) / 6;
    return sum;
}

// The surfaces of both bodies in one body.
inline Body together(const Body& first, const Body& second) {
    Body body = first;
    const int offset = int(first.x.size());
    body.x.insert(body.x.end(), second.x.begin(), second.x.end());
    for (const auto& [a, b, c] : second.triangles) body.triangles.push_back({a + offset, b + offset, c + offset});
    return body;
}

enum class Side { Below, Above };

// The part of a closed body on one side of the level y, m; the cut is closed. Pre: no vertex lies at the level.
inline Body cut(const Body& body, double y, Side side) {
    Body part;
    std::map<std::pair<int, int>, int> vertices;  // by the edge's ends; equal for an own vertex
    const auto is_kept = [&](int v) { return (body.x[std::size_t(v)].y() < y) == (side == Side::Below); };
    const auto vertex = [&](int a, int b) {
        const auto [found, is_new] = vertices.try_emplace(std::minmax(a, b), int(part.x.size()));
        const Vec3d &from = body.x[std::size_t(a)], &to = body.x[std::size_t(b)];
        if (is_new)
            part.x.push_back(a == b ? from : Vec3d(from + (to - from) * ((y - from.y()) / (to.y() - from.y()))));
        return found->second;
    };
    std::vector<std::array<int, 2>> rim;
    for (const auto& triangle : body.triangles) {
        std::vector<int> polygon;
        std::array<int, 2> opening{-1, -1};  // where the outline leaves the part, and where it returns
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle[k], b = triangle[(k + 1) % 3];
            if (is_kept(a)) polygon.push_back(vertex(a, a));
            if (is_kept(a) == is_kept(b)) continue;
            polygon.push_back(vertex(a, b));
            opening[is_kept(a) ? 0 : 1] = polygon.back();
        }
        for (std::size_t k = 2; k < polygon.size(); ++k)
            part.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
        if (opening[0] >= 0) rim.push_back(opening);
    }
    Vec3d centre = Vec3d::Zero();
    for (const auto& [leaves, returns] : rim) centre += part.x[std::size_t(leaves)] / double(rim.size());
    for (const auto& [leaves, returns] : rim) part.triangles.push_back({returns, leaves, int(part.x.size())});
    if (!rim.empty()) part.x.push_back(centre);
    return part;
}

}  // namespace selvedge::sim::shapes
