#include "sim/mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/mesh/delaunay.h"
#include "sim/mesh/outline_tree.h"
#include "sim/mesh/sample_outline.h"

namespace selvedge::sim {
namespace {

// The outline of a panel, and the target edge length at each point within it: the spacing of the samples on the
// outline, increasing with the distance from it up to target_edge.
class SizeField {
 public:
    // target_edge: m. Pre: outline is not empty; it stays valid.
    SizeField(std::span<const Vec2d> outline, double target_edge);
    double at(const Vec2d& point) const;  // m
    double smallest() const;              // m, minimum over the outline
    const OutlineTree& outline() const { return outline_; }

 private:
    OutlineTree outline_;
    double target_edge_;
};

// Position and direction of the hexagonal grid; several are tried and the best mesh is kept.
struct GridPose {
    double along = 0;        // shift along the rows, in edge lengths
    double across = 0;       // shift across the rows, in row heights
    bool is_turned = false;  // rows run along y instead of x
};

// The initial interior points: on hexagonal grids with a minimum distance from the outline and from each other, finer
// where the outline is sampled finely. target_edge: m.
std::vector<Vec2d> place_interior_points(std::span<const Vec2d> outline, const SizeField& size, double target_edge,
                                         const GridPose& pose);

// A triangulation during optimisation: outline points first, then interior points. Only interior points change.
struct PlanarMesh {
    std::vector<Vec2d> points;
    std::size_t outline_count = 0;
    std::vector<std::array<int, 3>> triangles;
};

// Quality measure, lower is better: the sum over all triangles of max(0, 35 degrees - smallest angle)^3, in rad^3. The
// cube makes a few bad triangles count more than many moderate ones.
double angle_penalty(const PlanarMesh& mesh);

// Smooths the mesh. First `iterations` Lloyd iterations: each interior point moves to the weighted centroid of its
// triangles; the iteration with the lowest penalty is kept. Then at most `iterations` iterations that move points of
// bad triangles to where the smallest angle is largest, until the penalty no longer decreases. Retriangulates after
// each iteration.
void relax(PlanarMesh& mesh, const SizeField& size, int iterations);

// Removes or adds single interior points at the worst triangles if that lowers the penalty.
void heal(PlanarMesh& mesh, const SizeField& size);

constexpr std::array<GridPose, 6> kPoses{
    {{0, 0, false}, {0.5, 0.5, false}, {0.25, 0.75, false}, {0, 0, true}, {0.5, 0.5, true}, {0.25, 0.75, true}}};

// How many of `count` tries a panel gets: all if its outline has no more points than kFullOutline, else fewer, so that
// the work stays the same. Garments have outlines of some hundred points.
std::size_t affordable(std::size_t count, std::size_t outline_points, std::size_t all_points) {
    constexpr std::size_t kFullOutline = 1000;
    if (outline_points <= kFullOutline) return count;
    return std::max<std::size_t>(1, count * kFullOutline / all_points);
}

[[noreturn]] void refuse(const Panel& panel, const std::string& problem) {
    throw InputError("", "panel '" + panel.name + "'", problem);
}

// The outline edge that a sample's segment belongs to.
int edge_of(const SampledOutline& outline, int sample) {
    int edge = 0;
    for (std::size_t i = 0; i < outline.runs.size(); ++i) {
        if (outline.runs[i].first <= sample) edge = static_cast<int>(i);
    }
    return edge;
}

void require_chain(const Panel& panel) {
    const auto vertex_count = static_cast<int>(panel.vertices.size());
    if (panel.edges.empty()) refuse(panel, "the outline has no edges");
    for (std::size_t i = 0; i < panel.edges.size(); ++i) {
        const OutlineEdge& edge = panel.edges[i];
        if (edge.start < 0 || edge.start >= vertex_count || edge.end < 0 || edge.end >= vertex_count) {
            refuse(panel, "edge " + std::to_string(i) + " has no such end vertex");
        }
        if (edge.end != panel.edges[(i + 1) % panel.edges.size()].start) {
            refuse(panel, "the outline is open after edge " + std::to_string(i));
        }
    }
}

void require_simple(const Panel& panel, const SampledOutline& outline) {
    for (const Vec2d& p : outline.points) {
        if (!p.allFinite()) refuse(panel, "the outline has a coordinate that is no finite number");
    }
    if (outline.points.size() < 3) refuse(panel, "the outline has fewer than three corners");
    if (const auto crossing = find_crossing(outline.points)) {
        const std::string first = std::to_string(edge_of(outline, crossing->first));
        if (crossing->first == crossing->second) refuse(panel, "edge " + first + " has no length");
        refuse(panel, "the outline crosses itself: edges " + first + " and " +
                          std::to_string(edge_of(outline, crossing->second)));
    }
}

double signed_area(const std::vector<Vec2d>& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) twice += cross2(outline[i], outline[(i + 1) % outline.size()]);
    return twice / 2;
}

void require_affordable(const Panel& panel, const std::vector<Vec2d>& outline, const TriangulateOptions& options) {
    const double triangle = std::numbers::sqrt3 / 4 * options.target_edge * options.target_edge;
    const double needed = std::abs(signed_area(outline)) / triangle + static_cast<double>(outline.size());
    if (needed > options.max_triangles) {
        refuse(panel, "about " + std::to_string(std::llround(needed)) + " triangles would be needed, more than " +
                          std::to_string(options.max_triangles) + ": are the units right?");
    }
}

std::optional<PlanarMesh> start_mesh(const std::vector<Vec2d>& outline, const std::vector<Vec2d>& interior) {
    auto triangles = delaunay_inside(outline, interior);
    if (!triangles) return std::nullopt;
    PlanarMesh mesh{outline, outline.size(), std::move(*triangles)};
    mesh.points.insert(mesh.points.end(), interior.begin(), interior.end());
    return mesh;
}

// The mesh with the lowest angle penalty over several grid poses, then repaired.
PlanarMesh best_mesh(const Panel& panel, const std::vector<Vec2d>& outline, const TriangulateOptions& options) {
    const SizeField size(outline, options.target_edge);
    std::optional<PlanarMesh> best;
    double least = std::numeric_limits<double>::infinity();  // penalty of `best`
    for (const GridPose& pose : std::span(kPoses).first(affordable(kPoses.size(), outline.size(), outline.size()))) {
        if (least == 0) break;
        auto mesh = start_mesh(outline, place_interior_points(outline, size, options.target_edge, pose));
        if (!mesh) continue;
        const auto relaxations = static_cast<std::size_t>(std::max(0, options.relaxations));
        relax(*mesh, size, static_cast<int>(affordable(relaxations, outline.size(), mesh->points.size())));
        const double penalty = angle_penalty(*mesh);
        if (best && penalty >= least) continue;
        best = std::move(mesh);
        least = penalty;
    }
    if (!best) refuse(panel, "the outline runs clockwise, or it crosses or pinches itself in a point");
    if (options.relaxations > 0) heal(*best, size);
    return std::move(*best);
}

// Asserts that each outline segment is an edge of exactly one triangle, so that the samples of a seam's two sides
// match.
void check_outline_kept(const PlanarMesh& mesh) {
    std::vector<int> uses(mesh.outline_count, 0);
    const auto count = static_cast<int>(mesh.outline_count);
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = triangle[k];
            if (from < count && triangle[(k + 1) % 3] == (from + 1) % count) ++uses[static_cast<std::size_t>(from)];
        }
    }
    for (int use : uses) SELVEDGE_ASSERT(use == 1);
}

}  // namespace

