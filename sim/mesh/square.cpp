#include "sim/mesh/square.h"

#include <cstddef>
#include <vector>

#include "sim/core/assert.h"
#include "sim/core/math.h"

namespace selvedge::sim {
namespace {

GarmentTriangle make_triangle(const std::vector<Vec2d>& u, int a, int b, int c) {
    const auto at = [&](int v) { return u[static_cast<std::size_t>(v)]; };
    return {.vertices = {a, b, c}, .u = {at(a), at(b), at(c)}, .panel = 0};
}

std::vector<Vec2d> grid_points(const SquareOptions& options) {
    std::vector<Vec2d> u;
    for (int row = 0; row <= options.rows; ++row) {
        for (int column = 0; column <= options.columns; ++column) {
            u.emplace_back(options.width * column / options.columns, options.depth * row / options.rows);
        }
    }
    return u;
}

}  // namespace

GarmentMesh make_square(const SquareOptions& options) {
    SELVEDGE_ASSERT(options.columns >= 1 && options.rows >= 1);
    const std::vector<Vec2d> u = grid_points(options);
    GarmentMesh mesh;
    for (const Vec2d& p : u) mesh.x.emplace_back(p.x() - options.width / 2, options.height, options.depth / 2 - p.y());
    for (int row = 0; row < options.rows; ++row) {
        for (int column = 0; column < options.columns; ++column) {
            const int a = row * (options.columns + 1) + column;
            const int b = a + 1;
            const int c = b + options.columns + 1;
            const int d = c - 1;
            const bool rises = (row + column) % 2 == 0;
            mesh.triangles.push_back(rises ? make_triangle(u, a, b, c) : make_triangle(u, a, b, d));
            mesh.triangles.push_back(rises ? make_triangle(u, a, c, d) : make_triangle(u, b, c, d));
        }
    }
    mesh.panel_names = {"square"};
    mesh.panel_grain_angles = {0.0};
    return mesh;
}

}  // namespace selvedge::sim
