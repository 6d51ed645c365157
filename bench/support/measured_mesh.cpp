#include "bench/support/measured_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "sim/cloth/cloth.h"
#include "sim/core/assert.h"
#include "sim/core/math.h"

namespace selvedge::bench {
namespace {

constexpr double kAlongYarn = 1e-4;  // sine of the greatest angle between an edge and the yarn direction

bool is_along_yarn(const Vec2d& edge, double grain_angle) {
    const Vec2d warp(-std::sin(grain_angle), std::cos(grain_angle));
    const Vec2d along = edge.normalized();
    return std::min(std::abs(sim::cross2(warp, along)), std::abs(warp.dot(along))) < kAlongYarn;
}

const Vec3d& at(const std::vector<Vec3d>& x, int vertex) {
    return x[static_cast<std::size_t>(vertex)];
}

}  // namespace

void MeasuredMeshBuilder::add(const std::array<MeasuredCorner, 3>& corners, double grain_angle) {
    mesh_.triangles.push_back({corners[0].vertex, corners[1].vertex, corners[2].vertex});
    mesh_.rest_area += 0.5 * std::abs(sim::cross2(corners[1].u - corners[0].u, corners[2].u - corners[0].u));
    for (std::size_t k = 0; k < 3; ++k) {
        const MeasuredCorner& from = corners[k];
        const MeasuredCorner& to = corners[(k + 1) % 3];
        const Vec2d edge = to.u - from.u;
        const auto [a, b] = std::minmax(from.vertex, to.vertex);
        edges_.push_back({a, b, edge.norm(), is_along_yarn(edge, grain_angle)});
        mesh_.vertices.push_back(from.vertex);
    }
}

MeasuredMesh MeasuredMeshBuilder::finish() {
    std::ranges::sort(mesh_.vertices);
    mesh_.vertices.erase(std::unique(mesh_.vertices.begin(), mesh_.vertices.end()), mesh_.vertices.end());
    const auto ends = [](const Edge& e) { return std::tie(e.a, e.b); };
    std::ranges::stable_sort(edges_, {}, ends);
    edges_.erase(
        std::unique(edges_.begin(), edges_.end(),
                    [&](const auto& a, const auto& b) { return std::invoke(ends, a) == std::invoke(ends, b); }),
        edges_.end());
    for (const Edge& e : edges_) {
        if (e.is_yarn) mesh_.yarn_edges.push_back({e.a, e.b, e.rest_length});
    }
    return std::move(mesh_);
}

MeasuredMesh measured(const sim::GarmentMesh& mesh) {
    MeasuredMeshBuilder builder;
    for (const sim::GarmentTriangle& t : mesh.triangles) {
        builder.add({{{t.vertices[0], t.u[0]}, {t.vertices[1], t.u[1]}, {t.vertices[2], t.u[2]}}},
                    mesh.panel_grain_angles[static_cast<std::size_t>(t.panel)]);
    }
    return builder.finish();
}

YarnStretch yarn_stretch(const MeasuredMesh& mesh, const std::vector<Vec3d>& x) {
    std::vector<double> strains;
    strains.reserve(mesh.yarn_edges.size());
    for (const YarnEdge& e : mesh.yarn_edges) strains.push_back((at(x, e.b) - at(x, e.a)).norm() / e.rest_length - 1);
    return {.p1 = sim::quantile(strains, 0.01), .p99 = sim::quantile(strains, 0.99), .max = sim::quantile(strains, 1)};
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

namespace {

using Weights = std::array<double, 3>;

Weights barycentric(const sim::LeafTriangle& t, const Vec2d& u) {
    const Vec2d origin = t.u[0].cast<double>();
    const Vec2d e1 = t.u[1].cast<double>() - origin;
    const Vec2d e2 = t.u[2].cast<double>() - origin;
    const Vec2d d = u - origin;
    const double area = sim::cross2(e1, e2);
    const double w1 = sim::cross2(d, e2) / area;
    const double w2 = sim::cross2(e1, d) / area;
    return {1 - w1 - w2, w1, w2};
}

}  // namespace

Vec3d material_point(const sim::Cloth& cloth, int panel, const Vec2d& u) {
    double best = -std::numeric_limits<double>::infinity();
    Vec3d found = Vec3d::Zero();
    for (const sim::LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        if (t.panel != panel) continue;
        const Weights w = barycentric(t, u);
        const double least = *std::ranges::min_element(w);
        if (least <= best) continue;
        best = least;
        found.setZero();
        for (std::size_t k = 0; k < 3; ++k) found += w[k] * cloth.x[t.v[k].value].head<3>().cast<double>();
    }
    return found;
}

Vec3d mean_material_point(const sim::Cloth& cloth, int panel, const Vec2d& u, const Vec2d& v, int count) {
    Vec3d sum = Vec3d::Zero();
    for (int i = 0; i < count; ++i) sum += material_point(cloth, panel, u + (v - u) * (double(i) / (count - 1)));
    return sum / count;
}

double bias_stiffness(const sim::Fabric& fabric) {
    return 4 / (1 / fabric.stretch_warp + 1 / fabric.stretch_weft + 1 / fabric.shear);
}

double bias_strain(const sim::Fabric& fabric, double force) {
    double shear = force / (2 * fabric.shear);  // rad
    for (int i = 0; i < 50; ++i) shear = force * (std::cos(shear / 2) - std::sin(shear / 2)) / (2 * fabric.shear);
    const double turned = std::cos(shear / 2) + std::sin(shear / 2) - 1;
    return turned + force / 4 * (1 / fabric.stretch_warp + 1 / fabric.stretch_weft);
}

}  // namespace selvedge::bench
