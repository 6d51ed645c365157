#include "render/scene/solids.h"

#include <cmath>
#include <map>
#include <utility>

namespace selvedge {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct UnitBall {
    std::vector<Vec3f> x;
    Triangles triangles;
};

UnitBall icosahedron() {
    const float a = 0.52573111F, b = 0.85065081F;
    return {.x = {{-a, b, 0},
                  {a, b, 0},
                  {-a, -b, 0},
                  {a, -b, 0},
                  {0, -a, b},
                  {0, a, b},
                  {0, -a, -b},
                  {0, a, -b},
                  {b, 0, -a},
                  {b, 0, a},
                  {-b, 0, -a},
                  {-b, 0, a}},
            .triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                          {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                          {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

UnitBall cut_in_four(const UnitBall& ball) {
    UnitBall finer{.x = ball.x, .triangles = {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
        const auto [found, is_new] = middles.try_emplace(std::minmax(i, j), static_cast<std::uint32_t>(finer.x.size()));
        if (is_new) finer.x.push_back((ball.x[i] + ball.x[j]).normalized());
        return found->second;
    };
    for (const auto& [i, j, k] : ball.triangles) {
        const std::uint32_t ij = middle(i, j), jk = middle(j, k), ki = middle(k, i);
        finer.triangles.insert(finer.triangles.end(), {{i, ij, ki}, {j, jk, ij}, {k, ki, jk}, {ij, jk, ki}});
    }
    return finer;
}

const UnitBall& unit_ball(BallDetail detail) {
    static const UnitBall coarse = cut_in_four(icosahedron());
    static const UnitBall fine = cut_in_four(coarse);
    return detail == BallDetail::Coarse ? coarse : fine;
}

constexpr std::uint32_t kSides = 8;

// One point per side, about the path.
struct Ring {
    Vec3f centre;
    Vec3f along;   // unit
    Vec3f across;  // unit, of the first side
};

Vec3f any_across(const Vec3f& along) {
    const Vec3f axis = std::abs(along.y()) < 0.9F ? Vec3f::UnitY() : Vec3f::UnitX();
    return along.cross(axis).normalized();
}

// The ring's first side goes on from the last one's without a twist.
Vec3f carried_across(const Vec3f& across, const Vec3f& along) {
    const Vec3f flat = across - across.dot(along) * along;
    return flat.norm() > 1e-3F ? flat.normalized() : any_across(along);
}

std::vector<Vec3f> without_repeats(const std::vector<Vec3f>& path) {
    std::vector<Vec3f> points;
    for (const Vec3f& x : path) {
        if (points.empty() || (x - points.back()).norm() > 1e-7F) points.push_back(x);
    }
    return points;
}

std::vector<Ring> make_rings(const std::vector<Vec3f>& points) {
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3f before = i > 0 ? (points[i] - points[i - 1]).normalized() : Vec3f::Zero();
        const Vec3f after = i + 1 < points.size() ? (points[i + 1] - points[i]).normalized() : Vec3f::Zero();
        const Vec3f sum = before + after;
        const Vec3f along = sum.norm() > 1e-3F ? sum.normalized() : (i > 0 ? before : after);
        const Vec3f across = rings.empty() ? any_across(along) : carried_across(rings.back().across, along);
        rings.push_back({points[i], along, across});
    }
    return rings;
}

void add_ring(SolidItem& solid, const Ring& ring, float radius, const Rgb8& colour) {
    const Vec3f other = ring.along.cross(ring.across);
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const float angle = 6.2831853F * float(side) / float(kSides);
        const Vec3f normal = std::cos(angle) * ring.across + std::sin(angle) * other;
        solid.x.push_back(ring.centre + radius * normal);
        solid.normals.push_back(normal);
        solid.colours.push_back(colour);
    }
}

void join_rings(SolidItem& solid, std::uint32_t first, std::uint32_t second) {
    for (std::uint32_t side = 0; side < kSides; ++side) {
        const std::uint32_t next = (side + 1) % kSides;
        solid.triangles.push_back({first + side, first + next, second + side});
        solid.triangles.push_back({first + next, second + next, second + side});
    }
}

// Without ends: nothing is seen of them where lines are thin.
void add_pipe(SolidItem& solid, const std::vector<Vec3f>& points, float radius, const Rgb8& colour) {
    const auto first = static_cast<std::uint32_t>(solid.x.size());
    const std::vector<Ring> rings = make_rings(points);
    for (const Ring& ring : rings) add_ring(solid, ring, radius, colour);
    for (std::uint32_t i = 1; i < rings.size(); ++i) join_rings(solid, first + (i - 1) * kSides, first + i * kSides);
}

}  // namespace

void add_ball(SolidItem& solid, const Vec3f& centre, float radius, const Rgb8& colour, BallDetail detail) {
    const UnitBall& ball = unit_ball(detail);
    const auto first = static_cast<std::uint32_t>(solid.x.size());
    for (const Vec3f& normal : ball.x) {
        solid.x.push_back(centre + radius * normal);
        solid.normals.push_back(normal);
        solid.colours.push_back(colour);
    }
    for (const auto& [i, j, k] : ball.triangles) solid.triangles.push_back({first + i, first + j, first + k});
}

void add_tube(SolidItem& solid, const std::vector<Vec3f>& path, float radius, const Rgb8& colour) {
    const std::vector<Vec3f> points = without_repeats(path);
    if (points.size() < 2) return;
    add_pipe(solid, points, radius, colour);
    add_ball(solid, points.front(), radius, colour, BallDetail::Coarse);
    add_ball(solid, points.back(), radius, colour, BallDetail::Coarse);
}

void add_rod(SolidItem& solid, const Vec3f& from, const Vec3f& to, float radius, const Rgb8& colour) {
    if ((to - from).norm() > 1e-7F) add_pipe(solid, {from, to}, radius, colour);
}

void add_outline(SolidItem& solid, const std::array<Vec3f, 3>& triangle, float radius, const Rgb8& colour) {
    for (std::size_t i = 0; i < 3; ++i) add_rod(solid, triangle[i], triangle[(i + 1) % 3], radius, colour);
}

}  // namespace selvedge
