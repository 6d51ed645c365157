#include "bench/thesis/point_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "bench/support/cloth_run.h"
#include "bench/thesis/thesis.h"
#include "sim/core/assert.h"

namespace selvedge::bench {
namespace {

// The index of the child that contains the cell, among the eight children of a node at `depth`.
std::uint32_t octant(const std::array<std::uint32_t, 3>& cell, int depth) {
    const int shift = kPointDepth - 1 - depth;
    return ((cell[0] >> shift) & 1U) | ((cell[1] >> shift) & 1U) << 1 | ((cell[2] >> shift) & 1U) << 2;
}

// Morton code: the octants from the root down, three bits each. The cells of a node have consecutive codes.
std::uint32_t code_of(const std::array<std::uint32_t, 3>& cell) {
    std::uint32_t code = 0;
    for (int depth = 0; depth < kPointDepth; ++depth) code = code << 3 | octant(cell, depth);
    return code;
}

template <class Entry>
std::uint32_t search(const Entry* first, const Entry* last, const Vec3f& p) {
    for (; first != last; ++first) {
        if (first->x == p) return first->index;
    }
    return kNoPoint;
}

}  // namespace

std::array<std::uint32_t, 3> Cube::cell(const Vec3f& p) const {
    const Vec3f at = (p - low) * (static_cast<float>(kPointSide) / side);
    const auto along = [&](int axis) { return std::min(static_cast<std::uint32_t>(at[axis]), kPointSide - 1); };
    return {along(0), along(1), along(2)};
}

PointGrid::PointGrid(std::span<const Vec3f> points, const Cube& cube)
    : cube_(cube), first_(std::size_t{kPointSide} * kPointSide * kPointSide + 1, 0) {
    for (const Vec3f& p : points)
        if (cube.contains(p)) ++first_[cell_of(p) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    points_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < points.size(); ++i)
        if (cube.contains(points[i])) points_[next[cell_of(points[i])]++] = {points[i], i};
}

std::size_t PointGrid::cell_of(const Vec3f& p) const {
    const auto cell = cube_.cell(p);
    return (std::size_t{cell[2]} * kPointSide + cell[1]) * kPointSide + cell[0];
}

std::uint32_t PointGrid::find(const Vec3f& p) const {
    if (!cube_.contains(p)) return kNoPoint;
    const std::size_t cell = cell_of(p);
    return search(points_.data() + first_[cell], points_.data() + first_[cell + 1], p);
}

std::size_t PointGrid::bytes() const {
    return first_.size() * sizeof(first_[0]) + points_.size() * sizeof(Entry);
}

PointOctree::PointOctree(std::span<const Vec3f> points, const Cube& cube) : cube_(cube) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // code, index
    for (std::uint32_t i = 0; i < points.size(); ++i)
        if (cube.contains(points[i])) order.emplace_back(code_of(cube.cell(points[i])), i);
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> codes;
    for (const auto& [code, index] : order) {
        codes.push_back(code);
        points_.push_back({points[index], index});
    }
    nodes_.push_back({0, 0, static_cast<std::uint32_t>(points_.size())});
    divide(0, 0, codes);
}

void PointOctree::divide(std::uint32_t node, int depth, std::vector<std::uint32_t>& codes) {
    if (depth == kPointDepth || nodes_[node].count <= 1) return;
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].children = children;
    std::uint32_t at = nodes_[node].first;
    const std::uint32_t end = at + nodes_[node].count;
    const int shift = 3 * (kPointDepth - 1 - depth);
    for (std::uint32_t child = 0; child < 8; ++child) {
        const std::uint32_t first = at;
        while (at < end && ((codes[at] >> shift) & 7U) == child) ++at;
        nodes_.push_back({0, first, at - first});
    }
    for (std::uint32_t child = 0; child < 8; ++child) divide(children + child, depth + 1, codes);
}

std::uint32_t PointOctree::find(const Vec3f& p) const {
    if (!cube_.contains(p)) return kNoPoint;
    const auto cell = cube_.cell(p);
    const Node* node = nodes_.data();
    for (int depth = 0; node->children != 0; ++depth) node = &nodes_[node->children + octant(cell, depth)];
    return search(points_.data() + node->first, points_.data() + node->first + node->count, p);
}

std::size_t PointOctree::bytes() const {
    return nodes_.size() * sizeof(Node) + points_.size() * sizeof(Entry);
}

// Table 4.1: search for points in a grid and in an octree of the same resolution.

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

// The cube at the centre of the unit cube with this share of its volume.
Cube middle_cube(double share) {
    const auto side = static_cast<float>(std::cbrt(share));
    return {.low = Vec3f::Constant(0.5F * (1 - side)), .side = side};
}

template <class Structure>
std::size_t count_found(const Structure& structure, const std::vector<Vec3f>& points) {
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) found += structure.find(points[i]) == i ? 1 : 0;
    return found;
}

// Returns by how much the octree is slower than the grid.
double add_row(Table& table, const std::vector<Vec3f>& points, double share, int runs) {
    const Cube cube = middle_cube(share);
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
    return octree_ms / grid_ms;
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
    constexpr double kNoise = 0.95;  // where few points are inside, both mostly turn points away
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const double share : {1.0, 0.5, 0.25, 0.125, 1.0 / 16, 1.0 / 64}) {
        const double slower = add_row(table, points, share, options.is_quick ? 1 : 21);
        least = std::min(least, slower);
        most = std::max(most, slower);
    }
    return {.tables = {table},
            .trends = {{.item = "T4.1",
                        .reported = "the grid was chosen for collision.",
                        .measured = "the octree takes " + Cell(least, 1).to_text() + " to " + Cell(most, 1).to_text() +
                                    " times as long as the grid.",
                        .agrees = least > kNoise && most > 1}}};
}

}  // namespace selvedge::bench