PanelMesh triangulate(const Panel& panel, const std::vector<int>& segments, const TriangulateOptions& options) {
    require_chain(panel);
    SampledOutline outline = sample_outline(panel, segments);
    weld(outline.points);
    require_simple(panel, outline);
    require_affordable(panel, outline.points, options);
    PlanarMesh mesh = best_mesh(panel, outline.points, options);
    check_outline_kept(mesh);

    PanelMesh result{std::move(mesh.points), std::move(mesh.triangles), {}, std::move(outline.runs)};
    for (std::size_t i = 0; i < mesh.outline_count; ++i) result.outline.push_back(static_cast<int>(i));
    return result;
}

namespace {

constexpr double kGrowth = 0.35;        // increase of the target length per distance from the outline, m/m
constexpr double kOffOutline = 0.6;     // minimum distance of a point from the outline / target length
constexpr double kOffNeighbours = 0.8;  // minimum distance between points / target length
constexpr double kMaxSizeRatio = 1.8;   // of the target length at a point that a level places / the level's edge length
constexpr int kMaxLevels = 5;           // of the grid, each with half the spacing of the previous one

struct Box {
    Vec2d low;
    Vec2d high;
};

Box box_of(std::span<const Vec2d> points) {
    Box box{points[0], points[0]};
    for (const Vec2d& p : points) {
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
    }
    return box;
}

// The points of a hexagonal grid that covers the box, row by row.
std::vector<Vec2d> hexagonal_grid(const Box& box, double edge, const GridPose& pose) {
    const Vec2d extent = pose.is_turned ? Vec2d((box.high - box.low).reverse()) : Vec2d(box.high - box.low);
    const double row_height = edge * std::numbers::sqrt3 / 2;
    const int rows = static_cast<int>(extent.y() / row_height) + 2;
    const int columns = static_cast<int>(extent.x() / edge) + 2;
    std::vector<Vec2d> points;
    for (int row = -1; row < rows; ++row) {
        for (int column = -1; column < columns; ++column) {
            const Vec2d p((column + pose.along + (row % 2 == 0 ? 0.0 : 0.5)) * edge, (row + pose.across) * row_height);
            points.push_back(box.low + (pose.is_turned ? Vec2d(p.reverse()) : p));
        }
    }
    return points;
}

// Points in square cells, each as long as the largest distance that is asked for.
class PointGrid {
 public:
    PointGrid(const Vec2d& origin, double cell) : origin_(origin), cell_(cell) {}

