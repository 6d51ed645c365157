// Table 4.1: finding points in a grid and in an octree of the same depth.
#include <cmath>
#include <random>

#include "bench/thesis/point_structures.h"
#include "bench/thesis/thesis.h"
#include "bench/timing.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

std::vector<Vec3f> random_points(std::size_t count) {
    std::mt19937 random(1);
    const auto draw = [&] { return static_cast<float>(random() >> 8) * 0x1p-24F; };
    std::vector<Vec3f> points;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = draw(), y = draw(), z = draw();
        points.emplace_back(x, y, z);
    }
    return points;
}

// The middle of the unit cube that has this share of its volume.
Cube middle_of(double share) {
    const auto side = static_cast<float>(std::cbrt(share));
    return {.low = Vec3f::Constant(0.5F * (1 - side)), .side = side};
}

template <class Structure>
std::size_t count_found(const Structure& structure, const std::vector<Vec3f>& points) {
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) found += structure.find(points[i]) == i ? 1 : 0;
    return found;
}

void add_row(Table& table, const std::vector<Vec3f>& points, double share, int runs) {
    const Cube cube = middle_of(share);
    const PointGrid grid(points, cube);
    const PointOctree octree(points, cube);
    SELVEDGE_ASSERT(count_found(grid, points) == grid.size() && count_found(octree, points) == octree.size());
    std::vector<double> by_grid, by_octree, grid_built, octree_built;
    for (int i = 0; i < runs; ++i) {
        by_grid.push_back(time_once([&] { keep(count_found(grid, points)); }));
        by_octree.push_back(time_once([&] { keep(count_found(octree, points)); }));
        grid_built.push_back(time_once([&] { keep(PointGrid(points, cube)); }));
        octree_built.push_back(time_once([&] { keep(PointOctree(points, cube)); }));
    }
    const double grid_ms = 1e3 * timing_of(by_grid).median, octree_ms = 1e3 * timing_of(by_octree).median;
    table.add_row({Cell(share, 4), grid.size(), octree.size(), Cell(grid_ms, 3), Cell(octree_ms, 3),
                   Cell(octree_ms / grid_ms, 1), Cell(1e3 * timing_of(grid_built).median, 2),
                   Cell(1e3 * timing_of(octree_built).median, 2), grid.bytes(), octree.bytes()});
}

}  // namespace

ThesisResult measure_point_search(const ThesisOptions& options) {
    const std::vector<Vec3f> points = random_points(options.is_quick ? 512 : 32768);
    Table table{
        .name = "4.1",
        .title = "Finding " + std::to_string(points.size()) + " random points of a cube in a grid and an octree",
        .note =
            "Both cover the middle of the cube, of so much of its volume, and hold the points there: a grid "
            "of 32 x 32 x 32 cells, an octree of at most 5 levels below its root. All points are looked "
            "for; those outside are turned away at the border. ms, median of runs.",
        .columns = {"share of the volume", "points in the grid", "points in the octree", "grid, ms", "octree, ms",
                    "octree / grid", "grid built, ms", "octree built, ms", "grid, bytes", "octree, bytes"}};
    for (const double share : {1.0, 0.5, 0.25, 0.125, 1.0 / 16, 1.0 / 64})
        add_row(table, points, share, options.is_quick ? 1 : 21);
    ThesisResult result;
    result.tables = {table};
    return result;
}

}  // namespace selvedge
