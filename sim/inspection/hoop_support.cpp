#include "sim/inspection/hoop_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "sim/core/gravity.h"
#include "sim/core/math.h"
#include "sim/inspection/cloth_neighbours.h"

namespace selvedge::sim {
namespace {

// Per vertex, m; infinite where the cloth is not connected with the edge.
std::vector<double> distances_from(const GarmentMesh& mesh, const Opening& edge) {
    std::vector<double> distances(mesh.x.size(), std::numeric_limits<double>::infinity());
    for (const auto& [v, distance] : distances_along(cloth_neighbours(mesh), edge.vertices)) distances[v] = distance;
    return distances;
}

// Extension per force and length of a strip in that direction, m/N (Jones 1975, eq. 2.97, without Poisson's ratio).
double compliance_along(const Vec2d& direction, double grain_angle, const Fabric& fabric) {
    const double warp = direction.dot(Vec2d(-std::sin(grain_angle), std::cos(grain_angle))) / direction.norm();
    const double along = warp * warp, across = 1 - along;
    return along * along / fabric.stretch_warp + across * across / fabric.stretch_weft + along * across / fabric.shear;
}

// Adds what a triangle has of the row. A vertex in the row counts as above it.
void add_triangle(HoopRow& row, const GarmentTriangle& t, const std::vector<double>& distances, double grain_angle,
                  const Fabric& fabric) {
    std::array<Vec2d, 2> ends{Vec2d::Zero(), Vec2d::Zero()};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const double a = distances[static_cast<std::size_t>(t.vertices[k])] - row.distance;
        const double b = distances[static_cast<std::size_t>(t.vertices[next])] - row.distance;
        if ((a > 0) == (b > 0)) continue;
        ends[found++] = t.u[k] + a / (a - b) * (t.u[next] - t.u[k]);
    }
    const Vec2d segment = ends[1] - ends[0];
    if (found < 2 || segment.norm() == 0) return;
    row.length += segment.norm();
    row.compliance += segment.norm() * compliance_along(segment, grain_angle, fabric);
    row.limit += segment.norm() * fabric.strain_limit;
}

}  // namespace

std::vector<HoopRow> hoop_rows(const GarmentMesh& sewn, const Opening& edge, std::span<const Fabric> fabrics) {
    const std::vector<double> distances = distances_from(sewn, edge);
    double farthest = 0;
    for (const double distance : distances) {
        if (std::isfinite(distance)) farthest = std::max(farthest, distance);
    }
    std::vector<HoopRow> rows;
    for (double at = kHoopRowHeight / 2; at < farthest; at += kHoopRowHeight) {
        HoopRow row{.distance = at};
        for (const GarmentTriangle& t : sewn.triangles) {
            if (!std::isfinite(distances[static_cast<std::size_t>(t.vertices[0])])) continue;
            const auto panel = static_cast<std::size_t>(t.panel);
            add_triangle(row, t, distances, sewn.panel_grain_angles[panel], fabrics[panel]);
        }
        rows.push_back(row);
    }
    return rows;
}

double weight_below(const GarmentMesh& sewn, const Opening& edge, std::span<const Fabric> fabrics) {
    const std::vector<double> distances = distances_from(sewn, edge);
    double mass = 0;
    for (const GarmentTriangle& t : sewn.triangles) {
        if (!std::isfinite(distances[static_cast<std::size_t>(t.vertices[0])])) continue;
        const double area = std::abs(cross2(t.u[1] - t.u[0], t.u[2] - t.u[0])) / 2;
        mass += area * fabrics[static_cast<std::size_t>(t.panel)].area_density;
    }
    return kGravity * mass;
}

double largest_hoop_support(std::span<const HoopRow> rows, const GirthAtHeight& girth, double friction, double low,
                            double high) {
    constexpr double kStep = 0.01;  // m, between heights of the edge and of the girths of which a slope is made
    double largest = 0;
    for (double top = low; top <= high; top += kStep) {
        double carried = 0, steepest = 0;
        for (const HoopRow& row : rows) {
            const double y = top - row.distance, extension = std::min(girth(y) - row.length, row.limit);
            if (extension <= 0) continue;
            const double slope = (girth(y - kStep) - girth(y + kStep)) / (2 * kStep) / (2 * std::numbers::pi);
            const double held = std::max(0.0, slope + friction) / std::max(1 - friction * slope, 0.1);
            carried += 2 * std::numbers::pi * extension / row.compliance * kHoopRowHeight * held;
            steepest = std::max(steepest, slope);
        }
        largest = std::max(largest, carried * std::exp(friction * std::atan(steepest)));
    }
    return largest;
}

}  // namespace selvedge::sim