    void add(const Vec2d& point) { cells_[cell_of(point)].push_back(point); }

    // Whether a point is closer than `distance`. Pre: distance <= the length of a cell.
    bool has_closer(const Vec2d& point, double distance) const {
        const Cell at = cell_of(point);
        for (const std::int64_t x : {at.first - 1, at.first, at.first + 1}) {
            for (const std::int64_t y : {at.second - 1, at.second, at.second + 1}) {
                const auto cell = cells_.find({x, y});
                if (cell == cells_.end()) continue;
                const bool is_closer = std::ranges::any_of(cell->second, [&](const Vec2d& other) {
                    return (other - point).squaredNorm() < distance * distance;
                });
                if (is_closer) return true;
            }
        }
        return false;
    }

 private:
    using Cell = std::pair<std::int64_t, std::int64_t>;

    Cell cell_of(const Vec2d& point) const {
        const Vec2d cell = (point - origin_) / cell_;
        return {static_cast<std::int64_t>(std::floor(cell.x())), static_cast<std::int64_t>(std::floor(cell.y()))};
    }

    Vec2d origin_;
    double cell_;
    std::map<Cell, std::vector<Vec2d>> cells_;
};

// The geometric mean of a sample's two segments: where a short segment meets a long one, it gives better angles than
// the arithmetic mean.
std::vector<double> spacing_of(std::span<const Vec2d> outline) {
    std::vector<double> spacing;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2d& before = outline[(i + outline.size() - 1) % outline.size()];
        const Vec2d& after = outline[(i + 1) % outline.size()];
        spacing.push_back(std::sqrt((outline[i] - before).norm() * (after - outline[i]).norm()));
    }
    return spacing;
}

SizeField::SizeField(std::span<const Vec2d> outline, double target_edge)
    : outline_(outline, spacing_of(outline)), target_edge_(target_edge) {}

double SizeField::at(const Vec2d& point) const {
    return outline_.lowest(point, kGrowth, target_edge_);
}

double SizeField::smallest() const {
    return std::min(target_edge_, *std::ranges::min_element(outline_.heights()));
}

std::vector<Vec2d> place_interior_points(std::span<const Vec2d> outline, const SizeField& size, double target_edge,
                                         const GridPose& pose) {
    const Box box = box_of(outline);
    std::vector<Vec2d> placed;
    double edge = target_edge;
    for (int level = 0; level < kMaxLevels; ++level) {
        const double longest = kMaxSizeRatio * edge;  // a coarser level has covered the points where more is wanted
        PointGrid neighbours(box.low, kOffNeighbours * longest * 1.001);
        for (const Vec2d& point : placed) neighbours.add(point);
        for (const Vec2d& point : hexagonal_grid(box, edge, pose)) {
            if (!size.outline().is_inside(point)) continue;
            const double wanted = size.at(point);
            if (wanted > longest) continue;
            if (size.outline().is_closer(point, kOffOutline * wanted)) continue;
            if (neighbours.has_closer(point, kOffNeighbours * wanted)) continue;
            placed.push_back(point);
            neighbours.add(point);
        }
        if (edge < 1.2 * size.smallest()) break;
        edge /= 2;
    }
    return placed;
}

constexpr double kGoodAngle = 35 * std::numbers::pi / 180;  // rad
constexpr double kWorthMoving = 1e-6;                       // rad, minimum gain in the smallest angle
constexpr std::size_t kTriedTriangles = 6;  // only the worst: repairs of others hardly lower the penalty
constexpr double kMaxPenaltyRatio = 0.98;   // a repair is kept if new penalty / old penalty is below this
constexpr int kMaxTriangulations = 150;     // maximum number of triangulations for the repairs of one panel

