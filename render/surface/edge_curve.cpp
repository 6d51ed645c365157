#include "render/surface/edge_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

constexpr float kShortest = 1e-12F;  // m^2, squared length: shorter edges have no curve

Vec4f with_length_one(const Vec4f& v, const Vec4f& otherwise) {
    const float squared = v.squaredNorm();
    return squared > kShortest ? Vec4f(v / std::sqrt(squared)) : otherwise;
}

}  // namespace

float arc_over_chord(const Vec4f& chord, const Vec4f& va, const Vec4f& vb) {
    // Offset of the curve from the chord: va t (1-t)^2 + vb t^2 (1-t). `speed` is the curve's derivative.
    constexpr float kAway = 0.38729833F;  // sqrt(3/5) / 2
    constexpr float kOuter = 5.0F / 18, kMiddle = 8.0F / 18;
    const auto speed = [&](float t) { return (chord + va * (1 + t * (3 * t - 4)) + vb * (t * (2 - 3 * t))).norm(); };
    return (kOuter * (speed(0.5F - kAway) + speed(0.5F + kAway)) + kMiddle * speed(0.5F)) / chord.norm();
}

Vec4f normal_between(const CurveEnds& ends) {
    const Vec4f d = ends.b - ends.a, sum = ends.normal_a + ends.normal_b;
    const float squared = d.squaredNorm();
    return squared > kShortest ? Vec4f(sum - d * (2 * d.dot(sum) / squared)) : sum;
}

namespace {

// With va = -(d.nA) nA and vb = (d.nB) nB the Bezier control points are P1 = (2A + B + va) / 3 and
// P2 = (A + 2B + vb) / 3; at t = 1/3 and 2/3 the curve leaves the chord by (4 va + 2 vb) / 27 and (2 va + 4 vb) / 27.
// Called for each root edge in each frame: inlined into both callers.
[[gnu::always_inline]] inline EdgeCurve bend(const CurveEnds& ends, const Vec4f& va, const Vec4f& vb,
                                             const CurveModifier& modifier) {
    const Vec4f d = ends.b - ends.a;
    const float squared = d.squaredNorm();
    float m = 0;
    if (squared > kShortest) {
        const float r = ends.rest_length / std::sqrt(squared);
        m = modifier.restores_length ? restoring(r, arc_over_chord(d, va, vb)) : modified(modifier, r);
    }
    const Vec4f third = d / 3.0F;
    EdgeCurve curve;
    curve.a = ends.a;
    curve.l1 = ends.a + third + (2 * va + vb) * (m * 2 / 27);
    curve.l2 = ends.b - third + (va + 2 * vb) * (m * 2 / 27);
    curve.b = ends.b;
    curve.normal_a = ends.normal_a;
    curve.normal_between = with_length_one(normal_between(ends), ends.normal_a);
    curve.normal_b = ends.normal_b;
    return curve;
}

}  // namespace

EdgeCurve make_edge_curve(const CurveEnds& ends, const CurveModifier& modifier) {
    const Vec4f d = ends.b - ends.a;
    return bend(ends, ends.normal_a * -d.dot(ends.normal_a), ends.normal_b * d.dot(ends.normal_b), modifier);
}

EdgeCurve bent_curve(const CurveEnds& ends, const Vec4f& va, const Vec4f& vb, const CurveModifier& modifier) {
    return bend(ends, va, vb, modifier);
}

Vec4f lagrange_weights(double t) {
    const double a = 3 * t - 1, b = 3 * t - 2, c = t - 1;
    return Eigen::Vector4d(-a * b * c / 2, 9 * t * b * c / 2, -9 * t * a * c / 2, t * a * b / 2).cast<float>();
}

CurveWeights::CurveWeights(int max_level) {
    SELVEDGE_ASSERT(max_level >= 0 && max_level <= 15);
    const int steps = 1 << max_level;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        points_.push_back(lagrange_weights(t));
        normals_.push_back(Eigen::Vector4d((1 - t) * (1 - t), t * (1 - t), t * t, 0).cast<float>());
    }
}

namespace {

constexpr std::array<std::pair<const char*, CurveModifier>, kSurfaceKinds> kPresets{
    {{"flat", {.k = {0, 0, 0, 0}}},
     {"constant", {.k = {1, 0, 0, 0}}},
     {"linear", {.k = {0, 1, 0, 0}}},
     {"quadratic", {.k = {0, 0, 1, 0}}},
     {"cubic", {.k = {0, 0, 0, 1}}},
     {"restore", {.k = {0, 0, 0, 0}, .restores_length = true}}}};

const auto& preset(SurfaceKind kind) {
    return kPresets[static_cast<std::size_t>(kind)];
}

}  // namespace

std::optional<SurfaceKind> parse_surface_kind(std::string_view name) {
    for (std::size_t i = 0; i < kPresets.size(); ++i) {
        if (kPresets[i].first == name) return static_cast<SurfaceKind>(i);
    }
    return std::nullopt;
}

const char* name(SurfaceKind kind) {
    return preset(kind).first;
}

CurveModifier curve_modifier(SurfaceKind kind) {
    return preset(kind).second;
}

float soft_cap(float value, float cap) {
    return value <= cap ? value : cap + (value - cap) / value;
}

float modified(const CurveModifier& modifier, float r) {
    SELVEDGE_ASSERT(!modifier.restores_length);
    const auto& [k0, k1, k2, k3] = modifier.k;
    return soft_cap(k0 + r * (k1 + r * (k2 + r * k3)), modifier.soft_cap);
}

float restoring(float r, float s0) {
    const float lacking = r - 1, given = s0 - 1;
    if (lacking <= 0) return 0;
    if (lacking >= kMaxRestored * kMaxRestored * given) return kMaxRestored;
    return std::sqrt(lacking / given);
}

}  // namespace selvedge::render
