#include "sim/cloth/contact_guard.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace selvedge::sim {

Vec3f ContactGuard::middle_of(EdgeId e) const {
    return 0.5F * (at(mesh_.end(e, 0)) + at(mesh_.end(e, 1)));
}

Vec3f ContactGuard::centre_of(EdgeId e) const {
    return mesh_.is_split(e) ? at(mesh_.centre(e)) : middle_of(e);
}

// With all three edges split, a triangle has no median; with two, the median to one of them. The larger of the
// exchanges from or to either.
float ContactGuard::exchange_of_medians(const AdaptiveTriangle& triangle, std::size_t changed) const {
    float largest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        const std::size_t i = (changed + k) % 3, j = (changed + 3 - k) % 3;
        const Vec3f across = centre_of(triangle.edges[i]) + at(triangle.vertices[(i + 2) % 3]) -
                             centre_of(triangle.edges[j]) - middle_of(triangle.edges[changed]);
        largest = std::max(largest, 0.5F * across.norm());
    }
    return largest;
}

// The median that a triangle with one split edge has stays when a second one is split.
float ContactGuard::exchange_of_split(TriangleId t, EdgeId e) const {
    const AdaptiveTriangle& triangle = mesh_.triangle(t);
    const std::size_t changed = index_of(triangle, e);
    const bool has_two =
        mesh_.is_split(triangle.edges[(changed + 1) % 3]) && mesh_.is_split(triangle.edges[(changed + 2) % 3]);
    return has_two ? exchange_of_medians(triangle, changed) : 0;
}

// With one edge left, the median may be exchanged for that to the other edge. They cross at the centroid, two thirds of
// the way to the centre.
float ContactGuard::exchange_of_rejoin(TriangleId t, EdgeId e) const {
    const AdaptiveTriangle& triangle = mesh_.triangle(t);
    const std::size_t changed = index_of(triangle, e);
    const EdgeId second = triangle.edges[(changed + 1) % 3], third = triangle.edges[(changed + 2) % 3];
    if (mesh_.is_split(second) && mesh_.is_split(third)) return exchange_of_medians(triangle, changed);
    const float off = (centre_of(second) - middle_of(second)).norm() + (centre_of(third) - middle_of(third)).norm();
    return 2.0F / 3.0F * off;
}

float ContactGuard::way_of_rejoin(EdgeId e) const {
    float exchange = 0;
    for (const TriangleId t : mesh_.edge(e).sides) {
        if (t) exchange = std::max(exchange, exchange_of_rejoin(t, e));
    }
    return (centre_of(e) - middle_of(e)).norm() + exchange;
}

bool ContactGuard::permits_rejoin(EdgeId e) const {
    return clearances_.empty() || is_free(patch_of(e), way_of_rejoin(e));
}

void ContactGuard::note_split(EdgeId e) {
    if (clearances_.empty()) return;
    float way = 0;
    for (const TriangleId t : mesh_.edge(e).sides) {
        if (t) way = std::max(way, exchange_of_split(t, e));
    }
    spend(e, way);
}

void ContactGuard::note_rejoin(EdgeId e) {
    if (!clearances_.empty()) spend(e, way_of_rejoin(e));
}

ContactGuard::Patch ContactGuard::patch_of(EdgeId e) const {
    Patch patch;
    const auto add = [&](VertexId v) {
        const std::span<const std::uint32_t> all = patch.all();
        if (v.value >= clearances_.size() || std::ranges::find(all, v.value) != all.end()) return;
        patch.vertices[patch.count++] = v.value;
    };
    for (const TriangleId t : mesh_.edge(e).sides) {
        if (!t) continue;
        for (const VertexId v : mesh_.triangle(t).vertices) add(v);
        for (const EdgeId edge : mesh_.triangle(t).edges) {
            if (mesh_.is_split(edge)) add(mesh_.centre(edge));
        }
    }
    return patch;
}

bool ContactGuard::is_free(const Patch& patch, float way) const {
    return std::ranges::all_of(patch.all(), [&](std::uint32_t v) { return clearances_[v] >= way; });
}

void ContactGuard::spend(EdgeId e, float way) {
    if (way <= 0) return;
    const Patch patch = patch_of(e);
    is_doubtful_ = is_doubtful_ || !is_free(patch, way);
    for (const std::uint32_t v : patch.all()) clearances_[v] = std::max(0.0F, clearances_[v] - way);
}

}  // namespace selvedge::sim
