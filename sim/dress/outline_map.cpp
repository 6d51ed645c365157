#include "sim/dress/outline_map.h"

#include <cmath>

#include "sim/core/assert.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr int kSamples = 8;     // per edge
constexpr double kNear = 1e-9;  // m: closer than this is on the outline

std::vector<Vec2d> samples_of(const Panel& panel) {
    std::vector<Vec2d> points;
    for (const OutlineEdge& edge : panel.edges) {
        for (int i = 0; i < kSamples; ++i) points.push_back(outline_point(panel, edge, double(i) / kSamples));
    }
    return points;
}

// tan of half the angle from a to b. Infinite where they are opposite: u lies between them.
double half_tangent(const Vec2d& a, const Vec2d& b) {
    const double lengths = a.norm() * b.norm();
    return cross2(a, b) / (lengths + a.dot(b));
}

}  // namespace

OutlineMap::OutlineMap(const Panel& from, const Panel& to)
    : is_identity_(from.vertices == to.vertices && from.edges == to.edges) {
    SELVEDGE_ASSERT(from.edges.size() == to.edges.size());
    if (is_identity_) return;
    from_ = samples_of(from);
    to_ = samples_of(to);
}

Vec2d OutlineMap::operator()(const Vec2d& u) const {
    if (is_identity_) return u;
    const std::size_t count = from_.size();
    std::vector<double> tangents(count);  // of the angle at u between sample i and the next
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2d a = from_[i] - u;
        const Vec2d b = from_[(i + 1) % count] - u;
        const double along = a.norm() + b.norm();
        if (a.norm() < kNear) return to_[i];
        const double length = (b - a).norm();
        if (along - length < kNear * along) {  // on the side between them
            const double t = a.norm() / along;
            return (1 - t) * to_[i] + t * to_[(i + 1) % count];
        }
        tangents[i] = half_tangent(a, b);
    }
    Vec2d sum = Vec2d::Zero();
    double weights = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double weight = (tangents[(i + count - 1) % count] + tangents[i]) / (from_[i] - u).norm();
        sum += weight * to_[i];
        weights += weight;
    }
    const Vec2d mapped = sum / weights;
    return mapped.allFinite() ? mapped : u;
}

}  // namespace selvedge