using Triangle = std::array<int, 3>;

const Vec2d& point_of(const PlanarMesh& mesh, int vertex) {
    return mesh.points[static_cast<std::size_t>(vertex)];
}

double angle_of(const PlanarMesh& mesh, const Triangle& t) {
    return smallest_angle(point_of(mesh, t[0]), point_of(mesh, t[1]), point_of(mesh, t[2]));
}

// A new triangulation of the points; nullopt if it fails or if a point is not a vertex of it.
std::optional<PlanarMesh> triangulate_anew(std::vector<Vec2d> points, std::size_t outline_count) {
    const std::span all(points);
    auto triangles = delaunay_inside(all.first(outline_count), all.subspan(outline_count));
    if (!triangles) return std::nullopt;
    std::vector<bool> is_used(points.size(), false);
    for (const Triangle& t : *triangles) {
        for (int vertex : t) is_used[static_cast<std::size_t>(vertex)] = true;
    }
    if (std::ranges::find(is_used, false) != is_used.end()) return std::nullopt;
    return PlanarMesh{std::move(points), outline_count, std::move(*triangles)};
}

// Moves each interior point to the mean of the centroids of its triangles, weighted by area / (target length)^2, so
// that the grading of triangle sizes is kept. Points that would leave the outline stay.
std::vector<Vec2d> lloyd_points(const PlanarMesh& mesh, const SizeField& size) {
    std::vector<Vec2d> sum(mesh.points.size(), Vec2d::Zero());
    std::vector<double> weights(mesh.points.size(), 0.0);
    for (const Triangle& t : mesh.triangles) {
        const Vec2d centre = (point_of(mesh, t[0]) + point_of(mesh, t[1]) + point_of(mesh, t[2])) / 3;
        const double area =
            cross2(point_of(mesh, t[1]) - point_of(mesh, t[0]), point_of(mesh, t[2]) - point_of(mesh, t[0]));
        const double wanted = size.at(centre);
        for (int vertex : t) {
            sum[static_cast<std::size_t>(vertex)] += area / (wanted * wanted) * centre;
            weights[static_cast<std::size_t>(vertex)] += area / (wanted * wanted);
        }
    }
    std::vector<Vec2d> points = mesh.points;
    for (std::size_t i = mesh.outline_count; i < points.size(); ++i) {
        const Vec2d moved = sum[i] / weights[i];
        if (size.outline().is_inside(moved)) points[i] = moved;
    }
    return points;
}

using Stars = std::vector<std::vector<int>>;  // per vertex: indices of its triangles

Stars stars_of(const PlanarMesh& mesh) {
    Stars stars(mesh.points.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int vertex : mesh.triangles[t]) stars[static_cast<std::size_t>(vertex)].push_back(static_cast<int>(t));
    }
    return stars;
}

// The smallest angle in the triangles around a vertex, rad; -1 if one of them is inverted or degenerate.
double star_quality(const PlanarMesh& mesh, const std::vector<int>& star) {
    double worst = std::numbers::pi;
    for (int index : star) {
        const Triangle& t = mesh.triangles[static_cast<std::size_t>(index)];
        const Vec2d& a = point_of(mesh, t[0]);
        if (cross2(point_of(mesh, t[1]) - a, point_of(mesh, t[2]) - a) <= 0) return -1;
        worst = std::min(worst, angle_of(mesh, t));
    }
    return worst;
}

// Pattern search for the position that maximises the smallest angle in the triangles around one vertex.
void sharpen_vertex(PlanarMesh& mesh, std::size_t vertex, const std::vector<int>& star, double wanted) {
    double best = star_quality(mesh, star);
    if (best >= kGoodAngle) return;
    for (double step = 0.2 * wanted; step > 0.01 * wanted;) {
        const Vec2d start = mesh.points[vertex];
        Vec2d better = start;
        for (int k = 0; k < 8; ++k) {
            const double angle = k * std::numbers::pi / 4;
            mesh.points[vertex] = start + step * Vec2d(std::cos(angle), std::sin(angle));
            const double quality = star_quality(mesh, star);
            if (quality <= best + kWorthMoving) continue;
            best = quality;
            better = mesh.points[vertex];
        }
        mesh.points[vertex] = better;
        if (better == start) step /= 2;
    }
}

std::vector<Vec2d> sharpened_points(const PlanarMesh& mesh, const SizeField& size) {
    PlanarMesh moved = mesh;
    const Stars stars = stars_of(mesh);
    for (std::size_t i = mesh.outline_count; i < mesh.points.size(); ++i) {
        sharpen_vertex(moved, i, stars[i], size.at(mesh.points[i]));
    }
    return moved.points;
}

