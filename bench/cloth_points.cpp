#include "bench/cloth_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace selvedge {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kThickness = 0.03F;  // m, of the layer that the points stay in

struct MovingPoint {
    Vec3f x;
    Vec3f v = Vec3f::Zero();        // m/s
    Vec3f outward = Vec3f::Zero();  // at its last place
    float fall = 0;                 // m/s, towards the body
};

// Uniform 0..1 and normal numbers that are the same on every machine.
struct Random {
    std::mt19937 engine;
    float share() { return float(double(engine()) / 4294967296.0); }
    float normal() {
        float sum = -6;
        for (int i = 0; i < 12; ++i) sum += share();
        return sum;
    }
    Vec3f normals() {
        const float x = normal();
        const float y = normal();
        return {x, y, normal()};
    }
};

bool is_clad(const SurfaceBvh& surface, const Vec3f& p) {
    const float stature = surface.high().y() - surface.low().y();
    const float height = (p.y() - surface.low().y()) / stature;
    return height > 0.3F && height < 0.82F && std::abs(p.x()) < 0.2F * stature;
}

// Sums of the areas of clad triangles; the others add nothing.
std::vector<double> summed_areas(const SurfaceBvh& surface) {
    std::vector<double> sums;
    double sum = 0;
    const auto x = surface.points();
    for (const auto& [a, b, c] : surface.triangles()) {
        if (is_clad(surface, (x[a] + x[b] + x[c]) / 3)) sum += double((x[b] - x[a]).cross(x[c] - x[a]).norm());
        sums.push_back(sum);
    }
    return sums;
}

Vec3f random_point_over(const SurfaceBvh& surface, const std::vector<double>& areas, Random& random) {
    const double at = double(random.share()) * areas.back();
    const auto t = std::size_t(std::upper_bound(areas.begin(), areas.end(), at) - areas.begin());
    const auto [a, b, c] = surface.triangles()[std::min(t, areas.size() - 1)];
    const auto x = surface.points();
    const float u = std::sqrt(random.share());
    const float w = random.share();
    const Vec3f on = x[a] * (1 - u) + x[b] * (u * (1 - w)) + x[c] * (u * w);
    return on + (x[b] - x[a]).cross(x[c] - x[a]).stableNormalized() * (kThickness * random.share());
}

// Interleaves the bits of a point's place in cells of 4 mm (Morton), so that what is near in space is near in the list.
std::uint32_t place_in_order(const Vec3f& p) {
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cell = std::uint32_t(std::clamp((p[axis] + 2) * 250, 0.0F, 1023.0F));
        for (unsigned bit = 0; bit < 10; ++bit) code |= (cell >> bit & 1U) << (3 * bit + unsigned(axis));
    }
    return code;
}

std::vector<MovingPoint> start(const SurfaceBvh& surface, const ClothPointOptions& options, Random& random) {
    const std::vector<double> areas = summed_areas(surface);
    std::vector<MovingPoint> points;
    while (points.size() < std::size_t(options.points)) {
        const Vec3f p = random_point_over(surface, areas, random);
        const ClosestPoint closest = *surface.closest(p, kFar);
        if (closest.distance >= 0) points.push_back({.x = p, .outward = closest.normal});
    }
    std::sort(points.begin(), points.end(),
              [](const MovingPoint& a, const MovingPoint& b) { return place_in_order(a.x) < place_in_order(b.x); });
    for (MovingPoint& point : points) {
        point.v = random.normals() * (options.speed / std::sqrt(3.0F));
        point.fall = random.share() < 0.3F ? 1.5F * options.speed : 0.0F;
    }
    return points;
}

void move(MovingPoint& point, const ClothPointOptions& options, Random& random) {
    constexpr float kKept = 0.98F;
    const float fresh = options.speed / std::sqrt(3.0F) * std::sqrt(1 - kKept * kKept);
    point.v = point.v * kKept + random.normals() * fresh;
    point.x += (point.v - point.outward * point.fall) * options.substep;
    if (random.share() < 0.002F) point.x -= point.outward * (0.01F * random.share());
}

// Keeps the point in the layer between the offset and its thickness.
void hold(MovingPoint& point, const ClosestPoint& closest, float offset) {
    point.outward = closest.normal;
    const float outward_speed = point.v.dot(closest.normal);
    const bool is_in = closest.distance < offset;
    if (is_in) point.x = closest.point + closest.normal * offset;
    if (is_in && outward_speed < 0) point.v -= closest.normal * outward_speed;
    if (closest.distance > kThickness && outward_speed > 0) point.v -= closest.normal * (2 * outward_speed);
}

}  // namespace

ClothPoints move_cloth_points(const SurfaceBvh& surface, const ClothPointOptions& options) {
    Random random{std::mt19937(options.seed)};
    std::vector<MovingPoint> points = start(surface, options, random);
    ClothPoints path;
    double touches = 0;
    for (int step = 0; step < options.steps; ++step) {
        path.x.emplace_back();
        path.exact.emplace_back();
        for (MovingPoint& point : points) {
            move(point, options, random);
            const ClosestPoint closest = *surface.closest(point.x, kFar);
            path.x.back().push_back(point.x);
            path.exact.back().push_back(closest);
            touches += closest.distance < options.offset;
            hold(point, closest, options.offset);
        }
    }
    path.in_contact = touches / (double(options.steps) * double(options.points));
    return path;
}

}  // namespace selvedge
