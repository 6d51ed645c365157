#include "bench/support/measured_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sim/core/quantile.h"

namespace selvedge {
namespace {

constexpr double kAlongThread = 1e-4;  // sine of the angle to a thread

bool is_along_thread(const Vec2d& edge, double grain_angle) {
    const Vec2d warp(-std::sin(grain_angle), std::cos(grain_angle));
    const Vec2d along = edge.normalized();
    return std::min(std::abs(cross2(warp, along)), std::abs(warp.dot(along))) < kAlongThread;
}

const Vec3d& at(const std::vector<Vec3d>& x, int vertex) {
    return x[static_cast<std::size_t>(vertex)];
}

}  // namespace

void MeasuredMeshBuilder::add(const std::array<MeasuredCorner, 3>& corners, double grain_angle) {
    mesh_.triangles.push_back({corners[0].vertex, corners[1].vertex, corners[2].vertex});
    mesh_.rest_area += 0.5 * std::abs(cross2(corners[1].u - corners[0].u, corners[2].u - corners[0].u));
    for (std::size_t k = 0; k < 3; ++k) {
        const MeasuredCorner& from = corners[k];
        const MeasuredCorner& to = corners[(k + 1) % 3];
        const Vec2d edge = to.u - from.u;
        const auto [a, b] = std::minmax(from.vertex, to.vertex);
        edges_.push_back({a, b, edge.norm(), is_along_thread(edge, grain_angle)});
        mesh_.vertices.push_back(from.vertex);
    }
}

MeasuredMesh MeasuredMeshBuilder::finish() {
    std::ranges::sort(mesh_.vertices);
    mesh_.vertices.erase(std::ranges::unique(mesh_.vertices).begin(), mesh_.vertices.end());
    const auto ends = [](const Edge& e) { return std::tie(e.a, e.b); };
    std::ranges::stable_sort(edges_, {}, ends);
    edges_.erase(std::ranges::unique(edges_, {}, ends).begin(), edges_.end());
    for (const Edge& e : edges_) {
        if (e.is_thread) mesh_.threads.push_back({e.a, e.b, e.rest_length});
    }
    return std::move(mesh_);
}

MeasuredMesh measured(const GarmentMesh& mesh) {
    MeasuredMeshBuilder builder;
    for (const GarmentTriangle& t : mesh.triangles) {
        builder.add({{{t.vertices[0], t.u[0]}, {t.vertices[1], t.u[1]}, {t.vertices[2], t.u[2]}}},
                    mesh.panel_grain_angles[static_cast<std::size_t>(t.panel)]);
    }
    return builder.finish();
}

ThreadStretch thread_stretch(const MeasuredMesh& mesh, const std::vector<Vec3d>& x) {
    std::vector<double> strains;
    strains.reserve(mesh.threads.size());
    for (const ThreadEdge& e : mesh.threads) strains.push_back((at(x, e.b) - at(x, e.a)).norm() / e.rest_length - 1);
    return {.p1 = quantile(strains, 0.01), .p99 = quantile(strains, 0.99), .max = quantile(strains, 1)};
}

double area_ratio(const MeasuredMesh& mesh, const std::vector<Vec3d>& x) {
    double area = 0;
    for (const auto& t : mesh.triangles)
        area += 0.5 * (at(x, t[1]) - at(x, t[0])).cross(at(x, t[2]) - at(x, t[0])).norm();
    return area / mesh.rest_area;
}

bool all_finite(const MeasuredMesh& mesh, const std::vector<Vec3d>& x) {
    return std::ranges::all_of(mesh.vertices, [&](int v) { return at(x, v).allFinite(); });
}

ShapeDistance shape_distance(const MeasuredMesh& mesh, const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
    ShapeDistance distance;
    for (const int v : mesh.vertices) {
        distance.mean += (at(a, v) - at(b, v)).norm();
        distance.rms += (at(a, v) - at(b, v)).squaredNorm();
    }
    const auto count = static_cast<double>(mesh.vertices.size());
    return {.mean = distance.mean / count, .rms = std::sqrt(distance.rms / count)};
}

}  // namespace selvedge