// Replaces the mesh by a triangulation of the given points if that has a lower penalty.
bool take_if_better(PlanarMesh& mesh, std::vector<Vec2d> points) {
    auto moved = triangulate_anew(std::move(points), mesh.outline_count);
    if (!moved || angle_penalty(*moved) >= angle_penalty(mesh)) return false;
    mesh = std::move(*moved);
    return true;
}

void sharpen(PlanarMesh& mesh, const SizeField& size, int iterations) {
    for (int i = 0; i < iterations; ++i) {
        if (!take_if_better(mesh, sharpened_points(mesh, size))) break;
    }
}

// The triangles whose smallest angle is below kGoodAngle, worst first, ties by index.
std::vector<int> bad_triangles(const PlanarMesh& mesh) {
    std::vector<std::pair<double, int>> bad;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const double angle = angle_of(mesh, mesh.triangles[i]);
        if (angle < kGoodAngle) bad.emplace_back(angle, static_cast<int>(i));
    }
    std::ranges::sort(bad);
    std::vector<int> order;
    order.reserve(bad.size());
    for (const auto& [angle, index] : bad) order.push_back(index);
    return order;
}

// Point sets that may repair a triangle: each without one of its interior vertices, or with one more point at its
// centroid or at the midpoint of one of its edges.
std::vector<std::vector<Vec2d>> repairs_of(const PlanarMesh& mesh, const Triangle& triangle,
                                           const OutlineTree& outline) {
    std::vector<std::vector<Vec2d>> cures;
    for (int vertex : triangle) {
        if (static_cast<std::size_t>(vertex) < mesh.outline_count) continue;
        cures.push_back(mesh.points);
        cures.back().erase(cures.back().begin() + vertex);
    }
    const std::array<Vec2d, 3> p{point_of(mesh, triangle[0]), point_of(mesh, triangle[1]), point_of(mesh, triangle[2])};
    for (const Vec2d& extra : {Vec2d((p[0] + p[1] + p[2]) / 3), Vec2d((p[0] + p[1]) / 2), Vec2d((p[1] + p[2]) / 2),
                               Vec2d((p[2] + p[0]) / 2)}) {
        if (!outline.is_inside(extra)) continue;
        cures.push_back(mesh.points);
        cures.back().push_back(extra);
    }
    return cures;
}

// Applies the first repair that lowers the penalty enough. Decrements tries_left per try. Returns whether it applied
// one.
bool repair_one(PlanarMesh& mesh, const SizeField& size, int& tries_left) {
    const double penalty = angle_penalty(mesh);
    std::vector<int> bad = bad_triangles(mesh);
    if (bad.size() > kTriedTriangles) bad.resize(kTriedTriangles);
    for (int index : bad) {
        const Triangle triangle = mesh.triangles[static_cast<std::size_t>(index)];
        for (std::vector<Vec2d>& points : repairs_of(mesh, triangle, size.outline())) {
            if (tries_left-- <= 0) return false;
            auto cured = triangulate_anew(std::move(points), mesh.outline_count);
            if (!cured) continue;
            sharpen(*cured, size, 3);
            if (angle_penalty(*cured) >= kMaxPenaltyRatio * penalty) continue;
            mesh = std::move(*cured);
            return true;
        }
    }
    return false;
}

double angle_penalty(const PlanarMesh& mesh) {
    double penalty = 0;
    for (const Triangle& t : mesh.triangles) {
        const double lack = std::max(0.0, kGoodAngle - angle_of(mesh, t));
        penalty += lack * lack * lack;
    }
    return penalty;
}

void relax(PlanarMesh& mesh, const SizeField& size, int iterations) {
    PlanarMesh moving = mesh;  // the penalty may increase before it decreases
    double least = angle_penalty(mesh);
    for (int i = 0; i < iterations && least > 0; ++i) {
        auto moved = triangulate_anew(lloyd_points(moving, size), mesh.outline_count);
        if (!moved) break;
        moving = std::move(*moved);
        const double penalty = angle_penalty(moving);
        if (penalty >= least) continue;
        mesh = moving;
        least = penalty;
    }
    if (least > 0) sharpen(mesh, size, iterations);
}

void heal(PlanarMesh& mesh, const SizeField& size) {
    int tries_left = static_cast<int>(affordable(kMaxTriangulations, mesh.outline_count, mesh.points.size()));
    while (repair_one(mesh, size, tries_left)) {
    }
}

}  // namespace
}  // namespace selvedge::sim
