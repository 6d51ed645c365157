#include "sim/mesh/relax.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sim/mesh/delaunay.h"
#include "sim/mesh/planar.h"

namespace selvedge {
namespace {

constexpr double kGoodAngle = 35 * std::numbers::pi / 180;  // rad
constexpr double kWorthMoving = 1e-6;                       // rad, of a smallest angle: less is no gain
constexpr std::size_t kTriedTriangles = 6;  // the worst ones: beyond them repairs hardly lower the penalty
constexpr double kHelps = 0.98;             // times the penalty: less, and a repair is kept
constexpr int kMostTries = 150;             // triangulations spent on repairs of one panel

using Triangle = std::array<int, 3>;

const Vec2d& point_of(const PlanarMesh& mesh, int vertex) {
    return mesh.points[static_cast<std::size_t>(vertex)];
}

double angle_of(const PlanarMesh& mesh, const Triangle& t) {
    return smallest_angle(point_of(mesh, t[0]), point_of(mesh, t[1]), point_of(mesh, t[2]));
}

std::span<const Vec2d> outline_of(const PlanarMesh& mesh) {
    return std::span(mesh.points).first(mesh.outline_count);
}

// The mesh over other interior points; nothing when they do not all become vertices of it.
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

// Centroids of the triangles about each interior point, weighted by area over wanted area: small where it is graded.
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
        if (is_inside(moved, outline_of(mesh))) points[i] = moved;
    }
    return points;
}

using Stars = std::vector<std::vector<int>>;  // per vertex, its triangles

Stars stars_of(const PlanarMesh& mesh) {
    Stars stars(mesh.points.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int vertex : mesh.triangles[t]) stars[static_cast<std::size_t>(vertex)].push_back(static_cast<int>(t));
    }
    return stars;
}

// The smallest angle about a vertex; negative when a triangle is turned over.
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

// Pattern search for the place where the smallest angle about one vertex is largest.
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

// Keeps the mesh over the given points if it is better.
bool take_if_better(PlanarMesh& mesh, std::vector<Vec2d> points) {
    auto moved = triangulate_anew(std::move(points), mesh.outline_count);
    if (!moved || angle_penalty(*moved) >= angle_penalty(mesh)) return false;
    mesh = std::move(*moved);
    return true;
}

void sharpen(PlanarMesh& mesh, const SizeField& size, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        if (!take_if_better(mesh, sharpened_points(mesh, size))) break;
    }
}

// The triangles with angles below the good one, worst first, ties in their order.
std::vector<int> bad_triangles(const PlanarMesh& mesh) {
    std::vector<std::pair<double, int>> bad;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const double angle = angle_of(mesh, mesh.triangles[i]);
        if (angle < kGoodAngle) bad.emplace_back(angle, static_cast<int>(i));
    }
    std::ranges::sort(bad);
    std::vector<int> order;
    for (const auto& [angle, index] : bad) order.push_back(index);
    return order;
}

// One triangle's cures: without each of its interior points, or with one more at its centre or at a longest edge.
std::vector<std::vector<Vec2d>> cures_of(const PlanarMesh& mesh, const Triangle& triangle) {
    std::vector<std::vector<Vec2d>> cures;
    for (int vertex : triangle) {
        if (static_cast<std::size_t>(vertex) < mesh.outline_count) continue;
        cures.push_back(mesh.points);
        cures.back().erase(cures.back().begin() + vertex);
    }
    const std::array<Vec2d, 3> p{point_of(mesh, triangle[0]), point_of(mesh, triangle[1]), point_of(mesh, triangle[2])};
    for (const Vec2d& extra : {Vec2d((p[0] + p[1] + p[2]) / 3), Vec2d((p[0] + p[1]) / 2), Vec2d((p[1] + p[2]) / 2),
                               Vec2d((p[2] + p[0]) / 2)}) {
        if (!is_inside(extra, outline_of(mesh))) continue;
        cures.push_back(mesh.points);
        cures.back().push_back(extra);
    }
    return cures;
}

// Makes the first cure that helps; counts the tries down.
bool repair_one(PlanarMesh& mesh, const SizeField& size, int& tries_left) {
    const double penalty = angle_penalty(mesh);
    std::vector<int> bad = bad_triangles(mesh);
    if (bad.size() > kTriedTriangles) bad.resize(kTriedTriangles);
    for (int index : bad) {
        const Triangle triangle = mesh.triangles[static_cast<std::size_t>(index)];
        for (std::vector<Vec2d>& points : cures_of(mesh, triangle)) {
            if (tries_left-- <= 0) return false;
            auto cured = triangulate_anew(std::move(points), mesh.outline_count);
            if (!cured) continue;
            sharpen(*cured, size, 3);
            if (angle_penalty(*cured) >= kHelps * penalty) continue;
            mesh = std::move(*cured);
            return true;
        }
    }
    return false;
}

}  // namespace

double angle_penalty(const PlanarMesh& mesh) {
    double penalty = 0;
    for (const Triangle& t : mesh.triangles) {
        const double lack = std::max(0.0, kGoodAngle - angle_of(mesh, t));
        penalty += lack * lack * lack;
    }
    return penalty;
}

void relax(PlanarMesh& mesh, const SizeField& size, int rounds) {
    PlanarMesh moving = mesh;  // Lloyd may get worse before it gets better
    for (int round = 0; round < rounds; ++round) {
        auto moved = triangulate_anew(lloyd_points(moving, size), mesh.outline_count);
        if (!moved) break;
        moving = std::move(*moved);
        if (angle_penalty(moving) < angle_penalty(mesh)) mesh = moving;
    }
    sharpen(mesh, size, rounds);
}

void heal(PlanarMesh& mesh, const SizeField& size) {
    int tries_left = kMostTries;
    while (repair_one(mesh, size, tries_left)) {
    }
}

}  // namespace selvedge
