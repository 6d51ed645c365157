#include "sim/body/tented.h"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

#include "sim/body/skin.h"

namespace selvedge::sim {
namespace {

// A surface and what is near each of its vertices.
class SmoothedSurface {
 public:
    SmoothedSurface(const std::vector<Vec3d>& x, const std::vector<std::array<int, 3>>& triangles)
        : x_(x), areas_(x.size(), Vec3d::Zero()), sizes_(x.size(), 0), beside_(x.size()), seen_by_(x.size(), 0) {
        for (const auto& t : triangles) {
            const auto at = [&](std::size_t k) { return std::size_t(t[k]); };
            const Vec3d area = (x[at(1)] - x[at(0)]).cross(x[at(2)] - x[at(0)]) / 6;
            for (std::size_t k = 0; k < 3; ++k) {
                areas_[at(k)] += area;
                sizes_[at(k)] += area.norm();
                beside_[at(k)].push_back(at((k + 1) % 3));  // closed: each edge once from both ends
            }
        }
    }

    const std::vector<std::size_t>& beside(std::size_t v) const { return beside_[v]; }

    // Where a vertex is when the surface is smoothed over kTentScale, and the normal there; without length where the
    // sides of a slender part cancel each other.
    struct Smooth {
        Vec3d x = Vec3d::Zero(), normal = Vec3d::Zero();
    };
    Smooth smooth(std::size_t v) {
        constexpr std::size_t kMost = 500;  // vertices: the surface of a scan is smoothed over less
        constexpr double kFlat = 0.5;       // least share of the area that is left of the sum of its normals
        near_.assign(1, v);
        seen_by_[v] = v + 1;
        Vec3d middle = Vec3d::Zero(), area = Vec3d::Zero();
        double size = 0;
        for (std::size_t i = 0; i < near_.size(); ++i) {
            const std::size_t u = near_[i];
            middle += sizes_[u] * x_[u];
            area += areas_[u];
            size += sizes_[u];
            for (const std::size_t next : beside_[u]) {
                if (near_.size() == kMost) break;
                if (seen_by_[next] == v + 1 || (x_[next] - x_[v]).norm() > kTentScale) continue;
                seen_by_[next] = v + 1;
                near_.push_back(next);
            }
        }
        if (!(size > 0)) return {.x = x_[v]};
        const bool is_flat = area.norm() > kFlat * size;
        return {.x = middle / size, .normal = is_flat ? Vec3d(area.normalized()) : Vec3d(Vec3d::Zero())};
    }

 private:
    const std::vector<Vec3d>& x_;
    std::vector<Vec3d> areas_;   // of a third of the triangles at each vertex, along their normals, m^2
    std::vector<double> sizes_;  // m^2
    std::vector<std::vector<std::size_t>> beside_;
    std::vector<std::size_t> seen_by_, near_;
};

// By how much each vertex is raised along its normal, m: from the highest downward, as distances grow round a source.
std::vector<double> raises(const std::vector<Vec3d>& x, const SmoothedSurface& surface,
                           const std::vector<SmoothedSurface::Smooth>& smooth) {
    std::vector<double> height(x.size()), raised(x.size());
    std::priority_queue<std::pair<double, std::size_t>> highest;
    for (std::size_t v = 0; v < x.size(); ++v) {
        height[v] = raised[v] = smooth[v].normal.dot(x[v] - smooth[v].x);
        if (smooth[v].normal.norm() > 0) highest.emplace(height[v], v);
    }
    while (!highest.empty()) {
        const auto [at, v] = highest.top();
        highest.pop();
        if (at < raised[v]) continue;
        for (const std::size_t next : surface.beside(v)) {
            if (!(smooth[next].normal.dot(smooth[v].normal) > 0)) continue;
            const double least = at - kTentSlope * (smooth[next].x - smooth[v].x).norm();
            if (least <= raised[next]) continue;
            raised[next] = least;
            highest.emplace(least, next);
        }
    }
    for (std::size_t v = 0; v < x.size(); ++v) raised[v] -= height[v];
    return raised;
}

}  // namespace

Body tented(const Body& body) {
    Body result = body;
    std::vector<Vec3d>& x = body.bind.empty() ? result.x : result.bind;
    SmoothedSurface surface(x, body.triangles);
    std::vector<SmoothedSurface::Smooth> smooth;
    for (std::size_t v = 0; v < x.size(); ++v) smooth.push_back(surface.smooth(v));
    const std::vector<double> raise = raises(x, surface, smooth);
    for (std::size_t v = 0; v < x.size(); ++v) x[v] += raise[v] * smooth[v].normal;
    if (!body.bind.empty()) result.x = skin(result, rest_pose(result));
    result.made_from.clear();  // of another surface
    return result;
}

}  // namespace selvedge::sim
