#include "sim/collide/penetration.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

#include "sim/core/edge_table.h"
#include "sim/core/parallel.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kGrain = 256;
// Cosine between the surface's normals where an edge enters and leaves: 120 degrees for an edge that is half a radius
// deep in a round limb. A chord that cuts a limb less deeply is a matter of the mesh's resolution.
constexpr float kOpposite = -0.5F;
constexpr float kAnyDistance = std::numeric_limits<float>::infinity();

struct Deepest {
    float depth = 0;  // m
    Vec3f at = Vec3f::Zero();

    void take(float other, const Vec3f& place) {
        if (other <= depth) return;
        depth = other;
        at = place;
    }
};

// A point with its signed distance from the surface, m.
struct Sample {
    Vec3f x = Vec3f::Zero();
    float distance = 0;
};

class Search {
 public:
    Search(std::span<const Vec3f> x, const SurfaceBvh& surface, const PenetrationOptions& options)
        : surface_(surface), options_(options) {
        samples_.resize(x.size());
        parallel_for(x.size(), kGrain, [&](std::size_t first, std::size_t last) {
            for (std::size_t v = first; v < last; ++v) samples_[v] = {x[v], distance(x[v])};
        });
    }

    const Sample& operator[](std::uint32_t v) const { return samples_[v]; }

    // Of an edge; sets `passes` if it passes through a part of the body.
    Deepest on_edge(const Sample& a, const Sample& b, bool& passes) const {
        Deepest deepest;
        for (const Sample& end : {a, b}) deepest.take(-end.distance, end.x);
        if (a.distance + b.distance >= (b.x - a.x).norm()) return deepest;
        const auto entry = surface_.first_hit(a.x, b.x);
        if (!entry && a.distance >= 0) return deepest;
        bisect(a, b, deepest);
        if (entry && a.distance > 0 && b.distance > 0 && deepest.depth > options_.depth) {
            const auto exit = surface_.first_hit(b.x, a.x);
            passes = exit && entry->normal.dot(exit->normal) < kOpposite;
        }
        return deepest;
    }

    Deepest in_face(const Sample& a, const Sample& b, const Sample& c) const {
        Deepest deepest;
        const float ab = (a.x - b.x).norm(), bc = (b.x - c.x).norm(), ca = (c.x - a.x).norm();
        const float clear =
            std::max({a.distance - std::max(ab, ca), b.distance - std::max(ab, bc), c.distance - std::max(bc, ca)});
        constexpr int kHalvings = 4;
        if (clear < -options_.depth) divide({a, b, c}, kHalvings, deepest);
        return deepest;
    }

 private:
    float distance(const Vec3f& x) const {
        const auto closest = surface_.closest(x, kAnyDistance);
        return closest ? closest->distance : kAnyDistance;
    }

    // The distance changes by no more than the way, so nothing between a and b is deeper than `most`.
    void bisect(const Sample& a, const Sample& b, Deepest& deepest) const {
        const float most = ((b.x - a.x).norm() - a.distance - b.distance) / 2;
        if (most <= std::max(deepest.depth, options_.depth) + options_.resolution) return;
        Sample middle{(a.x + b.x) / 2, 0};
        middle.distance = distance(middle.x);
        deepest.take(-middle.distance, middle.x);
        bisect(a, middle, deepest);
        bisect(middle, b, deepest);
    }

    void divide(const std::array<Sample, 3>& t, int halvings, Deepest& deepest) const {
        const Vec3f middle = (t[0].x + t[1].x + t[2].x) / 3;
        float radius = 0;
        for (const Sample& corner : t) radius = std::max(radius, (corner.x - middle).norm());
        const auto closest = surface_.closest(middle, radius + options_.depth);
        if (!closest) return;  // farther than its corners are
        deepest.take(-closest->distance, middle);
        const float known = std::max(deepest.depth, options_.depth) + options_.resolution;
        if (closest->distance - radius >= -known || halvings == 0) return;
        bool is_convex = true;
        float least = closest->distance;
        for (const Sample& corner : t) {
            const float linear = closest->distance + closest->normal.dot(corner.x - middle);
            least = std::min(least, linear);
            is_convex = is_convex && corner.distance >= linear - options_.resolution;
        }
        if (is_convex && least >= -known) return;
        std::array<Sample, 3> halves;
        for (std::size_t k = 0; k < 3; ++k) {
            halves[k].x = (t[k].x + t[(k + 1) % 3].x) / 2;
            halves[k].distance = distance(halves[k].x);
            deepest.take(-halves[k].distance, halves[k].x);
        }
        divide(halves, halvings - 1, deepest);
        for (std::size_t k = 0; k < 3; ++k) divide({t[k], halves[k], halves[(k + 2) % 3]}, halvings - 1, deepest);
    }

    const SurfaceBvh& surface_;
    const PenetrationOptions& options_;
    std::vector<Sample> samples_;
};

}  // namespace

Penetration find_penetration(std::span<const Vec3f> x, std::span<const std::array<std::uint32_t, 3>> triangles,
                             const SurfaceBvh& surface, const PenetrationOptions& options) {
    Penetration found;
    const Search search(x, surface, options);
    for (std::uint32_t v = 0; v < x.size(); ++v) {
        const float depth = -search[v].distance;
        if (depth <= 0) continue;
        ++found.vertices;
        if (depth <= found.deepest_vertex) continue;
        found.deepest_vertex = depth;
        found.vertex = v;
    }
    const EdgeTable<std::uint32_t> edges(triangles);
    std::vector<Deepest> on_edges(edges.size()), on_faces(triangles.size());
    std::vector<char> passes(edges.size(), 0);
    parallel_for(edges.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e) {
            bool is_passing = false;
            on_edges[e] = search.on_edge(search[edges[e][0].low], search[edges[e][0].high], is_passing);
            passes[e] = is_passing ? 1 : 0;
        }
    });
    parallel_for(triangles.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t) {
            const auto& [a, b, c] = triangles[t];
            on_faces[t] = search.in_face(search[a], search[b], search[c]);
        }
    });
    const auto take = [&](const Deepest& deepest, std::uint32_t triangle) {
        if (deepest.depth <= std::max(options.depth, found.deepest)) return;
        found.deepest = deepest.depth;
        found.at = deepest.at;
        found.triangle = triangle;
    };
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        take(on_faces[t], t);
        for (const std::uint32_t v : triangles[t]) on_faces[t].take(-search[v].distance, search[v].x);
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (on_edges[e].depth <= options.depth) continue;
        ++found.edges;
        const std::uint32_t first = edges[e].front().triangle;
        for (const std::uint32_t t : {first, edges[e].back().triangle})
            on_faces[t].take(on_edges[e].depth, on_edges[e].at);
        take(on_edges[e], first);
        if (passes[e] != 0) found.passing.push_back({first, on_edges[e].at, on_edges[e].depth});
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const auto& [depth, at] = on_faces[t];
        if (depth > options.depth) found.deep_faces.push_back({t, at, depth});
    }
    found.faces = static_cast<int>(found.deep_faces.size());
    return found;
}

}  // namespace selvedge::sim
