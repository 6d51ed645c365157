#include "sim/selfcontact/untangle.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {
namespace {

constexpr float kRewindShare = 0.7F;  // of the way back, per iteration: neighbouring crossings move the same vertices
constexpr float kLongestRewind = 5e-3F;  // m, per vertex and iteration
constexpr float kContourStep = 1e-3F;    // m, per crossing and iteration
constexpr float kSteepest = 0.15F;       // least |E.N|: an edge nearly in the triangle's plane has no clear direction
constexpr float kSmoothing = 0.5F;

// The five vertices of a crossing, with the weights of the vector from the triangle's point to the edge's.
struct CrossingWeights {
    std::array<std::uint32_t, 5> vertices;
    std::array<float, 5> weights;
};

CrossingWeights weights_of(const Crossing& crossing, const ContactSurface& surface) {
    return {vertices_of(crossing, surface),
            {1 - crossing.along, crossing.along, -crossing.corners[0], -crossing.corners[1], -crossing.corners[2]}};
}

Vec3f cross_of(const ContactTriangle& triangle, const MovingPoints& points) {
    const Vec3f origin = points.at(triangle.vertices[0]);
    return (points.at(triangle.vertices[1]) - origin).cross(points.at(triangle.vertices[2]) - origin);
}

// The unit direction of the cut of a triangle beside the edge with the plane of normal N, pointing into the triangle;
// zero if they are parallel.
Vec3f cut_into(const ContactTriangle& beside, const std::array<std::uint32_t, 2>& ends, const Vec3f& along,
               const Vec3f& normal, const MovingPoints& points) {
    constexpr float kParallel = 1e-12F;  // m^2
    Vec3f cut = normal.cross(cross_of(beside, points));
    const float length = cut.norm();
    if (length < kParallel) return Vec3f::Zero();
    cut /= length;
    const auto apex =
        std::ranges::find_if(beside.vertices, [&](std::uint32_t v) { return v != ends[0] && v != ends[1]; });
    Vec3f inward = points.at(*apex) - points.at(ends[0]);
    inward -= along * inward.dot(along);
    return cut.dot(inward) < 0 ? Vec3f(-cut) : cut;
}

}  // namespace

void Untangler::separate(const ContactSurface& surface, std::span<const Crossing> crossings,
                         std::span<const Vec4f> clean, const MovingPoints& points) {
    clear(points.count);
    for (const Crossing& crossing : crossings) {
        const bool goes_back = !clean.empty() && rewind(crossing, surface, clean, points);
        if (!goes_back) shorten(crossing, surface, points);
    }
    apply(points, clean.empty() ? 2 * kContourStep : kLongestRewind);
}

bool Untangler::rewind(const Crossing& crossing, const ContactSurface& surface, std::span<const Vec4f> clean,
                       const MovingPoints& points) {
    constexpr float kShortest = 1e-7F;  // m
    const CrossingWeights at = weights_of(crossing, surface);
    Vec3f moved = Vec3f::Zero();
    for (std::size_t k = 0; k < 5; ++k) {
        moved += at.weights[k] * (points.at(at.vertices[k]) - clean[at.vertices[k]].head<3>());
    }
    const float way = moved.norm();
    if (way >= kRewindReach || way <= kShortest) return false;
    move_apart(crossing, surface, -kRewindShare * moved, points);
    return true;
}

// The edge moves by G = R - N (E.R) / (E.N), the triangle by -G. E is the direction of the edge, N the normal of the
// triangle, and R the sum of the cuts into the triangles beside the edge.
void Untangler::shorten(const Crossing& crossing, const ContactSurface& surface, const MovingPoints& points) {
    const ContactEdge& edge = surface.edges[crossing.edge];
    const Vec3f along = (points.at(edge.ends[1]) - points.at(edge.ends[0])).normalized();
    const Vec3f normal = cross_of(surface.triangles[crossing.triangle], points).normalized();
    Vec3f cuts = Vec3f::Zero();
    for (const std::uint32_t t : edge.triangles) {
        if (t != kNoElement) cuts += cut_into(surface.triangles[t], edge.ends, along, normal, points);
    }
    float steepness = along.dot(normal);
    if (std::abs(steepness) < kSteepest) steepness = std::copysign(kSteepest, steepness);
    const Vec3f direction = cuts - normal * (along.dot(cuts) / steepness);
    const float length = direction.norm();
    if (!(length > 1e-6F)) return;
    move_apart(crossing, surface, direction * (kContourStep / std::sqrt(1 + length * length)), points);
}

void Untangler::move_apart(const Crossing& crossing, const ContactSurface& surface, const Vec3f& move,
                           const MovingPoints& points) {
    const CrossingWeights at = weights_of(crossing, surface);
    float sum = 0;
    for (std::size_t k = 0; k < 5; ++k) sum += at.weights[k] * at.weights[k] * points.inverse_mass(at.vertices[k]);
    if (sum <= 0) return;
    for (std::size_t k = 0; k < 5; ++k) {
        add(at.vertices[k], move * (at.weights[k] * points.inverse_mass(at.vertices[k]) / sum));
    }
}

void Untangler::smooth(const ContactSurface& surface, std::span<const Crossing> crossings, const MovingPoints& points) {
    std::vector<bool> crumples(points.count, false);
    for (const Crossing& crossing : crossings) {
        for (const std::uint32_t v : vertices_of(crossing, surface)) crumples[v] = true;
    }
    clear(points.count);
    for (const ContactEdge& edge : surface.edges) {
        const auto [a, b] = edge.ends;
        if (!crumples[a] && !crumples[b]) continue;
        const Vec3f between = points.at(b) - points.at(a);
        if (crumples[a]) add(a, between);
        if (crumples[b]) add(b, -between);
    }
    for (const std::uint32_t v : touched_) {
        if (points.inverse_mass(v) > 0) points.shift(v, sums_[v] * (kSmoothing / static_cast<float>(counts_[v])));
    }
}

void Untangler::clear(std::size_t vertices) {
    sums_.assign(vertices, Vec3f::Zero());
    counts_.assign(vertices, 0);
    touched_.clear();
}

void Untangler::add(std::uint32_t vertex, const Vec3f& move) {
    if (counts_[vertex]++ == 0) touched_.push_back(vertex);
    sums_[vertex] += move;
}

// Between the sum and the mean: several crossings may ask for one movement, or each for a part of it.
void Untangler::apply(const MovingPoints& points, float longest) {
    for (const std::uint32_t v : touched_) {
        Vec3f move = sums_[v] / std::sqrt(static_cast<float>(counts_[v]));
        const float length = move.norm();
        if (length > longest) move *= longest / length;
        points.shift(v, move);
    }
}

}  // namespace selvedge::sim
