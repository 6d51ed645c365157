#pragma once
// The curve of an edge: a cubic from the normals at its ends, as in curved PN triangles (Vlachos et al. 2001), scaled
// by a modifier and stored as a Lagrange curve through four points.  (thesis figs. 6.1, 6.3)
//
//            L1 ------ L2           a at t = 0, L1 at 1/3, L2 at 2/3, b at 1
//          /              \         .
//        a                  b
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::render {

// How far the curve of an edge leaves its chord.  (thesis ch. 6, figs. 6.4, 6.5, 6.7)
//
// r = rest length / length of the chord. If r > 1, the edge is shorter than its material, so it must curve.

// The curve's offset from the chord is M times that given by the end normals; M = SoftCap(K0 + K1 r + K2 r^2 + K3 r^3).
struct CurveModifier {
    std::array<float, 4> k{1, 0, 0, 0};
    float soft_cap = 1;            // above 0; above it M grows only towards soft_cap + 1
    bool restores_length = false;  // instead: choose M so that the curve is as long as the material

    bool operator==(const CurveModifier&) const = default;
};

// The thesis' five presets, and Restore, which restores the length.
enum class SurfaceKind { Flat, Constant, Linear, Quadratic, Cubic, Restore };

inline constexpr const char* kSurfaceKindNames = "flat, constant, linear, quadratic, cubic, restore";
inline constexpr int kSurfaceKinds = 6;
std::optional<SurfaceKind> parse_surface_kind(std::string_view name);
const char* name(SurfaceKind kind);

CurveModifier curve_modifier(SurfaceKind kind);

// value if value <= cap, else cap + (value - cap) / value.  (thesis fig. 6.5)
float soft_cap(float value, float cap);

// M for the ratio r. Pre: modifier.restores_length is false.
float modified(const CurveModifier& modifier, float r);

// M for a curve whose arc is s0 times its chord at M = 1. For small offsets, arc / chord - 1 grows with M^2, so
// M = sqrt((r - 1) / (s0 - 1)). 0 if r <= 1; at most kMaxRestored.
float restoring(float r, float s0);
inline constexpr float kMaxRestored = 5;  // limit for nearly straight curves, whose s0 tends to 1

// The fourth component (w) of all vectors is 0.
struct CurveEnds {
    Vec4f a, b;                // m
    Vec4f normal_a, normal_b;  // unit
    float rest_length = 0;     // m
};

struct EdgeCurve {
    Vec4f a, l1, l2, b;                        // m
    Vec4f normal_a, normal_between, normal_b;  // control normals of a quadratic; unit
};

EdgeCurve make_edge_curve(const CurveEnds& ends, const CurveModifier& modifier);

// The same with given end tangents: P1 = (2A + B + va) / 3, P2 = (A + 2B + vb) / 3.
EdgeCurve bent_curve(const CurveEnds& ends, const Vec4f& va, const Vec4f& vb, const CurveModifier& modifier);

// Arc length / chord of the curve at M = 1, by three-point Gauss quadrature. va, vb: three times the offsets of the
// inner control points P1 and P2 from the chord, m.
float arc_over_chord(const Vec4f& chord, const Vec4f& va, const Vec4f& vb);

// The middle control normal, not normalized: the sum of the end normals, reflected at the plane perpendicular to the
// edge.  (Vlachos et al. 2001, 3.3)
Vec4f normal_between(const CurveEnds& ends);

// Weights of a curve's points and normals at t = i / 2^max_level.  (thesis table 6.1; Vlachos et al. 2001. Like theirs,
// the quadratic of normals has no factor 2 on the middle one: with it, normals are noisier and no more accurate.)
class CurveWeights {
 public:
    explicit CurveWeights(int max_level);

    const Vec4f& points(std::size_t i) const { return points_[i]; }    // of a, L1, L2, b
    const Vec4f& normals(std::size_t i) const { return normals_[i]; }  // of normal_a, normal_between, normal_b
    std::size_t steps() const { return points_.size() - 1; }           // 2^max_level

    Vec4f point(const EdgeCurve& curve, std::size_t i) const {
        const Vec4f& w = points_[i];
        return curve.a * w[0] + curve.l1 * w[1] + curve.l2 * w[2] + curve.b * w[3];
    }
    Vec4f normal(const EdgeCurve& curve, std::size_t i) const {
        const Vec4f& w = normals_[i];
        return (curve.normal_a * w[0] + curve.normal_between * w[1] + curve.normal_b * w[2]).normalized();
    }

 private:
    std::vector<Vec4f> points_, normals_;
};

// Weights of a, L1, L2, b at any t.
Vec4f lagrange_weights(double t);

}  // namespace selvedge::render
